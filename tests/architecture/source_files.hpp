#pragma once
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace asperity::architecture {

/// One text file of the checkout.
struct SourceFile {
  std::string path;  ///< Relative to the root, with '/'.
  std::vector<std::string> lines;
};

/// Files below root/folder whose extension is one of these, in order of path; none if the folder is missing.
std::vector<SourceFile> files_below(const std::filesystem::path& root, const std::string& folder,
                                    const std::set<std::string>& extensions);

/// First `count` parts of a path: "core/contact/law.hpp", 2 -> "core/contact".
std::string leading_parts(const std::string& path, int count);

}  // namespace asperity::architecture
