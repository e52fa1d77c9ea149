#pragma once
#include <filesystem>
#include <string>
#include <vector>

/// What the layout promises, each as a check of the checkout at `root` that returns its violations as "file:line:
/// what".
namespace asperity::architecture {

using Violations = std::vector<std::string>;

/// A core folder includes only itself and what stands to its left, by the path from the root; render includes core, and
/// only app includes app.
Violations check_include_order(const std::filesystem::path& root);

/// VTK appears only in render/**.cpp, CGAL only in core/geometry/*.cpp, OpenTURNS only in core/calibration/*.cpp, CLI11
/// only in app.
Violations check_foreign_headers(const std::filesystem::path& root);

/// Every core folder has a README.md.
Violations check_readmes(const std::filesystem::path& root);

/// "Eq. (C3)" in the code of a core folder is defined in that folder's README.md, every definition there is cited in
/// the folder's code, and no two READMEs define the same label. A README defines a label where a line begins with it
/// (behind list marks) or ends with it: "* (C3) t = k_t delta_n" or "t = k_t delta_n  (C3)".
Violations check_equations(const std::filesystem::path& root);

/// No source file reaches 400 lines.
Violations check_lengths(const std::filesystem::path& root);

/// No file names a path that only one machine has.
Violations check_machine_paths(const std::filesystem::path& root);

}  // namespace asperity::architecture
