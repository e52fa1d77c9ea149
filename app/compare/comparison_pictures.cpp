#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/compare/comparison.hpp"
#include "app/report/quantities.hpp"
#include "render/charts.hpp"
#include "render/difference_map.hpp"
#include "render/paint.hpp"
#include "render/pattern_grid.hpp"
#include "render/series.hpp"
#include "render/side_panel.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

constexpr double kCurveWidth = 3;  // pixels

std::string state_of(const ComparedRun& run, const RunFrame& frame) {
  const bool sheared = run.config.experiment.type == ExperimentType::direct_shear;
  return fmt::format("{:.3g} {}, {:.2f} MPa", frame.abscissa, sheared ? "mm" : "%", frame.stress_mpa);
}

/// The largest share of any run's bins: all roses have one ring.
double outer_share(const Comparison& c) {
  double outer = 0;
  for (const MeasuredPattern& pattern : c.patterns)
    for (const double share : pattern.measures.orientation)
      if (std::isfinite(share)) outer = std::max(outer, share);
  return outer > 0 ? outer : 1;
}

std::string crack_words(const PatternMeasures& m) {
  return fmt::format("{:.0f} tension, {:.0f} shear, {:.0f} mm", m.cracks_tension, m.cracks_shear, m.crack_length_mm);
}

/// The edge at rest that a row of cracks.csv stands for, by the number of its contact.
std::map<int, std::array<Vec2, 2>> broken_edges(const CsvData& cracks, double until_s) {
  const CrackPattern lines = crack_pattern(cracks, until_s);
  const std::vector<double> contact = cracks.numbers("contact"), time = cracks.numbers("time_s");
  std::map<int, std::array<Vec2, 2>> edges;
  std::size_t next = 0;
  for (std::size_t i = 0; i < contact.size(); ++i)
    if (time[i] <= until_s) edges[static_cast<int>(contact[i])] = lines[next++].end;
  return edges;
}

std::vector<render::ComparedCrack> compared_cracks(const Comparison& c) {
  const auto first = broken_edges(c.runs[0].cracks, c.patterns[0].frame.time_s);
  const auto second = broken_edges(c.runs[1].cracks, c.patterns[1].frame.time_s);
  std::vector<render::ComparedCrack> cracks;
  for (const auto& [contact, end] : first)
    cracks.push_back({end, second.contains(contact) ? render::BrokenIn::both : render::BrokenIn::first});
  for (const auto& [contact, end] : second)
    if (!first.contains(contact)) cracks.push_back({end, render::BrokenIn::second});
  return cracks;
}

render::Stroke curve_stroke(std::size_t run) {
  const std::size_t looks = render::style::kLines.size();
  return {render::style::kLines[run % looks], kCurveWidth, render::style::kDashes[(run + run / looks) % looks],
          render::Cap::butt};
}

}  // namespace

void draw_comparison(const Comparison& c, const ComparisonFiles& files) {
  render::PatternGrid grid{
      title_of(c), capitalised(c.aligned.words) + "; nearest frames, one scale throughout.", c.field, {}};
  const double outer = outer_share(c);
  for (std::size_t i = 0; i < c.runs.size(); ++i) {
    const PatternMeasures& m = c.patterns[i].measures;
    render::PatternPanel panel{c.patterns[i].frame, c.runs[i].letter + "  " + c.runs[i].name, {c.labels[i]}, {}};
    panel.lines.push_back(state_of(c.runs[i], c.aligned.frames[i].frame) +
                          (c.aligned.frames[i].reached ? "" : " (its end)"));
    panel.lines.push_back(crack_words(m));
    panel.rose = {{m.orientation.begin(), m.orientation.end()}, outer};
    grid.panels.push_back(std::move(panel));
  }
  render::write_png(render::draw_pattern_grid(grid), files.picture);
}

void draw_comparison_curves(const Comparison& c, const ComparisonFiles& files) {
  const ExperimentType type = c.runs.front().config.experiment.type;
  render::Chart chart{"", abscissa_of(type).label, stress_label(type), {}, {}, {}, {}};
  for (std::size_t i = 0; i < c.runs.size(); ++i) {
    const CsvData& curves = c.runs[i].curves;
    chart.layers.emplace_back(render::LineLayer{c.runs[i].letter + "  " + c.runs[i].name,
                                                abscissae(curves, abscissa_of(type)),
                                                curves.numbers(stress_column(type)), curve_stroke(i)});
  }
  for (std::size_t i = 0; i < c.runs.size(); ++i) {
    const RunFrame& frame = c.aligned.frames[i].frame;
    chart.layers.emplace_back(render::PointLayer{i == 0 ? "frames compared" : "",
                                                 {frame.abscissa},
                                                 {frame.stress_mpa},
                                                 {render::MarkerShape::disc, render::style::kInk, 7},
                                                 {},
                                                 {},
                                                 {c.runs[i].letter}});
  }
  render::ChartFigure figure;
  figure.title = "Curves, and where the frames were taken";
  figure.charts.push_back(std::move(chart));
  figure.height = 1000;
  render::write_png(render::draw_figure(figure), files.beside("_curves.png"));
}

bool draw_difference(const Comparison& c, const ComparisonFiles& files) {
  if (c.runs.size() != 2 || !same_mesh(c.patterns[0].frame, c.patterns[1].frame)) return false;
  const render::DifferenceMap map{
      render::experiment_texts(c.patterns[0].frame).title + ": what two runs on one mesh differ by",
      "A: " + c.labels[0] + ".  B: " + c.labels[1] + ".  " + capitalised(c.aligned.words) + ", drawn at rest.",
      {"A", "B"},
      c.patterns[0].frame,
      c.patterns[1].frame,
      compared_cracks(c)};
  render::write_png(render::draw_difference_map(map), files.beside("_difference.png"));
  return true;
}

std::vector<RunFrame> montage_frames(const ComparedRun& run, std::size_t count) {
  const std::vector<double> breaks = run.cracks.numbers("time_s"), times = run.curves.numbers("time_s");
  const auto earliest = std::min_element(breaks.begin(), breaks.end());
  std::size_t first = 0;
  while (earliest != breaks.end() && first + 1 < run.frames.size() && times[run.frames[first + 1].row] < *earliest)
    ++first;
  const std::size_t steps = run.frames.size() - 1 - first, shown = std::min(count, steps + 1);
  if (shown == 1) return {run.frames.back()};
  std::vector<RunFrame> frames;
  for (std::size_t i = 0; i < shown; ++i)
    frames.push_back(run.frames[first + (2 * i * steps + shown - 1) / (2 * (shown - 1))]);
  return frames;
}

void draw_montage(const ComparedRun& run, std::size_t count, render::Field field,
                  const std::filesystem::path& picture) {
  render::PatternGrid grid;
  grid.field = field;
  const std::vector<RunFrame> frames = montage_frames(run, count);
  for (const RunFrame& frame : frames)
    grid.panels.push_back({render::read_frame(run.folder, frame.number), state_of(run, frame), {}, {}});
  const render::ExperimentTexts texts = render::experiment_texts(grid.panels.front().frame);
  grid.title = texts.title + ": " + std::string(render::field_name(field)) + " of " + run.name + " through time";
  grid.subtitle = fmt::format("{} of {} frames; under each {} and {}. One scale throughout.", frames.size(),
                              run.frames.size(), texts.strain, texts.stress);
  render::write_png(render::draw_pattern_grid(grid), picture);
}

}  // namespace asperity::app
