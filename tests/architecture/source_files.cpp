#include "tests/architecture/source_files.hpp"

#include <algorithm>
#include <fstream>

namespace asperity::architecture {
namespace {

namespace fs = std::filesystem;

SourceFile read(const fs::path& root, const fs::path& path) {
  SourceFile file{path.lexically_relative(root).generic_string(), {}};
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
  return file;
}

}  // namespace

std::vector<SourceFile> files_below(const fs::path& root, const std::string& folder,
                                    const std::set<std::string>& extensions) {
  std::vector<SourceFile> files;
  if (!fs::exists(root / folder)) return files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
    const bool wanted = entry.is_regular_file() && extensions.count(entry.path().extension().string()) > 0;
    if (wanted) files.push_back(read(root, entry.path()));
  }
  std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

std::string leading_parts(const std::string& path, int count) {
  std::size_t end = 0;
  for (int i = 0; i < count; ++i) {
    end = path.find('/', i == 0 ? 0 : end + 1);
    if (end == std::string::npos) return path;
  }
  return path.substr(0, end);
}

}  // namespace asperity::architecture
