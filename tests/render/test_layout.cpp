#include <catch2/catch.hpp>
#include <limits>

#include "render/plots.hpp"
#include "render/scene.hpp"
#include "tests/render/text_checks.hpp"
#include "tests/support/synthetic_frame.hpp"

using namespace asperity;
using namespace asperity::render;
using asperity::test::check_texts;
using asperity::test::kSmallestText;

namespace {

Frame crumbled(Frame frame) {
  for (std::size_t i = 0; i < frame.fragment.size(); ++i) frame.fragment[i] = static_cast<int>(i / 20);
  return frame;
}

}  // namespace

TEST_CASE("No text of a picture is clipped, tiny or over another, for any field and size") {
  Frame bare;
  bare.experiment = "uniaxial";
  for (const Frame& frame :
       {test::synthetic_disc(), test::synthetic_rectangle(), crumbled(test::synthetic_disc()), bare})
    for (const Field field : all_fields())
      for (const auto& [width, height] : {std::pair{1600, 1200}, {800, 600}, {1920, 1080}, {1200, 1200}}) {
        CAPTURE(frame.name, field_name(field), width, height);
        PictureOptions options;
        options.field = field;
        options.width = width;
        options.height = height;
        check_texts(draw_picture(frame, options), kSmallestText * std::min(width / 1600.0, height / 1200.0));
      }
}

TEST_CASE("Long names, large numbers and exaggerated displacements still fit") {
  Frame frame = test::synthetic_rectangle();
  frame.name = "a name that somebody made as long as this, to see whether the title still fits";
  frame.stress_mpa = -12345.678;
  frame.curve.stress_mpa.back() = 2.5e6;
  PictureOptions options;
  options.displacement_scale = 25;
  check_texts(draw_picture(frame, options), kSmallestText);
}

TEST_CASE("Specimens fill the picture: a disc over half its width, a tall one over three quarters of its height") {
  for (const Frame& frame : {test::synthetic_disc(), test::synthetic_rectangle()}) {
    Box box{1e9, 1e9, 0, 0};
    for (const Shape& shape : draw_picture(frame, {}).shapes)
      if (const Triangle* triangle = std::get_if<Triangle>(&shape))
        for (const Vec2 p : triangle->corners)
          box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x), std::max(box.bottom, p.y)};
    CAPTURE(frame.name);
    CHECK((box.width() > 800 || box.height() > 900));
  }
}

TEST_CASE("No text of a plot is clipped or over another") {
  Plot plot;
  plot.title = "Energy budget, σ₃ = 0.5 MPa";
  plot.x_label = "Axial strain ε₁ [%]";
  plot.y_label = "Energy [N mm]";
  plot.second_y_label = "Broken contacts [–]";
  for (int s = 0; s < 7; ++s) {
    PlotSeries series{"a rather long label, number " + std::to_string(s), {}, {}, {}};
    for (int i = 0; i < 50; ++i) {
      series.x.push_back(1e-7 * i);
      series.y.push_back(-1e6 * i * s);
    }
    if (s == 6) series.style.axis = VerticalAxis::right;
    plot.series.push_back(series);
  }
  check_texts(draw_plot(plot), kSmallestText);
}
