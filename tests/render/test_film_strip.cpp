#include <algorithm>
#include <catch2/catch.hpp>

#include "render/film_strip.hpp"
#include "render/paint.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"
#include "tests/render/picture_file.hpp"
#include "tests/support/synthetic_frame.hpp"

using namespace asperity;
using namespace asperity::render;

namespace {

std::vector<StripPanel> three_panels(const Frame& frame) {
  Frame intact = frame;
  intact.cracks.clear();
  return {{intact, "first"}, {frame, "second"}, {frame, "third, 0.64 mm, 1.90 MPa"}};
}

std::vector<Text> texts_of(const Drawing& drawing) {
  std::vector<Text> texts;
  for (const Shape& shape : drawing.shapes)
    if (const Text* text = std::get_if<Text>(&shape)) texts.push_back(*text);
  return texts;
}

double right_end(const Polyline& line) {
  double x = 0;
  for (const Vec2 point : line.points) x = std::max(x, point.x);
  return x;
}

}  // namespace

TEST_CASE("A strip has its panels in a row, each over its caption, and cracks only where the frame has them") {
  const Drawing drawing = draw_film_strip(three_panels(test::synthetic_disc()), Field::cracks, 1500);
  CHECK(drawing.width == 1500);
  CHECK(drawing.height < 900);
  const std::vector<Text> texts = texts_of(drawing);
  REQUIRE(texts.size() == 7);  // captions, the scale bar's length, the key
  CHECK(texts[4].text == "Broken in tension");
  CHECK(texts[6].at.x + text_width(texts[6].text, texts[6].size) < 1500);
  CHECK(texts[0].text == "first");
  CHECK(texts[2].text == "third, 0.64 mm, 1.90 MPa");
  CHECK(texts[1].at.x == Approx(750));
  CHECK(texts[0].at.x + texts[2].at.x == Approx(1500));
  CHECK(texts[1].at.y == texts[0].at.y);
  for (const Text& text : texts) CHECK(text.at.y < drawing.height);
  double leftmost = 1500;
  int cracks = 0;
  for (const Shape& shape : drawing.shapes)
    if (const Polyline* line = std::get_if<Polyline>(&shape);
        line && line->stroke.colour == style::kTension && line->points.front().y < texts[0].at.y) {
      ++cracks;
      leftmost = std::min(leftmost, right_end(*line));
    }
  CHECK(cracks > 0);
  CHECK(leftmost > 500);  // none in the first panel
}

TEST_CASE("A strip's height follows from its specimen, and it is painted") {
  const Drawing tall = draw_film_strip(three_panels(test::synthetic_rectangle()), Field::cracks, 1500);
  CHECK(tall.height > draw_film_strip(three_panels(test::synthetic_disc()), Field::cracks, 1500).height);
  const auto png = test::scratch("film_strip") / "strip.png";
  write_png(tall, png);
  const test::PictureFile picture = test::read_picture(png);
  CHECK(picture.width == 1500);
  CHECK(picture.height == tall.height);
  CHECK(picture.count(style::kSpecimen) > 30'000);
}
