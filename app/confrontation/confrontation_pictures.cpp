#include "app/confrontation/confrontation_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/confrontation/words.hpp"
#include "core/base/output_error.hpp"
#include "core/config/enum_words.hpp"
#include "render/film_strip.hpp"
#include "render/paint.hpp"
#include "render/series.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPanels = 3;    // of fingerprints beside the residual
constexpr std::size_t kCompared = 8;  // fingerprints whose cosines are drawn
constexpr int kStripWidth = 1500;     // pixels

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw output_error(folder, "cannot be created", error.value());
}

/// `texts.png` is the name without folder and ending.
PlainFigure draw(const ConfrontationData& data, const render::Drawing& drawing, const PlainFigure& texts) {
  const fs::path name = fs::path("plots") / texts.png;
  PlainFigure figure = texts;
  figure.png = name.string() + ".png";
  figure.svg = name.string() + ".svg";
  make_folder(data.folder / "plots");
  render::write_png(drawing, data.folder / figure.png);
  render::write_svg(drawing, data.folder / figure.svg);
  return figure;
}

std::vector<render::BarRow> rows_of(const ConfrontationData& data) {
  std::vector<render::BarRow> rows;
  for (const ShownSlot& slot : data.slots) rows.push_back({slot.test, feature_words(slot.feature)});
  return rows;
}

render::BarPanel fingerprint_panel(const ConfrontationData& data, const ShownCandidate& candidate) {
  const double amplitude = explaining_amplitude(data, candidate);
  render::BarPanel panel{candidate.id, {}, render::style::kVermilion};
  for (const double v : candidate.projected) panel.values.push_back(amplitude * v);
  return panel;
}

/// The last frame of the first mesh that kept one.
std::optional<Frame> last_frame(const std::vector<ShownCurve>& runs, const std::string& name) {
  for (const ShownCurve& run : runs) {
    if (run.folder.empty() || !fs::exists(run.folder / "fields.pvd")) continue;
    const std::size_t frames = render::series_times(run.folder).size();
    if (frames == 0) continue;
    Frame frame = render::read_frame(run.folder, static_cast<int>(frames) - 1);
    frame.name = name;
    return frame;
  }
  return std::nullopt;
}

double stress_of(const ShownTest& test) {
  return test.normal_stress_mpa.value_or(test.confining_pressure_mpa.value_or(0.0));
}

/// Whether both models' runs are there, or the base's alone where nothing extends it.
bool draw_pattern(const ConfrontationData& data, const ShownTest& test, const fs::path& png) {
  std::vector<render::StripPanel> panels;
  if (auto frame = last_frame(test.base, test.id + ", base")) panels.push_back({std::move(*frame), "base, calibrated"});
  if (auto frame = last_frame(test.extension, test.id + ", extension"))
    panels.push_back({std::move(*frame), "with " + extension_name(data)});
  if (panels.size() < (data.extension.empty() ? 1U : 2U)) return false;
  make_folder(png.parent_path());
  const int width = panels.size() == 1 ? kStripWidth / 2 : kStripWidth;
  render::write_png(render::draw_film_strip(panels, render::Field::cracks, width), png);
  return true;
}

/// The picture and its words; nothing where neither runs nor an earlier picture are there.
std::optional<PlainFigure> pattern_figure(const ConfrontationData& data, const ShownTest& test,
                                          const std::string& name) {
  const fs::path png = fs::path("pictures") / (name + ".png");
  if (!draw_pattern(data, test, data.folder / png) && !fs::exists(data.folder / png)) return std::nullopt;
  const bool both = !data.extension.empty();
  return PlainFigure{png, "",
                     "Crack networks at the end of test " + test.id +
                         (both ? ": the base left, the extension right." : " in the base."),
                     test_title(test) + ": cracks at the end of the first mesh's run" +
                         (both ? " of the base (left) and of the extension (right), at one scale." : " of the base.") +
                         " Blue: broken in tension; vermilion with a white core: in shear; thin purple: softening."};
}

/// The test of the same experiment whose stress differs most from this one's; itself where none does.
const ShownTest& farthest_in_stress(const ConfrontationData& data, const ShownTest& from) {
  const ShownTest* farthest = &from;
  for (const ShownTest& test : data.tests) {
    const double away = std::abs(stress_of(test) - stress_of(from));
    if (test.experiment == from.experiment && away > std::abs(stress_of(*farthest) - stress_of(from))) farthest = &test;
  }
  return *farthest;
}

}  // namespace

std::string extension_name(const ConfrontationData& data) {
  std::string text;
  for (const std::string& id : data.extension) text += (text.empty() ? "" : " + ") + id;
  return text;
}

std::string test_title(const ShownTest& test) {
  std::string text = test.id + ": " + feature_words(word(test.experiment));
  if (test.confining_pressure_mpa) text += fmt::format(", σ₃ = {:g} MPa", *test.confining_pressure_mpa);
  if (test.normal_stress_mpa) text += fmt::format(", σₙ = {:g} MPa", *test.normal_stress_mpa);
  return text + (test.kept_back ? ", kept back" : "");
}

render::BarPanels residual_bars(const ConfrontationData& data) {
  render::BarPanels bars;
  bars.title = "Measured less simulated, fitted tests";
  bars.caption =
      "Bars to the right: the laboratory measured more than the model gives. Dashed: two standard deviations.";
  bars.x_label = "difference over its standard deviation [–]";
  bars.rows = rows_of(data);
  bars.panels.push_back({"base, calibrated", {}, render::style::kBlue});
  if (!data.extension.empty()) bars.panels.push_back({"with " + extension_name(data), {}, render::style::kVermilion});
  for (const ShownSlot& slot : data.slots) {
    bars.panels.front().values.push_back(slot.z_base);
    if (!data.extension.empty()) bars.panels.back().values.push_back(slot.z_extension);
  }
  return bars;
}

render::BarPanels fingerprint_bars(const ConfrontationData& data) {
  render::BarPanels bars;
  bars.title = "What is left, and what would make it";
  bars.caption =
      "Left: what calibration leaves. Then each mechanism's fingerprint, scaled to fit best: the pattern counts, the "
      "strength is the refit's. In standard deviations, without what calibration absorbs; within a test, each feature "
      "beyond what those above it imply.";
  bars.x_label = "projected difference [standard deviations]";
  bars.rows = rows_of(data);
  bars.panels.push_back({"measured less base", {}, render::style::kBlue});
  for (const ShownSlot& slot : data.slots) bars.panels.front().values.push_back(slot.projected);
  for (const std::string& id : leading_candidates(data, kPanels)) {
    if (const ShownCandidate* candidate = find_candidate(data, id))
      bars.panels.push_back(fingerprint_panel(data, *candidate));
  }
  return bars;
}

std::optional<render::MatrixPlot> cosine_picture(const ConfrontationData& data) {
  std::vector<const ShownCandidate*> compared;
  for (const std::string& id : leading_candidates(data, kCompared)) {
    if (const ShownCandidate* candidate = find_candidate(data, id)) compared.push_back(candidate);
  }
  if (compared.size() < 2) return std::nullopt;
  std::vector<std::string> names;
  std::vector<std::vector<double>> cosines;
  for (const ShownCandidate* a : compared) {
    names.push_back(a->id);
    cosines.emplace_back();
    for (const ShownCandidate* b : compared) cosines.back().push_back(cosine(a->projected, b->projected));
  }
  return render::cosine_matrix(names, cosines);
}

PlainFigure draw_bars(const ConfrontationData& data, const render::BarPanels& bars, const PlainFigure& texts) {
  return draw(data, render::draw_bar_panels(bars), texts);
}

PlainFigure draw_matrix(const ConfrontationData& data, const render::MatrixPlot& matrix, const PlainFigure& texts) {
  return draw(data, render::draw_matrix(matrix), texts);
}

PlainFigure draw_charts(const ConfrontationData& data, const render::ChartFigure& figure, const PlainFigure& texts) {
  return draw(data, render::draw_figure(figure), texts);
}

std::vector<PlainFigure> pattern_figures(const ConfrontationData& data) {
  std::vector<PlainFigure> figures;
  std::map<ExperimentType, const ShownTest*> first;
  for (const ShownTest& test : data.tests) {
    if (first.contains(test.experiment)) continue;
    if (auto figure = pattern_figure(data, test, std::string(word(test.experiment)))) {
      first[test.experiment] = &test;
      figures.push_back(std::move(*figure));
    }
  }
  for (const auto& [experiment, test] : first) {
    const ShownTest& other = farthest_in_stress(data, *test);
    if (stress_of(other) == stress_of(*test)) continue;
    if (auto figure = pattern_figure(data, other, std::string(word(experiment)) + "_2"))
      figures.push_back(std::move(*figure));
  }
  return figures;
}

}  // namespace asperity::app
