#include "core/experiment/checkpoint_pair.hpp"

namespace asperity {

CheckpointPair::CheckpointPair(std::filesystem::path folder, std::string config_hash)
    : folder_(std::move(folder)), config_hash_(std::move(config_hash)) {}

std::filesystem::path CheckpointPair::file(int slot) const {
  return folder_ / ("state_" + std::to_string(slot) + ".bin");
}

bool CheckpointPair::any() const { return std::filesystem::exists(file(0)) || std::filesystem::exists(file(1)); }

void CheckpointPair::write(const Model& model, const RunState& state) {
  const int slot = newest_ == 0 ? 1 : 0;
  write_checkpoint(file(slot), model, state, config_hash_);
  newest_ = slot;
  newest_step_ = model.system.step;
}

std::vector<Fault> CheckpointPair::read(Model& model, RunState& state) {
  const Model fresh_model = model;
  const RunState fresh_state = state;
  std::vector<Fault> faults;
  for (const int slot : {0, 1}) {
    if (!std::filesystem::exists(file(slot))) continue;
    Model candidate = fresh_model;
    RunState candidate_state = fresh_state;
    try {
      read_checkpoint(file(slot), candidate, candidate_state, config_hash_);
    } catch (const Error& refused) {
      faults.insert(faults.end(), refused.faults().begin(), refused.faults().end());
      continue;
    }
    if (newest_ >= 0 && candidate.system.step <= newest_step_) continue;
    newest_ = slot;
    newest_step_ = candidate.system.step;
    model = std::move(candidate);
    state = std::move(candidate_state);
  }
  if (newest_ < 0) throw Error(ErrorKind::output, faults);
  return faults;
}

void CheckpointPair::remove() {
  std::error_code left_behind;  // no harm: the next run clears them
  for (const int slot : {0, 1}) {
    std::filesystem::remove(file(slot), left_behind);
    std::filesystem::remove(file(slot) += ".tmp", left_behind);
  }
  newest_ = -1;
}

std::optional<CheckpointPair::Saved> CheckpointPair::newest() const {
  if (newest_ < 0) return std::nullopt;
  return Saved{file(newest_), newest_step_};
}

}  // namespace asperity
