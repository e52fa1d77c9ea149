#pragma once
#include "core/campaign/task_queue.hpp"

namespace asperity {

/// Works the queue off in processes of this machine, `jobs` at once (0: one a core), in its order.
void run_locally(const TaskQueue& queue, int jobs);

}  // namespace asperity
