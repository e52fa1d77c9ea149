#include <catch2/catch.hpp>
#include <fstream>

#include "tests/architecture/layout_checks.hpp"

using namespace asperity::architecture;

namespace fs = std::filesystem;

namespace {

const fs::path kRoot = ASPERITY_SOURCE_DIR;

/// A small checkout of its own for one test case, clean until a file is put in.
class Tree {
 public:
  explicit Tree(const std::string& name) : root_(fs::path(ASPERITY_TEST_SCRATCH) / "architecture" / name) {
    fs::remove_all(root_);
    put("core/base/vec2.hpp", "#pragma once\n#include <cmath>\n");
    put("core/base/README.md", "Vectors.\n");
    put("core/contact/law.cpp",
        "#include \"core/base/vec2.hpp\"\n// Eqs. (C1) and\n/// (C2)-(C4), Eqs. (C5p)-(C7p); the paper's Eq 5.\n");
    put("core/contact/README.md",
        "* (C1) a = b\n\nb = c  (C2)\n| (C3) | x |\n**(C4)** see Eq. (C1)\nalso (C2), and Eq. (C3)\n* (C5p)\n* "
        "(C6p)\n* (C7p)\n");
    put("render/draw.cpp", "#include <vtkActor.h>\n#include \"core/contact/law.hpp\"\n");
    put("app/main.cpp", "#include <CLI/CLI.hpp>\n#include \"render/draw.hpp\"\n");
  }

  Tree& put(const std::string& path, const std::string& text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
    return *this;
  }

  const fs::path& root() const { return root_; }

 private:
  fs::path root_;
};

const std::vector<Violations (*)(const fs::path&)> kChecks{
    check_include_order, check_foreign_headers, check_readmes, check_equations, check_lengths, check_machine_paths};

/// Exactly one violation, and it says this.
void check_one(const Violations& found, const std::string& text) {
  CAPTURE(found);
  REQUIRE(found.size() == 1);
  CHECK_THAT(found.front(), Catch::Contains(text));
}

}  // namespace

TEST_CASE("includes go one way") { CHECK(check_include_order(kRoot) == Violations{}); }
TEST_CASE("VTK, CGAL, OpenTURNS and CLI11 stay where they belong") { CHECK(check_foreign_headers(kRoot) == Violations{}); }
TEST_CASE("every core folder has a README") { CHECK(check_readmes(kRoot) == Violations{}); }
TEST_CASE("equations cited in code and numbered in READMEs agree") { CHECK(check_equations(kRoot) == Violations{}); }
TEST_CASE("no source file is too long") { CHECK(check_lengths(kRoot) == Violations{}); }
TEST_CASE("no file names a path of one machine") { CHECK(check_machine_paths(kRoot) == Violations{}); }

TEST_CASE("a clean tree passes every check") {
  const Tree tree("clean");
  for (const auto& check : kChecks) CHECK(check(tree.root()) == Violations{});
}

TEST_CASE("an include to the right is found") {
  Tree tree("right");
  tree.put("core/base/bad.hpp", "\n#  include \"core/contact/law.hpp\"\n");
  check_one(check_include_order(tree.root()), "core/base/bad.hpp:2: includes core/contact/law.hpp");
}

TEST_CASE("core that includes render, render that includes app, and a way around by .. are found") {
  check_one(check_include_order(Tree("render").put("core/contact/a.cpp", "#include \"render/draw.hpp\"\n").root()),
            "render/draw.hpp");
  check_one(check_include_order(Tree("app").put("render/a.cpp", "#include \"app/cli.hpp\"\n").root()), "app/cli.hpp");
  check_one(check_include_order(Tree("dots").put("core/base/a.cpp", "#include \"../contact/law.hpp\"\n").root()),
            "../contact");
}

TEST_CASE("a core folder that has no place in the order is found") {
  check_one(check_include_order(Tree("folder").put("core/extras/README.md", "x\n").root()),
            "core/extras: is not in the order");
}

TEST_CASE("foreign headers out of their place are found") {
  check_one(check_foreign_headers(Tree("vtk").put("render/draw.hpp", "#include <vtkActor.h>\n").root()),
            "render/draw.hpp:1: VTK");
  check_one(check_foreign_headers(Tree("vtk_core").put("core/base/a.cpp", "#include \"vtkActor.h\"\n").root()), "VTK");
  check_one(check_foreign_headers(Tree("cgal").put("core/geometry/a.hpp", "#include <CGAL/Kernel.h>\n").root()),
            "CGAL");
  check_one(
      check_foreign_headers(Tree("turns").put("core/calibration/a.hpp", "#include <openturns/Point.hxx>\n").root()),
      "OpenTURNS");
  check_one(check_foreign_headers(Tree("cli").put("core/base/a.cpp", "#include <CLI/App.hpp>\n").root()), "CLI11");
}

TEST_CASE("a core folder without README is found") {
  check_one(check_readmes(Tree("readme").put("core/geometry/mesh.hpp", "\n").root()),
            "core/geometry: has no README.md");
}

TEST_CASE("an equation that code cites and no README has is found") {
  check_one(check_equations(Tree("cited").put("core/contact/a.cpp", "// Eqs. (C1),\n// (C9).\n").root()),
            "Eq. (C9) is not in core/contact/README.md");
}

TEST_CASE("an equation that no code cites, and a label defined twice, are found") {
  check_one(check_equations(Tree("uncited").put("core/base/README.md", "* (B1) x = y\n").root()),
            "no code of core/base cites Eq. (B1)");
  Tree twice("twice");
  twice.put("core/geometry/README.md", "(C1) x\n").put("core/geometry/a.cpp", "// Eq. (C1)\n");
  check_one(check_equations(twice.root()), "(C1) is also defined at");
}

TEST_CASE("a long file is found") {
  std::string text;
  for (int i = 0; i < 400; ++i) text += "//\n";
  check_one(check_lengths(Tree("long").put("render/long.cpp", text).root()), "render/long.cpp: has 400 lines");
}

TEST_CASE("paths of one machine are found") {
  const std::string home = std::string("/ho") + "me/me/data";
  const std::string scratch = std::string("/tm") + "p/x";
  check_one(check_machine_paths(Tree("home").put("configs/a.json", "{\"curve\": \"" + home + "\"}").root()),
            "configs/a.json:1");
  check_one(check_machine_paths(Tree("scratch").put("app/a.sh", "\ncp a " + scratch + "\n").root()), "app/a.sh:2");
  CHECK(check_machine_paths(Tree("example").put("outputs/README.md", "asperity run --out " + scratch).root()).empty());
  CHECK(check_machine_paths(Tree("system")
                                .put("app/a.sh",
                                     "ls /usr/share/fonts /proc/meminfo core/ho"
                                     "me/x\n")
                                .root())
            .empty());
}
