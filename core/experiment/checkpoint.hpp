#pragma once
#include <filesystem>
#include <string>

#include "core/experiment/run.hpp"

namespace asperity {

/// Writes everything a test remembers, beside the old checkpoint and then over it. Throws an output error.
void write_checkpoint(const std::filesystem::path& file, const Model& model, const RunState& state,
                      const std::string& config_hash);

/// Brings a freshly built model and its state to the checkpoint's. Throws an output error where the file is torn, was
/// written by another version, or belongs to another configuration; nothing is changed then.
void read_checkpoint(const std::filesystem::path& file, Model& model, RunState& state, const std::string& config_hash);

}  // namespace asperity
