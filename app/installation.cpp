#include "app/installation.hpp"

#include "core/base/output_error.hpp"

namespace asperity::app {

std::filesystem::path this_executable() {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw output_error("/proc/self/exe", "cannot be read", error.value());
  return path;
}

std::filesystem::path shipped(const std::filesystem::path& name) {
  std::error_code ignored;
  if (name.is_absolute() || std::filesystem::exists(name, ignored)) return name;
  const std::filesystem::path prefix = this_executable().parent_path().parent_path();
  const std::filesystem::path installed = prefix / "share" / kSharedFolder / name;
  return std::filesystem::exists(installed, ignored) ? installed : name;
}

}  // namespace asperity::app
