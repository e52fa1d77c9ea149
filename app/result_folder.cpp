#include "app/result_folder.hpp"

#include <algorithm>
#include <optional>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/base/output_error.hpp"
#include "core/config/read_config.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

void remove_result(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error) throw output_error(path, "cannot be removed", error.value());
}

/// Whether a study has left numbers there; folders and pages may be anybody's.
bool has_results(const StudyFolder& study) {
  return std::any_of(study.results.begin(), study.results.end(), [&](const std::string& name) {
    return name.ends_with(".json") && fs::exists(study.folder / name);
  });
}

}  // namespace

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw output_error(folder, "cannot be created", error.value());
}

Manifest begin_study(const StudyFolder& study, const fs::path& config, ExistingRun existing) {
  const fs::path path = study.folder / "manifest.json";
  const std::optional<Manifest> before = find_manifest(path);
  if (!before && has_results(study))
    throw Error(ErrorKind::output, {{study.folder.string(), "holds results without a manifest that says of what", "",
                                     "", "choose another folder with --out, or remove them by hand"}});
  if (before && before->config_hash != study.config_hash) {
    if (existing == ExistingRun::keep)
      throw Error(ErrorKind::output,
                  {{study.folder.string(), "holds results of another configuration or of other data",
                    before->config_name, "", "choose another folder with --out, or replace them with --force"}});
    for (const std::string& name : study.results) remove_result(study.folder / name);
  }
  make_folder_with_config(study.folder, config);
  Manifest manifest = started_manifest();
  manifest.config_name = study.config_name;
  manifest.config_hash = study.config_hash;
  write_manifest(path, manifest);
  return manifest;
}

void make_folder_with_config(const std::filesystem::path& folder, const std::filesystem::path& config) {
  make_folder(folder);
  write_file_atomically(folder / "config.original.json", read_config_text(config));
}

}  // namespace asperity::app
