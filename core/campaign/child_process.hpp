#pragma once
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/campaign/task_queue.hpp"

namespace asperity {

/// A process of ours, in a process group of its own, so that a terminal's Ctrl-C reaches it only through us. It gets
/// SIGTERM when this process dies, however it dies; to the system that is when the thread ends that made it.
class ChildProcess {
 public:
  /// Starts the task; its stdin is empty. A command that cannot be started ends with 127, as in a shell, and its log
  /// says why. Throws Error(output) where the log cannot be opened, Error(unexpected) where there is no process to be
  /// had.
  explicit ChildProcess(const Task& task);

  /// Tells a process that is still at work to end, and waits for it.
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// How it ended; nothing while it is at work.
  std::optional<TaskEnd> poll();

  /// Sends SIGTERM, on which a run writes a checkpoint and ends.
  void tell_to_end() const;

 private:
  pid_t process_;  ///< -1: none, or ended and seen.
};

/// What a command printed, and how it ended.
struct CommandResult {
  TaskEnd end;
  std::string out, err;
};

/// Runs a short command found on the PATH to its end; after `seconds` it is killed.
CommandResult run_command_to_end(const std::vector<std::string>& command, double seconds);

/// Where on the PATH the program lies; nothing if it does not.
std::optional<std::filesystem::path> find_program(const std::string& name);

}  // namespace asperity
