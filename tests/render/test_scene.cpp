#include <algorithm>
#include <catch2/catch.hpp>
#include <thread>

#include "core/base/error.hpp"
#include "render/force_chains.hpp"
#include "render/fragment_colours.hpp"
#include "render/outline.hpp"
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

TEST_CASE("Jaws are drawn as blocks with an arc, beside the disc and behind it") {
  Frame frame = test::synthetic_disc();
  const int flat = picture_of(frame, options_for(Field::cracks)).count(style::kPlaten);
  frame.jaws = {40.5, 0, 27};
  const int curved = picture_of(frame, options_for(Field::cracks)).count(style::kPlaten);
  // At some 15 px/mm: two blocks of 59 x 1.4 mm below the apexes, and beside the disc 54 x 10.3 mm less what its cap
  // and the gap take.
  CHECK(curved > 3 * flat);
  CHECK(curved < 400'000);
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

TEST_CASE("Contact forces appear in their kind's colour beyond the legend's swatch, and only then") {
  const PictureOptions options = options_for(Field::contacts);
  const Frame frame = test::synthetic_disc();
  const test::PictureFile all = picture_of(frame, options);
  const auto without_class = [&](ForceClass kind) {
    Frame rest = frame;
    std::erase_if(rest.contacts, [kind](const ContactForce& contact) { return force_class(contact) == kind; });
    return picture_of(rest, options);
  };
  for (const auto& [kind, colour, pixels] : {std::tuple{ForceClass::compression, style::kCompressiveForce, 5000},
                                             {ForceClass::tension, style::kTensileForce, 100},
                                             {ForceClass::broken, style::kBrokenForce, 100},
                                             {ForceClass::general, style::kGeneralForce, 100}}) {
    CAPTURE(static_cast<int>(kind));
    CHECK(all.count(colour) - without_class(kind).count(colour) > pixels);
  }
}

TEST_CASE("A line is as wide as its force is large, up to the frame's 99th percentile") {
  Frame frame = test::synthetic_disc();
  frame.contacts.assign(1000, {{0, 0}, {1, 0}, {0.5, 0}, 10, 0, ContactKind::bonded});
  frame.contacts[0].normal_n = -1e6;
  View view = fit_view(frame, {0, 0, 1000, 1000});
  const ForceScale scale = force_scale(frame, {}, view, 1);
  CHECK(scale.largest_n == 10);
  CHECK(scale.width(5) == 0.5 * scale.widest);
  CHECK(scale.width(-5) == scale.width(5));
  CHECK(scale.width(1e6) == scale.widest);
  CHECK(scale.width(0) == scale.narrowest);
  PictureOptions fixed;
  fixed.value_range = Range{0, 20};
  CHECK(force_scale(frame, fixed, view, 1).width(10) == 0.5 * scale.widest);
}

TEST_CASE("Within a run each frame has its own line widths, but forces of next to nothing stay thin") {
  Frame frame = test::synthetic_disc();
  frame.contacts.assign(100, {{0, 0}, {1, 0}, {0.5, 0}, 10, 0, ContactKind::bonded});
  CHECK(range_in_run(frame, Field::contacts, Range{0, 40})->high == 10);
  CHECK(range_in_run(frame, Field::contacts, Range{0, 4000})->high == 80);
  CHECK(range_in_run(frame, Field::stress, Range{-3, 3})->high == 3);
  CHECK_FALSE(range_in_run(frame, Field::cracks, std::nullopt).has_value());
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

TEST_CASE("Of many fragments no two neighbours have one colour, and none but the largest is pale") {
  for (Frame frame : {test::synthetic_disc(), test::synthetic_rectangle()}) {
    for (std::size_t i = 0; i < frame.fragment.size(); ++i) frame.fragment[i] = static_cast<int>(i / 4);
    const auto order = fragments_by_area(frame);
    const auto colours = fragment_colours(frame, order);
    REQUIRE(order.size() > 300);
    int pairs = 0, alike = 0;
    for (const auto& [t, u] : adjacent_triangles(frame)) {
      const int a = frame.fragment[static_cast<std::size_t>(t)], b = frame.fragment[static_cast<std::size_t>(u)];
      if (a == b) continue;
      ++pairs;
      alike += colours.at(a) == colours.at(b);
    }
    CHECK(pairs > 1000);
    CHECK(alike == 0);
    CHECK(colours.at(order.front().fragment) == style::kLargestFragment);
    CHECK(std::count_if(colours.begin(), colours.end(),
                        [](const auto& entry) { return entry.second == style::kLargestFragment; }) == 1);
  }
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
  CHECK(test::file_bytes(run / "frames/cracks_000001.jpg").starts_with("\xFF\xD8\xFF"));
  CHECK(fs::file_size(run / "frames/cracks_000001.jpg") < fs::file_size(run / "frames/cracks_000001.png") / 2);
  const Colour high = colour_at(ColourMap::viridis, 1);
  CHECK(test::read_picture(run / "frames/shear_stress_000000.png").count(high) == 0);
  CHECK(test::read_picture(run / "frames/shear_stress_000001.png").count(high) > 100);
}

TEST_CASE("A run without a series of contacts can be drawn again, but not its contacts") {
  const fs::path run = test::scratch("render_older_run");
  SeriesWriter(run).write(test::synthetic_disc());
  fs::remove_all(run / "contacts");
  fs::remove(run / "contacts.pvd");
  draw_series(run, {Field::damage}, {0}, {});
  CHECK(fs::exists(run / "frames/damage_000000.png"));
  CHECK_THROWS_WITH(draw_series(run, {Field::contacts}, {0}, {}), Catch::Contains("contacts.pvd"));
  CHECK_FALSE(fs::exists(run / "frames/contacts_000000.png"));
}

TEST_CASE("Loose pieces are shown beside the room of the specimen, near the picture's edge, and no farther") {
  const auto pieces = [](double shift_mm) {
    Frame frame = test::synthetic_disc();
    const int node = static_cast<int>(frame.position.size());
    for (const Vec2 p : {Vec2{-27, 0}, Vec2{-26, 0}, Vec2{-26.5, 1}}) {
      frame.position.push_back(p - Vec2{shift_mm, 0});
      frame.displacement.push_back({-shift_mm, 0});
      frame.velocity.push_back({});
    }
    frame.triangles.push_back({node, node + 1, node + 2});
    frame.stress.push_back({});
    frame.damage.push_back(0);
    frame.grain.push_back(-1);
    frame.fragment.push_back(9);
    const Drawing drawing = draw_picture(frame, options_for(Field::fragments));
    double left = drawing.width;
    for (const Shape& shape : drawing.shapes)
      if (const Triangle* triangle = std::get_if<Triangle>(&shape))
        for (const Vec2 p : triangle->corners) left = std::min(left, p.x);
    return left;
  };
  CHECK(pieces(3.5) < 36);  // the margin
  CHECK(pieces(3.5) > 0);
  CHECK(pieces(30) > 36);
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

TEST_CASE("A picture of a series that cannot be written is an output error, whichever it is") {
  for (const char* name : {"cracks_000000.jpg", "damage_000000.png"}) {
    const fs::path run = test::scratch("render_no_series");
    SeriesWriter(run).write(test::synthetic_disc());
    fs::create_directories(run / "frames" / name);
    CHECK_THROWS_WITH(draw_series(run, {Field::cracks, Field::damage}, {0}, {}), Catch::Contains(name));
  }
}

TEST_CASE("Field names lead back to their fields") {
  for (const Field field : all_fields()) CHECK(field_from_name(field_name(field)) == field);
  CHECK_FALSE(field_from_name("colour").has_value());
}
