#pragma once
#include <filesystem>

#include "core/campaign/slurm_commands.hpp"
#include "core/campaign/task_queue.hpp"

namespace asperity {

/// Works the queue off in array jobs of Slurm, which are followed by squeue. Each task leaves its exit code in a file
/// of its own below `folder`, which every node must see, so no accounting is needed; where there is some, it names why
/// a task left none. A task that is lost (its node died) or ended early (time limit, preemption) is put in again, up to
/// config.resubmissions times. Interrupted, tasks that wait are taken out of the queue and those at work told to end.
///
/// Jobs that a campaign left in the queue when it was killed are told to end first. Throws as submit_array().
void run_on_slurm(const TaskQueue& queue, const SlurmConfig& config, const std::filesystem::path& folder);

}  // namespace asperity
