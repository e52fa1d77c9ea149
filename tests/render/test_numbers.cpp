#include <catch2/catch.hpp>
#include <limits>

#include "render/axes.hpp"
#include "render/colour_map.hpp"
#include "render/outline.hpp"
#include "render/tessellate.hpp"
#include "render/vtu.hpp"
#include "tests/support/synthetic_frame.hpp"

using namespace asperity;
using namespace asperity::render;

TEST_CASE("Ticks are round, within the range and written with true minus signs") {
  const Axis axis = make_axis({-0.31, 0.52}, "ε [%]", 4);
  std::vector<std::string> labels;
  for (const Tick& tick : axis.ticks) labels.push_back(tick.label);
  CHECK(labels == std::vector<std::string>{"−0.2", "0.0", "0.2", "0.4"});
  CHECK(axis.label == "ε [%]");
}

TEST_CASE("What rounds to zero has no sign") {
  CHECK(tick_label(-0.004, 0.01) == "0.00");
  CHECK(tick_label(-0.006, 0.01) == "−0.01");
}

TEST_CASE("Awkward numbers lend a power of ten to the label") {
  CHECK(make_axis({0, 4e6}, "Energy [N mm]", 5).label == "Energy [10⁶ N mm]");
  CHECK(make_axis({0, 4e6}, "Energy [N mm]", 5).ticks.back().label == "4");
  CHECK(make_axis({0, 5e-5}, "Time [s]", 5).label == "Time [10⁻⁶ s]");
  CHECK(make_axis({0, 2e5}, "Cracks [–]", 5).label == "Cracks [10³]");
  CHECK(make_axis({0, 2e5}, "Cracks", 5).label == "Cracks [10³]");
  CHECK(power_of_ten(-12) == "10⁻¹²");
}

TEST_CASE("Steps are 1, 2 or 5 times a power of ten") {
  CHECK(round_step(10, 5) == 2);
  CHECK(round_step(54, 6) == 10);
  CHECK(round_step(130, 6) == 20);
  CHECK(round_step(0.04, 7) == Approx(0.005));
}

TEST_CASE("Empty and constant data still give an axis") {
  CHECK(make_axis({0, 0}, "", 5).ticks.size() >= 3);
  CHECK(make_axis({7, 7}, "", 5).range.high > 7);
  CHECK(range_of({}).high == 0);
  CHECK(range_of({std::numeric_limits<double>::infinity(), 3}).high == 3);
}

TEST_CASE("Colour maps end in their ends and clamp beyond") {
  CHECK(colour_at(ColourMap::viridis, -1) == Colour{0x44, 0x01, 0x54});
  CHECK(colour_at(ColourMap::viridis, 2) == Colour{0xFD, 0xE7, 0x25});
  CHECK(colour_at(ColourMap::red_blue, 0.5) == Colour{0xF7, 0xF7, 0xF7});
  CHECK(colour_at(ColourMap::cividis, std::numeric_limits<double>::quiet_NaN()) == Colour{0x80, 0x80, 0x80});
}

TEST_CASE("Sequential maps rise or fall in lightness all the way") {
  const auto lightness = [](Colour c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
  for (const auto& [map, sign] :
       {std::pair{ColourMap::viridis, 1}, {ColourMap::cividis, 1}, {ColourMap::magma_light_to_dark, -1}})
    for (int i = 0; i < 50; ++i)
      CHECK(sign * (lightness(colour_at(map, (i + 1) / 50.0)) - lightness(colour_at(map, i / 50.0))) > 0);
}

TEST_CASE("Dashes leave out what they should, round corners too") {
  const Polyline line{{{0, 0}, {10, 0}, {10, 10}}, {{}, 1, {6, 6}, Cap::butt}};
  const auto parts = dashes(line);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].back() == Vec2{6, 0});
  CHECK(parts[1].front() == Vec2{10, 2});
  CHECK(parts[1].back() == Vec2{10, 8});
}

TEST_CASE("Principal stresses of a known state") {
  const PrincipalStress principal = principal_stress({3, -5, 9, 3});
  CHECK(principal.major == Approx(4));
  CHECK(principal.minor == Approx(-6));
  CHECK(principal.max_shear() == Approx(5));
}

TEST_CASE("The outline is found on the specimen as it was before it parted") {
  Frame frame;
  test::add_lattice(frame, {20, 20}, [](Vec2 p) { return std::abs(p.x) < 6 && std::abs(p.y) < 6; });
  frame.displacement.assign(frame.position.size(), {});
  const std::size_t edges = outline_edges(frame).size();
  CHECK(edges == 3 * frame.triangles.size() - 2 * test::inner_edges(frame).size());
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    frame.displacement[i] = {0.1 * static_cast<double>(i), 0};
    frame.position[i] += frame.displacement[i];
  }
  CHECK(outline_edges(frame).size() == edges);
}
