#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/file_descriptor.hpp"
#include "core/campaign/task_queue.hpp"

namespace asperity {

/// The files of one campaign's array jobs. Its name is the name of the jobs; as long as the campaign lives it is
/// locked, so what a killed one left can be told from what a living one needs.
class SlurmFolder {
 public:
  /// Makes a folder of a new name in `parent`. Throws Error(output).
  explicit SlurmFolder(const std::filesystem::path& parent);
  /// Removes the folder with all files.
  ~SlurmFolder();
  SlurmFolder(const SlurmFolder&) = delete;
  SlurmFolder& operator=(const SlurmFolder&) = delete;

  const std::string& name() const { return name_; }

  /// Writes the scripts of one array's tasks into a folder of its own and returns that folder. Throws Error(output).
  std::filesystem::path write_array(const std::vector<Task>& tasks);

 private:
  std::filesystem::path folder_;
  std::string name_;
  FileDescriptor lock_;
  int arrays_ = 0;
};

/// Script of the array in the folder that write_array() returned.
std::filesystem::path array_script(const std::filesystem::path& array);

/// The exit code that the task has left; nothing as long as there is none.
std::optional<int> left_exit_code(const std::filesystem::path& array, int index);

/// Folders in `parent` whose campaigns were killed. The file name of each is the name of its jobs.
std::vector<std::filesystem::path> abandoned_folders(const std::filesystem::path& parent);

}  // namespace asperity
