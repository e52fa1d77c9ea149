#pragma once
#include <string>
#include <vector>

namespace asperity {

/// What Slurm is asked for; each run is one task with one processor. Empty and 0: what the cluster has by default.
struct SlurmConfig {
  std::string partition;
  std::string account;
  int time_limit_min = 0;  ///< Of one task; a run that reaches it is put in again and goes on from its checkpoint.
  int memory_mb = 0;       ///< Of one task.
  int max_tasks = 0;       ///< Running at once; 0: as many as Slurm starts.
  std::vector<std::string> extra_arguments;  ///< For sbatch, as they are.
  double poll_interval_s = 10;               ///< Between two looks at the queue.
  double lost_after_s = 60;  ///< A task that is not in the queue and left no exit code is lost after this time: shared
                             ///< file systems show new files late.
  int resubmissions = 3;     ///< A task that is lost or ended early is put in again so many times at most.
};

}  // namespace asperity
