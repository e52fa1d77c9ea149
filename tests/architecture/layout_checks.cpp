#include "tests/architecture/layout_checks.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string_view>

#include "tests/architecture/source_files.hpp"

namespace asperity::architecture {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 13> kOrder{"base",      "config",      "geometry",     "particles", "contact",
                                                  "mechanism", "integrator",  "measurement",  "output",    "experiment",
                                                  "campaign",  "calibration", "confrontation"};
const std::set<std::string> kCode{".hpp", ".cpp"};
constexpr std::size_t kMostLines = 400;

std::string at(const SourceFile& file, std::size_t line, const std::string& what) {
  return file.path + ":" + std::to_string(line + 1) + ": " + what;
}

std::vector<SourceFile> product_code(const fs::path& root) {
  std::vector<SourceFile> all;
  for (const char* folder : {"core", "render", "app"}) {
    for (SourceFile& file : files_below(root, folder, kCode)) all.push_back(std::move(file));
  }
  return all;
}

/// What the line includes, with its brackets or quotes taken off.
std::optional<std::string> included(const std::string& line) {
  static const std::regex pattern("\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"].*");
  std::smatch match;
  if (!std::regex_match(line, match, pattern)) return std::nullopt;
  return match[1];
}

/// Calls visit(file, line number, header) for every include of the product's code.
template <class Visit>
void for_each_include(const fs::path& root, const Visit& visit) {
  for (const SourceFile& file : product_code(root)) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      if (const auto header = included(file.lines[i])) visit(file, i, *header);
    }
  }
}

/// Place of a file in the order of includes: core's folders, then render, then app; nothing for foreign headers.
std::optional<std::size_t> place_of(const std::string& path) {
  const std::string top = leading_parts(path, 1);
  if (top == "render") return kOrder.size();
  if (top == "app") return kOrder.size() + 1;
  if (top != "core") return std::nullopt;
  const auto found = std::find(kOrder.begin(), kOrder.end(), leading_parts(path, 2).substr(5));
  return static_cast<std::size_t>(found - kOrder.begin());
}

bool in_order(const SourceFile& file, const std::string& header) {
  if (header.find("..") != std::string::npos) return false;
  const std::optional<std::size_t> place = place_of(header);
  return !place || *place <= place_of(file.path).value();
}

struct ForeignLibrary {
  std::string name;
  std::regex header;
  std::regex allowed_in;
};

const std::vector<ForeignLibrary>& foreign_libraries() {
  static const std::vector<ForeignLibrary> libraries{
      {"VTK", std::regex("vtk.*"), std::regex("render/.*\\.cpp")},
      {"CGAL", std::regex("CGAL/.*"), std::regex("core/geometry/[^/]*\\.cpp")},
      {"OpenTURNS", std::regex("openturns/.*"), std::regex("core/(calibration|confrontation)/[^/]*\\.cpp")},
      {"CLI11", std::regex("CLI/.*"), std::regex("app/.*")}};
  return libraries;
}

std::vector<std::string> core_folders(const fs::path& root) {
  std::vector<std::string> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(root / "core")) {
    if (entry.is_directory()) folders.push_back("core/" + entry.path().filename().string());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

using Labels = std::map<std::string, std::string>;  ///< Label -> "file:line" where it was first met.

const std::string kLabel = "\\([A-Z]{1,2}[0-9]+[a-z]?\\)";

/// "Eqs. (I7)-(I9)" cites I8 too, "Eqs. (C20p)-(C22p)" C21p.
void add_range(const std::string& first, const std::string& last, const std::string& where, Labels& labels) {
  static const std::regex parts("([A-Z]+)([0-9]+)([a-z]?)");
  std::smatch from;
  std::smatch to;
  if (!std::regex_match(first, from, parts) || !std::regex_match(last, to, parts)) return;
  for (int i = std::stoi(from[2]); i <= std::stoi(to[2]); ++i) {
    labels.emplace(from[1].str() + std::to_string(i) + from[3].str(), where);
  }
}

/// The labels of one citation, "(C3), (C4) and (C7)-(C9)".
void add_citation(const std::string& citation, const std::string& where, Labels& labels) {
  static const std::regex part("\\(([A-Z]+[0-9]+[a-z]?)\\)(?:\\s*(?:-|to)\\s*\\(([A-Z]+[0-9]+[a-z]?)\\))?");
  for (std::sregex_iterator it(citation.begin(), citation.end(), part), end; it != end; ++it) {
    if ((*it)[2].matched) add_range((*it)[1], (*it)[2], where, labels);
    labels.emplace((*it)[1], where);
  }
}

/// Text of the file in one line, so that a citation may go over a line's end inside a comment.
std::string joined_comments(const SourceFile& file) {
  static const std::regex comment_mark("^\\s*///?<?");
  std::string text;
  for (const std::string& line : file.lines) text += std::regex_replace(line, comment_mark, "") + " ";
  return text;
}

Labels cited_in(const fs::path& root, const std::string& folder) {
  static const std::regex citation("\\bEqs?\\.?\\s*(" + kLabel + "(?:(?:\\s|,|-|and|to)*" + kLabel + ")*)");
  Labels labels;
  for (const SourceFile& file : files_below(root, folder, kCode)) {
    const std::string text = joined_comments(file);
    for (std::sregex_iterator it(text.begin(), text.end(), citation), end; it != end; ++it) {
      add_citation((*it)[1], file.path, labels);
    }
  }
  return labels;
}

Labels defined_in(const fs::path& root, const std::string& folder) {
  static const std::regex first("^[\\s*>|`$#-]*\\*{0,2}(" + kLabel + ").*");
  static const std::regex last(".*\\s[*`$|]*(" + kLabel + ")[*`$|.\\s]*$");
  static const std::regex citation_last(".*\\bEqs?\\.?\\s*" + kLabel + "[*`$|.\\s]*$");
  Labels labels;
  for (const SourceFile& file : files_below(root, folder, {".md"})) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      std::smatch match;
      const bool defines = std::regex_match(line, match, first) ||
                           (!std::regex_match(line, citation_last) && std::regex_match(line, match, last));
      if (defines) add_citation(match[1], file.path + ":" + std::to_string(i + 1), labels);
    }
  }
  return labels;
}

/// Paths of one machine; written in parts, so that this file does not hold one.
const std::regex& machine_path() {
  static const std::regex pattern(std::string("(^|[^A-Za-z0-9_.}~])/") + "(work|farm|root|home|Users)/[A-Za-z]");
  return pattern;
}

const std::regex& scratch_path() {
  static const std::regex pattern(std::string("(^|[^A-Za-z0-9_.}])/") + "tmp/[A-Za-z]");
  return pattern;
}

}  // namespace

Violations check_include_order(const fs::path& root) {
  Violations found;
  for_each_include(root, [&](const SourceFile& file, std::size_t line, const std::string& header) {
    if (!in_order(file, header))
      found.push_back(at(file, line, "includes " + header + " against the order of folders"));
  });
  for (const std::string& folder : core_folders(root)) {
    if (*place_of(folder) == kOrder.size()) found.push_back(folder + ": is not in the order of folders");
  }
  return found;
}

Violations check_foreign_headers(const fs::path& root) {
  Violations found;
  for_each_include(root, [&](const SourceFile& file, std::size_t line, const std::string& header) {
    for (const ForeignLibrary& library : foreign_libraries()) {
      if (!std::regex_match(header, library.header) || std::regex_match(file.path, library.allowed_in)) continue;
      found.push_back(at(file, line, library.name + " is not allowed here"));
    }
  });
  return found;
}

Violations check_readmes(const fs::path& root) {
  Violations found;
  for (const std::string& folder : core_folders(root)) {
    if (!fs::exists(root / folder / "README.md")) found.push_back(folder + ": has no README.md");
  }
  return found;
}

Violations check_equations(const fs::path& root) {
  Violations found;
  Labels everywhere;
  for (const std::string& folder : core_folders(root)) {
    const Labels cited = cited_in(root, folder);
    const Labels defined = defined_in(root, folder);
    for (const auto& [label, where] : cited) {
      if (!defined.contains(label)) found.push_back(where + ": Eq. (" + label + ") is not in " + folder + "/README.md");
    }
    for (const auto& [label, where] : defined) {
      if (!cited.contains(label)) found.push_back(where + ": no code of " + folder + " cites Eq. (" + label + ")");
      const auto [other, fresh] = everywhere.emplace(label, where);
      if (!fresh) found.push_back(where + ": (" + label + ") is also defined at " + other->second);
    }
  }
  return found;
}

Violations check_lengths(const fs::path& root) {
  Violations found;
  for (const char* folder : {"core", "render", "app", "tests"}) {
    for (const SourceFile& file : files_below(root, folder, {".hpp", ".cpp", ".py", ".sh"})) {
      if (file.lines.size() < kMostLines) continue;
      found.push_back(file.path + ": has " + std::to_string(file.lines.size()) + " lines");
    }
  }
  return found;
}

Violations check_machine_paths(const fs::path& root) {
  const std::set<std::string> text{".hpp", ".cpp", ".py", ".sh", ".cmake", ".json", ".csv", ".txt", ".md"};
  Violations found;
  for (const char* folder : {"core", "render", "app", "tests", "configs", "cmake", "outputs", "docs"}) {
    for (const SourceFile& file : files_below(root, folder, text)) {
      // A scratch folder may stand in an example of use or in a test, not in the product.
      const bool product = leading_parts(file.path, 1) != "tests" && !file.path.ends_with(".md");
      for (std::size_t i = 0; i < file.lines.size(); ++i) {
        const bool bad = std::regex_search(file.lines[i], machine_path()) ||
                         (product && std::regex_search(file.lines[i], scratch_path()));
        if (bad) found.push_back(at(file, i, "names a path of one machine: " + file.lines[i]));
      }
    }
  }
  return found;
}

}  // namespace asperity::architecture
