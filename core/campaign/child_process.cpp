#include "core/campaign/child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <sstream>
#include <thread>
#include <utility>

#include "core/base/error.hpp"
#include "core/base/file_descriptor.hpp"

namespace asperity {
namespace {

constexpr int kCannotStart = 127;  // as in a shell
constexpr int kSignalBase = 128;

std::vector<char*> arguments_of(std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return arguments;
}

/// In the new process, until it becomes another program: only calls that are safe after a fork in a threaded process.
[[noreturn]] void become(char* const* arguments, int out, int err, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(kInterrupted);  // the parent died before it could be watched
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  ::execvp(arguments[0], arguments);
  const char* reason = std::strerror(errno);
  for (const char* part : {"error: ", static_cast<const char*>(arguments[0]), " cannot be started: ", reason, "\n"}) {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, part, std::strlen(part));
  }
  ::_exit(kCannotStart);
}

pid_t start(std::vector<std::string> command, int out, int err) {
  const std::vector<char*> arguments = arguments_of(command);
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process == 0) become(arguments.data(), out, err, parent);
  if (process > 0) return process;
  throw Error(ErrorKind::unexpected, command[0] + ": no process can be started: " + std::strerror(errno));
}

TaskEnd end_of(int status) {
  if (WIFEXITED(status)) return {WEXITSTATUS(status), ""};
  const int number = WTERMSIG(status);
  const char* name = ::sigabbrev_np(number);
  return {kSignalBase + number, std::string("killed by signal SIG") + (name == nullptr ? "?" : name)};
}

/// Nothing while the process is at work.
std::optional<TaskEnd> reap(pid_t process, int flags) {
  int status = 0;
  pid_t seen = 0;
  do seen = ::waitpid(process, &status, flags);
  while (seen < 0 && errno == EINTR);
  if (seen == process) return end_of(status);
  if (seen < 0) return TaskEnd{kSignalBase, "its end was not seen"};
  return std::nullopt;
}

using TemporaryFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

TemporaryFile temporary_file() {
  TemporaryFile file(std::tmpfile(), std::fclose);
  if (file) return file;
  throw Error(ErrorKind::output, std::string("no temporary file can be made: ") + std::strerror(errno));
}

std::string content_of(std::FILE* file) {
  std::string text;
  std::array<char, 4096> part;
  std::rewind(file);
  for (std::size_t got = 0; (got = std::fread(part.data(), 1, part.size(), file)) > 0;) text.append(part.data(), got);
  return text;
}

TaskEnd wait_at_most(pid_t process, double seconds) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < deadline) {
    if (const auto end = reap(process, WNOHANG)) return *end;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ::kill(process, SIGKILL);
  reap(process, 0);
  return {kSignalBase + SIGKILL, "gave no answer in time"};
}

}  // namespace

ChildProcess::ChildProcess(const Task& task) : process_(-1) {
  const FileDescriptor log(task.log, O_WRONLY | O_CREAT | O_APPEND);
  process_ = start(task.command, log.get(), log.get());
}

ChildProcess::~ChildProcess() {
  if (process_ < 0) return;
  tell_to_end();
  reap(process_, 0);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept : process_(std::exchange(other.process_, -1)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(process_, other.process_);
  return *this;
}

std::optional<TaskEnd> ChildProcess::poll() {
  const std::optional<TaskEnd> end = reap(process_, WNOHANG);
  if (end) process_ = -1;
  return end;
}

void ChildProcess::tell_to_end() const { ::kill(process_, SIGTERM); }

CommandResult run_command_to_end(const std::vector<std::string>& command, double seconds) {
  const TemporaryFile out = temporary_file(), err = temporary_file();
  const TaskEnd end = wait_at_most(start(command, ::fileno(out.get()), ::fileno(err.get())), seconds);
  return {end, content_of(out.get()), content_of(err.get())};
}

std::optional<std::filesystem::path> find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path program = std::filesystem::path(folder) / name;
    if (::access(program.c_str(), X_OK) == 0 && std::filesystem::is_regular_file(program)) return program;
  }
  return std::nullopt;
}

}  // namespace asperity
