#include "app/result_folder.hpp"

#include "core/base/atomic_file.hpp"
#include "core/base/output_error.hpp"
#include "core/config/read_config.hpp"

namespace asperity::app {

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw output_error(folder, "cannot be created", error.value());
}

void make_folder_with_config(const std::filesystem::path& folder, const std::filesystem::path& config) {
  make_folder(folder);
  write_file_atomically(folder / "config.original.json", read_config_text(config));
}

}  // namespace asperity::app
