#include <algorithm>
#include <catch2/catch.hpp>

#include "render/difference_map.hpp"
#include "render/paint.hpp"
#include "render/pattern_grid.hpp"
#include "render/style.hpp"
#include "tests/render/picture_file.hpp"
#include "tests/support/synthetic_frame.hpp"

using namespace asperity;
using namespace asperity::render;

namespace {

PatternGrid grid_of(const std::vector<Frame>& frames, Field field = Field::cracks) {
  PatternGrid grid{"A title", "A subtitle", field, {}};
  for (const Frame& frame : frames)
    grid.panels.push_back({frame, "panel " + std::to_string(grid.panels.size()), {"what it differs by"}, {{1.0}, 1.0}});
  return grid;
}

std::vector<Text> texts_with(const Drawing& drawing, const std::string& part) {
  std::vector<Text> texts;
  for (const Shape& shape : drawing.shapes)
    if (const Text* text = std::get_if<Text>(&shape); text && text->text.find(part) != std::string::npos)
      texts.push_back(*text);
  return texts;
}

/// Sides of all triangles that are drawn, in pixels: the longest.
double longest_side(const Drawing& drawing, double from_x, double to_x) {
  double longest = 0;
  for (const Shape& shape : drawing.shapes)
    if (const Triangle* t = std::get_if<Triangle>(&shape); t && t->corners[0].x > from_x && t->corners[0].x < to_x)
      for (std::size_t c = 0; c < 3; ++c) longest = std::max(longest, norm(t->corners[c] - t->corners[(c + 1) % 3]));
  return longest;
}

}  // namespace

TEST_CASE("Specimens of different size are drawn at one scale") {
  const Frame disc = test::synthetic_disc(), rectangle = test::synthetic_rectangle();
  const PatternGrid grid = grid_of({disc, rectangle});
  const Drawing drawing = draw_pattern_grid(grid);
  const double scale = pattern_grid_scale(grid), second = texts_with(drawing, "panel 1").at(0).at.x;
  CHECK(longest_side(drawing, 0, second) == Approx(scale * test::kEdgeMm).epsilon(0.02));
  CHECK(longest_side(drawing, second, 1e9) == Approx(scale * test::kEdgeMm).epsilon(0.02));
  CHECK(scale < pattern_grid_scale(grid_of({disc, disc})));
}

TEST_CASE("Many panels stand in rows, each text inside the picture, one legend for all") {
  const Frame disc = test::synthetic_disc();
  for (const std::size_t count : {1u, 2u, 3u, 7u, 12u}) {
    const Drawing drawing = draw_pattern_grid(grid_of(std::vector<Frame>(count, disc)));
    const std::vector<Text> headings = texts_with(drawing, "panel ");
    CHECK(headings.size() == count);
    CHECK(texts_with(drawing, "Broken in shear").size() == 1);
    CHECK(texts_with(drawing, "Roses:").size() == 1);
    CHECK(drawing.width <= 2200);
    for (const Shape& shape : drawing.shapes)
      if (const Text* text = std::get_if<Text>(&shape)) {
        CHECK(text->at.y < drawing.height);
        CHECK(text->at.x < drawing.width);
      }
  }
  const std::vector<Text> twelve = texts_with(draw_pattern_grid(grid_of(std::vector<Frame>(12, disc))), "panel ");
  CHECK(twelve.front().at.y < twelve.back().at.y);
}

TEST_CASE("Damage has a colour bar in place of the legend, and a grid is painted") {
  const PatternGrid grid = grid_of({test::synthetic_disc(), test::synthetic_disc()}, Field::damage);
  const Drawing drawing = draw_pattern_grid(grid);
  CHECK(texts_with(drawing, "Damage of contacts").size() == 1);
  CHECK(texts_with(drawing, "Broken in").empty());
  const auto png = test::scratch("pattern_grid") / "grid.png";
  write_png(drawing, png);
  const test::PictureFile picture = test::read_picture(png);
  CHECK(picture.width == drawing.width);
  CHECK(picture.pixels.size() > 200);
}

TEST_CASE("A rose has a wedge and its mirror for every share, as large as the share") {
  Drawing drawing{200, 200, {}};
  draw_rose(drawing, {100, 100}, 80, {{0, 0.25, 1.0, 0}, 1.0});  // four bins of 45 degrees
  std::vector<Polygon> wedges;
  for (const Shape& shape : drawing.shapes)
    if (const Polygon* polygon = std::get_if<Polygon>(&shape)) wedges.push_back(*polygon);
  REQUIRE(wedges.size() == 4);
  CHECK(norm(wedges[0].corners[1] - Vec2{100, 100}) == Approx(40));  // a quarter of the area: half the radius
  CHECK(norm(wedges[2].corners[1] - Vec2{100, 100}) == Approx(80));
  CHECK(wedges[2].corners[1].x == Approx(100));  // from the vertical
  CHECK(wedges[2].corners[1].y == Approx(20));
  CHECK(wedges[2].corners.back().x > 150);  // to the right
  CHECK(wedges[3].corners[1].y == Approx(180));
}

TEST_CASE("A difference map is pale where both runs agree, red or blue where one alone is damaged, and counts cracks") {
  Frame first = test::synthetic_disc(), second = first;
  std::fill(first.damage.begin(), first.damage.end(), 0.0);
  second.damage = first.damage;
  for (std::size_t i = 0; i < 40; ++i) first.damage[i] = 1;
  for (std::size_t i = 60; i < 120; ++i) second.damage[i] = 1;
  const DifferenceMap map{
      "Difference", "of two", {"A", "B"},
      first,        second,   {{{Vec2{0, 0}, {2, 0}}, BrokenIn::both}, {{Vec2{0, 2}, {2, 2}}, BrokenIn::second}}};
  const Drawing drawing = draw_difference_map(map);
  CHECK(texts_with(drawing, "Broken in both: 1").size() == 1);
  CHECK(texts_with(drawing, "Broken in A alone: 0").size() == 1);
  CHECK(texts_with(drawing, "Broken in B alone: 1").size() == 1);
  std::size_t blue = 0, red = 0, pale = 0;
  for (const Shape& shape : drawing.shapes)
    if (const Triangle* t = std::get_if<Triangle>(&shape)) {
      blue += t->fill == colour_at(ColourMap::red_blue, 0);
      red += t->fill == colour_at(ColourMap::red_blue, 1);
      pale += t->fill == colour_at(ColourMap::red_blue, 0.5);
    }
  CHECK(blue == 40);
  CHECK(red == 60);
  CHECK(pale == first.triangles.size() - 100);
}
