#include "core/output/run_files.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/output_error.hpp"
#include "core/output/run_folder.hpp"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kSubfolders{"fields", "cracks", "contacts", "frames", "plots", "checkpoint"};

std::string plot_pattern() {
  std::string names;
  for (const std::string_view name : kPlotNames) names += (names.empty() ? "" : "|") + std::string(name);
  return "plots/(" + names + ")\\.(png|svg|csv)";
}

const std::regex& run_file_pattern() {
  // A ".tmp" is what an atomic write leaves behind when the machine goes down in the middle.
  static const std::regex pattern(
      "(config\\.(original|effective)\\.json|manifest\\.json|summary\\.json|log\\.txt|report\\.html"
      "|(curves|energy|cracks|events|fragments|measured)\\.csv|(fields|cracks|contacts)\\.pvd"
      "|fields/fields_[0-9]{6}\\.vtu|cracks/cracks_[0-9]{6}\\.vtu|contacts/contacts_[0-9]{6}\\.vtu|frames/"
      "[a-z_]+_[0-9]{6}\\.(png|jpg)"
      "|checkpoint/[a-z]+(_[0-9]+)?\\.(bin|json)|" +
      plot_pattern() + ")(\\.tmp)?");
  return pattern;
}

bool is_subfolder(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  return !entry.is_symlink() && entry.is_directory() &&
         std::find(kSubfolders.begin(), kSubfolders.end(), name) != kSubfolders.end();
}

/// The entries of the folder and of a run's subfolders in it.
std::vector<fs::directory_entry> entries_of(const fs::path& root) {
  std::vector<fs::directory_entry> entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
    entries.push_back(entry);
    if (!is_subfolder(entry)) continue;
    for (const fs::directory_entry& inner : fs::directory_iterator(entry)) entries.push_back(inner);
  }
  return entries;
}

bool is_run_entry(const fs::directory_entry& entry, const fs::path& root) {
  return !entry.is_symlink() && entry.is_regular_file() && is_run_file(entry.path().lexically_relative(root));
}

}  // namespace

bool is_run_file(const fs::path& relative) { return std::regex_match(relative.generic_string(), run_file_pattern()); }

FolderContent content_of(const fs::path& root) {
  FolderContent content = FolderContent::vacant;
  for (const fs::directory_entry& entry : entries_of(root)) {
    if (is_subfolder(entry) || entry.path() == root / kLockName) continue;
    if (!is_run_entry(entry, root)) return FolderContent::foreign;
    content = FolderContent::run_files;
  }
  return content;
}

void clear_run_files(const fs::path& root) try {
  std::vector<fs::directory_entry> entries = entries_of(root);
  // The manifest last: as long as it lies there, an interrupted clearing can be told for what it is.
  std::stable_partition(entries.begin(), entries.end(),
                        [&](const fs::directory_entry& entry) { return entry.path() != root / "manifest.json"; });
  for (const fs::directory_entry& entry : entries) {
    if (is_run_entry(entry, root)) fs::remove(entry.path());
  }
} catch (const fs::filesystem_error& failure) {
  throw output_error(failure.path1(), "cannot be cleared", failure.code().value());
}

void create_run_subfolders(const fs::path& root) try {
  for (const std::string_view name : kSubfolders) fs::create_directory(root / name);
} catch (const fs::filesystem_error& failure) {
  throw output_error(failure.path1(), "cannot be created", failure.code().value());
}

}  // namespace asperity
