#include <catch2/catch.hpp>
#include <cmath>

#include "app/confrontation/chapters.hpp"
#include "app/confrontation/mesh_band.hpp"
#include "app/confrontation/words.hpp"

using namespace asperity;
using namespace asperity::app;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

ShownCurve curve(std::vector<double> path, std::vector<double> load) { return {"", path, load, "", {}, ""}; }

}  // namespace

TEST_CASE("features are named without their unit") {
  CHECK(feature_words("peak_axial_stress_mpa") == "peak axial stress");
  CHECK(feature_words("stiffness_n_per_mm2") == "stiffness");
  CHECK(feature_words("shear_stiffness_mpa_per_mm") == "shear stiffness");
  CHECK(feature_words("drop_share") == "drop share");
}

TEST_CASE("numbers have true minus signs, raised exponents and as many decimals as their error") {
  CHECK(figures(-0.01234) == "−0.0123");
  CHECK(figures(6.2e-7, 2) == "6.2×10⁻⁷");
  CHECK(figures(NAN) == "–");
  CHECK(figures(99.7, 2) == "100");
  CHECK(figures(-4366.2, 2) == "−4366");
  CHECK(figures(99.4, 2) == "99");
  CHECK(figures(2.5e7, 2) == "2.5×10⁷");
  CHECK(figures_with_error(1.3271, 0.0219) == "1.327 ± 0.022");
  CHECK(figures_with_error(-24.31, 1.86) == "−24.3 ± 1.9");
  CHECK(figures_with_error(243.0, 21.0) == "243 ± 21");
  CHECK(figures_with_error(2.5, 0.0) == "2.5");
}

TEST_CASE("lists are joined as one says them") {
  CHECK(joined({}) == "");
  CHECK(joined({"a"}) == "a");
  CHECK(joined({"a", "b", "c"}) == "a, b and c");
}

TEST_CASE("a strength is told in the mechanism's own parameters") {
  // friction 0.3 is the declared strong one, 0 is off
  CHECK(parameter_words("platen_friction", 0.85, 0.1) == "friction coefficient 0.255 ± 0.030");
  CHECK(amplitude_words("platen_friction", 0.85, 0.1) ==
        "friction coefficient 0.255 ± 0.030 (0.85 ± 0.10 of the declared strong one)");
  // neutral 1, strong 0.5, up to 4
  CHECK(parameter_words("loading_rate", 1.0, 0.0) == "rate factor 0.5");
  CHECK(parameter_words("loading_rate", 50.5, 3.7) == "rate factor beyond its range of 0.05 to 4");
  CHECK(parameter_words("no_such_mechanism", 1.0, 0.1).empty());
  CHECK(amplitude_words("no_such_mechanism", 1.0, 0.1) == "1.00 ± 0.10 of the declared strong one");
}

TEST_CASE("a stiffness that falls with the amplitude has the error of its inverse") {
  const std::string one = parameter_words("frame_compliance", 1.0, 0.0);
  CHECK(contains(one, "stiffness "));
  const std::string half = parameter_words("frame_compliance", 0.5, 0.05);  // twice as stiff, a tenth
  const double strong = std::stod(one.substr(one.find(' ') + 1));
  const double value = std::stod(half.substr(half.find(' ') + 1));
  const double error = std::stod(half.substr(half.find("± ") + std::string("± ").size()));
  CHECK(value == Approx(2 * strong));
  CHECK(error == Approx(0.1 * value));
}

TEST_CASE("shares of draws become words") {
  CHECK(repetitions(0.34) == "in 34 of 100 repetitions");
  CHECK(repetitions(0.0025) == "in fewer than 1 of 100 repetitions");
  CHECK(contains(hypothesis_words(0.34, 0.5), "fits: "));
  CHECK(contains(hypothesis_words(0.002, 0.5), "does not fit"));
  CHECK(contains(hypothesis_words(0.34, 0.005), "the best one fits better than chance allows"));
}

TEST_CASE("the band between meshes covers what all reach, on the first way through a loop") {
  const MeshBand band = mesh_band({curve({0, 1, 0.5, 1, 2}, {0, 10, 2, 10, 20}), curve({0, 4}, {0, 20})}, 5);
  REQUIRE(band.path.size() == 5);
  CHECK(band.path.front() == 0.0);
  CHECK(band.path.back() == 2.0);
  CHECK(band.path[1] == Approx(0.5));
  CHECK(band.lower[1] == Approx(2.5));
  CHECK(band.upper[1] == Approx(5.0));
  CHECK(band.lower.back() == Approx(10.0));
  CHECK(band.upper.back() == Approx(20.0));
}

TEST_CASE("one curve, and curves without a common path, have no band") {
  CHECK(mesh_band({curve({0, 1}, {0, 1})}, 5).path.empty());
  CHECK(mesh_band({curve({0, 1}, {0, 1}), curve({}, {})}, 5).path.empty());
  CHECK(mesh_band({curve({0, 1}, {0, 1}), curve({2, 3}, {0, 1})}, 5).path.empty());
}

TEST_CASE("one text becomes page and Markdown, and none of it becomes markup by itself") {
  const Chapter chapter{"What is wrong",
                        {Paragraph{"peak_stress < 3 | *"},
                         PlainTable{"Caption", {{"Test", "", html::ColumnKind::head}, {"z", "sd"}}, {{{"B|1", "−2"}}}},
                         PlainFigure{"plots/a b.png", "", "alternative", "caption"}}};
  const std::string markdown = markdown_of(chapter);
  CHECK(contains(markdown, "## What is wrong\n"));
  CHECK(contains(markdown, "peak\\_stress \\< 3 \\| \\*"));
  CHECK(contains(markdown, "| Test | z (sd) |\n| --- | ---: |\n| B\\|1 | −2 |\n"));
  CHECK(contains(markdown, "![alternative](plots/a%20b.png)"));
  const html::Section section = section_of(chapter);
  REQUIRE(section.parts.size() == 3);
  CHECK(contains(section.parts[0].html(), "peak_stress &lt; 3 | *"));
}
