#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "core/experiment/run.hpp"

namespace asperity {

/// Everything a test remembers: a line with the version, a checksum of what follows, the configuration's hash, the
/// state.
std::string checkpoint_bytes(const Model& model, const RunState& state, const std::string& config_hash);

/// Brings a freshly built model and its state to the checkpoint's. Throws an output error that names `file` where the
/// bytes are torn, were written by another version, or belong to another configuration or mesh; nothing is changed
/// then.
void read_checkpoint_bytes(std::string_view bytes, const std::filesystem::path& file, Model& model, RunState& state,
                           const std::string& config_hash);

/// Writes the bytes beside the old checkpoint and then over it. Throws an output error; the old one stays.
void write_checkpoint(const std::filesystem::path& file, const Model& model, const RunState& state,
                      const std::string& config_hash);

/// read_checkpoint_bytes() of a file; also throws where it cannot be read.
void read_checkpoint(const std::filesystem::path& file, Model& model, RunState& state, const std::string& config_hash);

}  // namespace asperity
