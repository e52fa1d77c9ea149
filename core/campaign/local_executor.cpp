#include "core/campaign/local_executor.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "core/campaign/child_process.hpp"

namespace asperity {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{20};  // the shortest run takes ten times as long

struct Worker {
  std::size_t task;
  ChildProcess process;
};

std::size_t workers_for(int jobs) {
  return jobs > 0 ? static_cast<std::size_t>(jobs) : std::max(1u, std::thread::hardware_concurrency());
}

void tell_to_end(const std::vector<Worker>& workers) {
  for (const Worker& worker : workers) worker.process.tell_to_end();
}

void collect(std::vector<Worker>& workers, const TaskQueue& queue) {
  std::vector<Worker> left;
  for (Worker& worker : workers) {
    if (const auto end = worker.process.poll()) {
      queue.ended(worker.task, *end);
    } else {
      left.push_back(std::move(worker));
    }
  }
  workers = std::move(left);
}

void start(std::size_t task, std::vector<Worker>& workers, const TaskQueue& queue) {
  workers.push_back({task, ChildProcess(queue.task(task))});
  queue.started(task);
}

}  // namespace

void run_locally(const TaskQueue& queue, int jobs) {
  const std::size_t most = workers_for(jobs);
  std::vector<Worker> workers;
  std::size_t next = 0;
  bool told = false;
  for (;;) {
    const bool ending = queue.interrupted();
    if (ending && !std::exchange(told, true)) tell_to_end(workers);
    collect(workers, queue);
    while (!ending && next < queue.size && workers.size() < most) start(next++, workers, queue);
    queue.tick();
    if (workers.empty() && (ending || next == queue.size)) return;
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

}  // namespace asperity
