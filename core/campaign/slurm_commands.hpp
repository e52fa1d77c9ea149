#pragma once
#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/campaign/slurm_config.hpp"

/// Slurm's commands, as found on the PATH. A command that is refused throws Error(config) with Slurm's own words; one
/// that gets no answer from a controller that is away says so by an empty result, and may be asked again.
namespace asperity {

/// One task of an array, as Slurm numbers it.
struct SlurmTaskId {
  std::int64_t job = 0;
  int index = 0;
  auto operator<=>(const SlurmTaskId&) const = default;
};

/// An array to be submitted.
struct SlurmArray {
  std::string name;              ///< Of the job; all arrays of one campaign share it.
  std::filesystem::path script;  ///< Run once for each task, with SLURM_ARRAY_TASK_ID from 0.
  std::filesystem::path folder;  ///< For what Slurm itself prints, task_N.out.
  std::size_t size = 0;
  int at_once = 0;  ///< 0: as many as Slurm starts.
};

/// Throws Error(config) where sbatch, squeue or scancel is not on the PATH.
void require_slurm();

/// Submits by sbatch; the number of the job.
std::int64_t submit_array(const SlurmArray& array, const SlurmConfig& config);

/// Tasks of all jobs of this name that squeue lists, each with whether it is at work; nothing where it has no answer.
std::optional<std::map<SlurmTaskId, bool>> queued_tasks(const std::string& name);

/// What accounting says of a task that has ended, e.g. "OUT_OF_MEMORY"; empty where there is no accounting.
std::string accounted_state(const SlurmTaskId& task);

/// Takes the tasks that wait out of the queue, and sends SIGTERM to the scripts of those at work.
void cancel_tasks(const std::string& name);

/// Takes all tasks out of the queue, those at work without further ado.
void kill_tasks(const std::string& name);

}  // namespace asperity
