#include <catch2/catch.hpp>
#include <cmath>

#include "render/effect_plots.hpp"
#include "render/fit_plots.hpp"
#include "render/outcome_plots.hpp"
#include "render/paint.hpp"
#include "render/style.hpp"
#include "render/surface_plots.hpp"
#include "tests/render/picture_file.hpp"
#include "tests/render/text_checks.hpp"

using namespace asperity;
using namespace asperity::render;
using test::check_texts;
using test::kSmallestText;

namespace {

double strength(double x, double y) { return 0.75 + 0.28 * x + 0.14 * y + 0.11 * x * y - 0.12 * y * y; }

SurfacePlot surface() {
  SurfacePlot plot;
  plot.heading = "held: φ_{c} = 40°";
  plot.x_label = "t_{c} [MPa]";
  plot.y_label = "c_{c} [MPa]";
  plot.value_label = "tensile strength σ_{t} [MPa]";
  plot.grid = sample_grid({-1.7, 1.7}, {-1.7, 1.7}, 41, strength);
  plot.targets = {{plot.grid, 0.9, "0.9"}};
  plot.points = {
      {{-1, -1}, DesignPointKind::factorial}, {{1.7, 0}, DesignPointKind::star}, {{0, 0}, DesignPointKind::centre}};
  plot.solution = Vec2{0.7, 0.4};
  plot.region = FactorBox{{0.4, 1}, {0, 0.8}};
  return plot;
}

ChartFigure surfaces(int count) {
  ChartFigure figure;
  figure.title = "Response surface: tensile strength";
  figure.caption = "Other factors at the solution.";
  figure.charts.assign(static_cast<std::size_t>(count), surface_chart(surface()));
  figure.columns = std::min(3, count);
  figure.height = count == 1 ? 1200 : 330 + 480 * ((count + 2) / 3);
  return figure;
}

EffectCurve curve(double slope) {
  EffectCurve c;
  for (int i = 0; i < 11; ++i) {
    c.x.push_back(i);
    c.mean.push_back(slope * i);
    c.lower.push_back(slope * i - 1);
    c.upper.push_back(slope * i + 1);
  }
  return c;
}

FittedResponse response() {
  FittedResponse r{"Tensile strength", "σ_{t} [MPa]", {}, {}, {}, {}, {}, 0.1};
  for (int i = 0; i < 20; ++i) {
    r.fitted.push_back(0.1 * i);
    r.studentised.push_back(i == 7 ? 2.6 : std::sin(9.0 * i));
    r.simulated.push_back(r.fitted.back() + 0.1 * r.studentised.back());
    r.rows.push_back(i + 1);
    r.points.push_back({{}, i < 14 ? DesignPointKind::factorial : DesignPointKind::centre});
  }
  return r;
}

VerifiedProperty property(const std::string& name, double bias) {
  return {name, 2, 2 * (1 + bias), 0.02, 0.05, 2.01, {2 * (1 + bias) - 0.02, 2 * (1 + bias), 2 * (1 + bias) + 0.02}};
}

int lines_in(const Drawing& drawing, Colour colour) {
  int count = 0;
  for (const Shape& shape : drawing.shapes)
    if (const auto* line = std::get_if<Polyline>(&shape)) count += line->stroke.colour == colour;
  return count;
}

}  // namespace

TEST_CASE("A surface is filled bands, labelled lines, the target and what is marked on it") {
  const Chart chart = surface_chart(surface());
  const auto* field = std::get_if<FieldLayer>(&chart.layers.front());
  REQUIRE(field);
  CHECK(field->levels.size() > 5);
  const Drawing drawing = draw_figure(surfaces(1));
  check_texts(drawing, kSmallestText);
  for (const char* label :
       {"target", "factorial points", "star points", "centre points", "95 % region", "solution", "0.9"}) {
    CAPTURE(label);
    CHECK(test::has_text(drawing, label));
  }
  CHECK(lines_in(drawing, style::kVermilion) >= 2);  // the target's line and its swatch
}

TEST_CASE("Small multiples of surfaces keep their texts apart, with one colour bar or one each") {
  for (const int count : {2, 3, 6})
    for (const ColourBars bars : {ColourBars::each, ColourBars::shared}) {
      ChartFigure figure = surfaces(count);
      figure.colour_bars = bars;
      figure.letters = Letters::each;
      CAPTURE(count);
      check_texts(draw_figure(figure), kSmallestText);
    }
}

TEST_CASE("A target that no point reaches has no line, and a constant surface no hole") {
  SurfacePlot plot = surface();
  plot.targets[0].value = 50;
  plot.grid = sample_grid({-1, 1}, {-1, 1}, 11, [](double, double) { return 3.0; });
  ChartFigure figure = surfaces(1);
  figure.charts = {surface_chart(plot)};
  check_texts(draw_figure(figure), kSmallestText);
}

TEST_CASE("A surface is the same bytes each time, as PNG and as SVG") {
  const auto folder = test::scratch("render_surface");
  for (const char* name : {"a", "b"}) {
    write_png(draw_figure(surfaces(3)), folder / (std::string(name) + ".png"));
    write_svg(draw_figure(surfaces(3)), folder / (std::string(name) + ".svg"));
  }
  CHECK(test::file_bytes(folder / "a.png") == test::file_bytes(folder / "b.png"));
  CHECK(test::file_bytes(folder / "a.svg") == test::file_bytes(folder / "b.svg"));
  CHECK(test::read_picture(folder / "a.png").count(style::kVermilion) > 500);
}

TEST_CASE("Main effects are a row a response and a column a factor, a row sharing its y axis") {
  MainEffects effects{"Main effects", "Other factors at the centre.", {"t_{c} [MPa]", "c_{c} [MPa]", "φ_{c} [°]"}, {}};
  effects.rows = {{"σ_{t} [MPa]", {curve(1), curve(-1), curve(0)}, 4.0},
                  {"C [MPa]", {curve(2), curve(0.5), curve(0)}, {}}};
  const ChartFigure figure = main_effects(effects);
  REQUIRE(figure.charts.size() == 6);
  CHECK(figure.columns == 3);
  CHECK(figure.charts[0].y_range->low == figure.charts[2].y_range->low);
  CHECK(figure.charts[0].y_label == "σ_{t} [MPa]");
  CHECK(figure.charts[1].y_label.empty());
  CHECK(figure.charts[5].x_label == "φ_{c} [°]");
  const Drawing drawing = draw_figure(figure);
  check_texts(drawing, kSmallestText);
  CHECK(test::has_text(drawing, "95 % confidence band"));
}

TEST_CASE("Interactions are three lines a pair that differ in dash as in colour") {
  Interactions given{"Interactions", "", {"at −1", "at 0", "at +1"}, {}};
  given.rows = {{"σ_{t} [MPa]", {{"along t_{c}, lines: c_{c}", "t_{c} [MPa]", {curve(1), curve(2), curve(3)}}}}};
  const ChartFigure figure = interactions(given);
  REQUIRE(figure.charts.size() == 1);
  std::vector<std::vector<double>> dashes;
  for (const Layer& layer : figure.charts[0].layers) dashes.push_back(std::get<LineLayer>(layer).stroke.dash);
  REQUIRE(dashes.size() == 3);
  CHECK(dashes[0] != dashes[1]);
  CHECK(dashes[1] != dashes[2]);
  check_texts(draw_figure(figure), kSmallestText);
}

TEST_CASE("Fits and residuals: equal scales, the run beyond two standard deviations is named") {
  const Chart fit = predicted_against_simulated(response());
  CHECK(fit.x_range->low == fit.y_range->low);
  CHECK(fit.x_range->high == fit.y_range->high);
  ChartFigure figure;
  figure.title = "Residuals";
  figure.charts = {fit, normal_probability(response()), residual_against_fitted(response()),
                   residual_against_row(response())};
  figure.columns = 2;
  const Drawing drawing = draw_figure(figure);
  check_texts(drawing, kSmallestText);
  int named = 0;
  for (const Text& text : test::texts_of(drawing)) named += text.text == "run 8";
  CHECK(named == 4);
  CHECK(test::has_text(drawing, "centre points"));
}

TEST_CASE("Normal scores are Blom's") {
  FittedResponse r = response();
  r.studentised = {0.3, -1, 2};
  r.simulated = r.fitted = {1, 2, 3};
  r.points.clear();
  r.rows = {1, 2, 3};
  for (const Layer& layer : normal_probability(r).layers)
    if (const auto* points = std::get_if<PointLayer>(&layer)) {
      // Quantiles of 0.625/3.25, 1.625/3.25 and 2.625/3.25 from tables.
      CHECK(points->x[1] == Approx(-0.8694).margin(1e-4));
      CHECK(points->x[0] == Approx(0).margin(1e-12));
      CHECK(points->x[2] == Approx(0.8694).margin(1e-4));
    }
}

TEST_CASE("Verification bars show the mean, the tolerance and every mesh; outside is another colour and word") {
  const ChartFigure figure = verification_bars(
      "Verification", {property("E\nYoung's\nmodulus", 0.01), property("σ_{t}\nTensile\nstrength", -0.17),
                       property("σ_{c}\nUniaxial\nstrength", 0.02), property("φ\nFriction\nangle", 0)});
  const Drawing drawing = draw_figure(figure);
  check_texts(drawing, kSmallestText);
  for (const char* text :
       {"mean within tolerance", "mean outside tolerance", "tolerance", "−17.0 ± 1.0 %", "single meshes"}) {
    CAPTURE(text);
    CHECK(test::has_text(drawing, text));
  }
}

TEST_CASE("A trade-off names its sets by letter, in the plot and in the legend") {
  TradeOff given{"Trade-off",  "", "uniaxial strength σ_{c} [MPa]", "tensile strength σ_{t} [MPa]", {7.1, 7.9},
                 {1.52, 1.68}, {}};
  for (int i = 0; i < 8; ++i)
    given.sets.push_back({"a verified set with a name that is rather long, number " + std::to_string(i),
                          7.5 + 0.05 * i,
                          1.3 + 0.02 * i,
                          0.2,
                          0.03,
                          {7.4, 7.6},
                          {1.3, 1.35}});
  const Drawing drawing = draw_figure(trade_off(given));
  check_texts(drawing, kSmallestText);
  CHECK(test::has_text(drawing, "both targets met"));
  CHECK(test::has_text(drawing, "H"));
}
