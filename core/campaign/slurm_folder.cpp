#include "core/campaign/slurm_folder.hpp"

#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>

#include "core/base/atomic_file.hpp"
#include "core/base/output_error.hpp"
#include "core/base/sha256.hpp"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLock = "lock";
constexpr const char* kArrayScript = "array.sh";

/// For the shell.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string task_file(int index, const char* ending) { return "task_" + std::to_string(index) + ending; }

/// What the task's shell does after the run is at work. It waits instead of becoming the run: so signals reach the run,
/// and its exit code is left in a file even where Slurm keeps no accounts. A signal ends `wait` while the run still
/// writes its checkpoint, so it is called again; 127 is its answer for a run that it has told of already.
constexpr const char* kWaitForRun = R"(run=$!
[ -z "$told" ] || kill -TERM "$run"
wait "$run"
code=$?
while [ -n "$told" ]; do
  told=
  wait "$run"
  again=$?
  [ "$again" = 127 ] || code=$again
done
)";

std::string task_script(const Task& task, const fs::path& exit_file) {
  std::string command;
  for (const std::string& word : task.command) command += quoted(word) + " ";
  const std::string file = quoted(exit_file.string()), beside = quoted(exit_file.string() + ".tmp");
  return "#!/bin/sh\ntold= run=\ntrap 'told=yes; [ -z \"$run\" ] || kill -TERM \"$run\" 2>/dev/null' TERM INT\n" +
         command + ">> " + quoted(task.log.string()) + " 2>&1 &\n" + kWaitForRun + "echo \"$code\" > " + beside +
         " && mv " + beside + " " + file + "\nexit \"$code\"\n";
}

std::string new_name(const fs::path& parent) {
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  const std::string unique = parent.string() + " " + std::to_string(::getpid()) + " " + std::to_string(now);
  return "asperity_" + sha256_hex(unique).substr(0, 12);
}

void make_folders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw output_error(folder, "cannot be created", error.value());
}

FileDescriptor locked(const fs::path& folder) {
  make_folders(folder);
  FileDescriptor lock(folder / kLock, O_RDWR | O_CREAT);
  if (::flock(lock.get(), LOCK_EX | LOCK_NB) != 0) throw output_error(lock.path(), "cannot be locked", errno);
  return lock;
}

bool is_abandoned(const fs::path& folder) {
  if (!fs::exists(folder / kLock)) return false;
  const FileDescriptor lock(folder / kLock, O_RDWR);
  return ::flock(lock.get(), LOCK_EX | LOCK_NB) == 0;
}

}  // namespace

SlurmFolder::SlurmFolder(const fs::path& parent)
    : folder_(parent / new_name(parent)), name_(folder_.filename().string()), lock_(locked(folder_)) {}

SlurmFolder::~SlurmFolder() {
  std::error_code ignored;  // what stays lies unlocked, and the next campaign removes it
  fs::remove_all(folder_, ignored);
}

fs::path SlurmFolder::write_array(const std::vector<Task>& tasks) {
  const fs::path array = folder_ / ("array_" + std::to_string(arrays_++));
  make_folders(array);
  for (int i = 0; i < static_cast<int>(tasks.size()); ++i) {
    write_file_atomically(array / task_file(i, ".sh"), task_script(tasks[i], array / task_file(i, ".exit")));
  }
  write_file_atomically(array_script(array),
                        "#!/bin/sh\nexec /bin/sh " + quoted(array.string()) + "/task_\"${SLURM_ARRAY_TASK_ID}\".sh\n");
  return array;
}

fs::path array_script(const fs::path& array) { return array / kArrayScript; }

std::optional<int> left_exit_code(const fs::path& array, int index) {
  std::ifstream file(array / task_file(index, ".exit"));
  int code = 0;
  if (!(file >> code)) return std::nullopt;
  return code;
}

std::vector<fs::path> abandoned_folders(const fs::path& parent) {
  std::vector<fs::path> folders;
  std::error_code none;  // no campaign of this store has used Slurm yet
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, none))
    if (is_abandoned(entry.path())) folders.push_back(entry.path());
  return folders;
}

}  // namespace asperity
