#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace asperity {

/// One process to be made: a command with its arguments, and the file that its stdout and stderr are appended to. All
/// paths are absolute.
struct Task {
  std::vector<std::string> command;
  std::filesystem::path log;
};

/// How a task's process ended.
struct TaskEnd {
  int exit_code = 0;   ///< 128 + the signal that killed it.
  std::string reason;  ///< What the executor knows beyond the log, e.g. the signal; else empty.
};

/// Exit code of a run that was interrupted and left a checkpoint.
inline constexpr int kInterrupted = 130;

/// What an executor is given: tasks by number, and whom to tell. Every member is called from the executor's own thread.
struct TaskQueue {
  std::size_t size = 0;
  std::function<Task(std::size_t)> task;     ///< Asked each time before a task is put in: what is to be done now.
  std::function<void(std::size_t)> started;  ///< Its process is at work.
  std::function<void(std::size_t)> stopped;  ///< Its process has ended early and is to be put in again.
  std::function<void(std::size_t, const TaskEnd&)> ended;
  std::function<bool()> interrupted;  ///< True from then on: tasks at work are told to end, no other is put in.
  std::function<void()> tick;         ///< Called at every look, several times a second.
};

}  // namespace asperity
