#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/experiment/checkpoint.hpp"

namespace asperity {

/// A run's two checkpoints, state_0.bin and state_1.bin, written in turn: a damaged one leaves the one before it.
class CheckpointPair {
 public:
  CheckpointPair(std::filesystem::path folder, std::string config_hash);

  bool any() const;  ///< Whether there is a file of either.

  /// Writes over the older one. Throws an output error; the newer one stays.
  void write(const Model& model, const RunState& state);

  /// Brings a freshly built model and its state to the newest checkpoint that can be used, and returns what is wrong
  /// with the other. Throws an output error that lists every fault where none can be used; nothing is changed then.
  std::vector<Fault> read(Model& model, RunState& state);

  void remove();  ///< Both files, once the run needs them no more.

  struct Saved {
    std::filesystem::path file;
    std::int64_t step = 0;
  };
  /// The checkpoint last written or read.
  std::optional<Saved> newest() const;

 private:
  std::filesystem::path file(int slot) const;
  std::filesystem::path folder_;
  std::string config_hash_;
  int newest_ = -1;  ///< 0 or 1; -1: none yet.
  std::int64_t newest_step_ = 0;
};

}  // namespace asperity
