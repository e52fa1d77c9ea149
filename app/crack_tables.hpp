#pragma once
#include "core/experiment/model.hpp"
#include "core/output/run_folder.hpp"

namespace asperity::app {

/// Writes cracks.csv, events.csv and fragments.csv of a model's present state. Throws Error(output).
void write_crack_tables(const RunFolder& folder, const Model& model);

}  // namespace asperity::app
