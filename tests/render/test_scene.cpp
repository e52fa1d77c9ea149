#include <algorithm>
#include <catch2/catch.hpp>
#include <thread>

#include "core/base/error.hpp"
#include "render/scene.hpp"
#include "render/series.hpp"
#include "render/style.hpp"
#include "tests/render/picture_file.hpp"
#include "tests/support/synthetic_frame.hpp"

namespace fs = std::filesystem;
using namespace asperity;
using namespace asperity::render;

namespace {

PictureOptions options_for(Field field) {
  PictureOptions options;
  options.field = field;
  return options;
}

test::PictureFile picture_of(const Frame& frame, const PictureOptions& options) {
  const fs::path png = test::scratch("render_picture") / "picture.png";
  draw_frame(frame, options, png);
  return test::read_picture(png);
}

Frame without(Frame frame, CrackMode mode) {
  std::erase_if(frame.cracks, [mode](const CrackSegment& crack) { return crack.mode == mode; });
  return frame;
}

}  // namespace

TEST_CASE("Every field of disc and rectangle is drawn at the default size with many colours") {
  for (const Frame& frame : {test::synthetic_disc(), test::synthetic_rectangle()})
    for (const Field field : all_fields()) {
      CAPTURE(frame.name, field_name(field));
      const test::PictureFile picture = picture_of(frame, options_for(field));
      CHECK(picture.width == 1600);
      CHECK(picture.height == 1200);
      CHECK(picture.pixels.size() > 60);
      // White margins, but at least a tenth of the picture is specimen.
      CHECK(picture.count(style::kPaper) > 400'000);
      CHECK(picture.count(style::kPaper) < 1'728'000);
    }
}

TEST_CASE("Cracks appear in their mode's colour beyond the legend's swatch, and only then") {
  const PictureOptions options = options_for(Field::cracks);
  const Frame frame = test::synthetic_disc();
  const test::PictureFile all = picture_of(frame, options);
  const test::PictureFile no_tension = picture_of(without(frame, CrackMode::tension), options);
  const test::PictureFile no_shear = picture_of(without(frame, CrackMode::shear), options);
  const test::PictureFile no_softening = picture_of(without(frame, CrackMode::softening), options);
  // 2 mm of a line of 4 px or more at 16 px/mm for each crack; other cracks may cover some.
  CHECK(all.count(style::kTension) - no_tension.count(style::kTension) > 2000);
  CHECK(all.count(style::kShear) - no_shear.count(style::kShear) > 1500);
  CHECK(all.count(style::kSoftening) - no_softening.count(style::kSoftening) > 2000);
  // Legend and inset have these colours too, so compare with a picture without any crack.
  Frame intact = frame;
  intact.cracks.clear();
  const test::PictureFile none = picture_of(intact, options);
  CHECK(no_tension.count(style::kTension) == none.count(style::kTension));
  CHECK(no_shear.count(style::kShear) == none.count(style::kShear));
  CHECK(no_softening.count(style::kSoftening) == none.count(style::kSoftening));
}

TEST_CASE("Two drawings of one frame have the same bytes, from any thread") {
  const Frame frame = test::synthetic_rectangle();
  const fs::path folder = test::scratch("render_repeat");
  draw_frame(frame, options_for(Field::stress), folder / "a.png");
  draw_frame(test::synthetic_disc(), options_for(Field::cracks), folder / "other.png");
  std::thread([&] { draw_frame(frame, options_for(Field::stress), folder / "b.png"); }).join();
  CHECK(test::file_bytes(folder / "a.png") == test::file_bytes(folder / "b.png"));
  CHECK(test::file_bytes(folder / "a.png") != test::file_bytes(folder / "other.png"));
}

TEST_CASE("A damaged triangle takes the colour of its damage") {
  Frame frame = test::synthetic_disc();
  std::fill(frame.damage.begin(), frame.damage.end(), 0.0);
  const Colour low = colour_at(ColourMap::magma_light_to_dark, 0), high = colour_at(ColourMap::magma_light_to_dark, 1);
  CHECK(picture_of(frame, options_for(Field::damage)).count(low) > 200'000);
  std::fill(frame.damage.begin(), frame.damage.end(), 1.0);
  CHECK(picture_of(frame, options_for(Field::damage)).count(high) > 200'000);
}

TEST_CASE("Fragments are coloured by area, the largest pale") {
  Frame frame = test::synthetic_disc();
  std::fill(frame.fragment.begin(), frame.fragment.end(), 7);
  const test::PictureFile whole = picture_of(frame, options_for(Field::fragments));
  CHECK(whole.count(style::kLargestFragment) > 200'000);
  CHECK(whole.count(style::kFragments[0]) == 0);
  const test::PictureFile split = picture_of(test::synthetic_disc(), options_for(Field::fragments));
  CHECK(split.count(style::kLargestFragment) > split.count(style::kFragments[0]));
  CHECK(split.count(style::kFragments[0]) > split.count(style::kFragments[1]));
  CHECK(split.count(style::kFragments[1]) > 1000);
}

TEST_CASE("A series is drawn from its VTU files alone, with one colour range") {
  const fs::path run = test::scratch("render_redraw");
  SeriesWriter writer(run);
  Frame weak = test::synthetic_disc(), strong = test::synthetic_disc();
  for (auto& stress : weak.stress)
    for (double& component : stress) component *= 0.25;
  writer.write(weak);
  writer.write(strong);
  const Range range = *range_over_series(run, Field::shear_stress);
  CHECK(range.high == field_range(Field::shear_stress, field_values(strong, Field::shear_stress)).high);
  CHECK(range.low == 0);
  CHECK_FALSE(range_over_series(run, Field::cracks).has_value());
  draw_series(run, {Field::shear_stress, Field::cracks}, {0, 1}, {});
  for (const char* name :
       {"shear_stress_000000.png", "shear_stress_000001.png", "cracks_000000.png", "cracks_000001.png"})
    CHECK(test::read_picture(run / "frames" / name).width == 1600);
  const Colour high = colour_at(ColourMap::viridis, 1);
  CHECK(test::read_picture(run / "frames/shear_stress_000000.png").count(high) == 0);
  CHECK(test::read_picture(run / "frames/shear_stress_000001.png").count(high) > 100);
}

TEST_CASE("Stress colours are symmetric about zero, others start from it, and single extremes do not count") {
  CHECK(field_range(Field::stress, {-2, 1}).low == -2);
  CHECK(field_range(Field::stress, {-2, 1}).high == 2);
  CHECK(field_range(Field::compressive_stress, {-1, 4}).low == 0);
  std::vector<double> values(1000, 1.0);
  values[17] = 1e6;
  CHECK(field_range(Field::shear_stress, values).high == 1.0);
  CHECK(field_range(Field::damage, {0.2}).high == 1);
}

TEST_CASE("A picture that cannot be written is an output error") {
  const fs::path folder = test::scratch("render_no_picture");
  fs::create_directories(folder / "x.png");
  try {
    draw_frame(test::synthetic_disc(), {}, folder / "x.png");
    FAIL("nothing was thrown");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::output);
    CHECK_THAT(error.what(), Catch::Contains("x.png"));
  }
}

TEST_CASE("Field names lead back to their fields") {
  for (const Field field : all_fields()) CHECK(field_from_name(field_name(field)) == field);
  CHECK_FALSE(field_from_name("colour").has_value());
}
