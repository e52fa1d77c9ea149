#pragma once
#include <string>

#include "core/experiment/run.hpp"

namespace asperity {

/// Why a state that was read cannot be one of this freshly built model, or nothing where it can: every list has its
/// size, every index leads into its list, and what steers the run is a number in its range. A checksum says only that
/// the bytes are the writer's, not that they are a state.
std::string contradiction(const Model& fresh, const System& read, const RunState& state);

}  // namespace asperity
