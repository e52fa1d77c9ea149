#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/confrontation/condition_tables.hpp"
#include "app/confrontation/confrontation_chapters.hpp"
#include "app/confrontation/confrontation_pictures.hpp"
#include "app/confrontation/words.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;

constexpr double kNotable = 2;  // standard deviations

std::string decimals(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  return (value < 0 ? "−" : "") + fmt::format("{:.{}f}", std::abs(value), digits);
}

PlainTable wrong_table(const ConfrontationData& data) {
  PlainTable table{
      "Features of the fitted tests, worst first. z: measured less calibrated simulation, over the standard deviation "
      "of "
      "that difference. "
      "Left out: the same after a calibration that did not see this test; – where that would leave a parameter open.",
      {{"Test", "", ColumnKind::head},
       {"Feature", "", ColumnKind::text},
       {"Measured", ""},
       {"Simulated", ""},
       {"z", ""},
       {"Difference", "%"},
       {"Simulated, left out", ""},
       {"z, left out", ""}},
      {}};
  for (const Value& r : data.verdict["wrong"].items()) {
    const double z = r["z"].number();
    table.rows.push_back({{r["test"].text(), feature_with_unit(data, r["test"].text(), r["feature"].text()),
                           figures(r["measured"].number(), 4), figures(r["simulated"].number(), 4), decimals(z, 1),
                           decimals(r["percent"].number(), 1), figures(r["simulated_left_out"].number(), 4),
                           decimals(r["z_left_out"].number(), 1)},
                          std::abs(z) > kNotable ? html::RowTone::bad : html::RowTone::plain});
  }
  return table;
}

/// One row a test and reason.
PlainTable dropped_table(const ConfrontationData& data) {
  PlainTable table{"Features that were not compared.",
                   {{"Test", "", ColumnKind::head}, {"Why", "", ColumnKind::text}, {"Features", "", ColumnKind::prose}},
                   {}};
  for (const Value& d : data.verdict["left_out"].items()) {
    const std::string test = d["test"].text(), why = d["why"].text(), feature = feature_words(d["feature"].text());
    const auto same = std::find_if(table.rows.begin(), table.rows.end(),
                                   [&](const PlainRow& row) { return row.cells[0] == test && row.cells[1] == why; });
    if (same == table.rows.end())
      table.rows.push_back({{test, why, feature}, html::RowTone::quiet});
    else
      same->cells[2] += ", " + feature;
  }
  return table;
}

std::string summary_words(const ConfrontationData& data) {
  std::size_t notable = 0;
  for (const ShownSlot& slot : data.slots) notable += std::abs(slot.z_base) > kNotable;
  return fmt::format(
      "{} of {} features of the fitted tests lie more than two standard deviations from the calibrated "
      "base; chance alone would make about {} of them do so.",
      notable, data.slots.size(), figures(0.0455 * static_cast<double>(data.slots.size()), 2));
}

void add_failures(const ConfrontationData& data, Chapter& chapter) {
  std::vector<std::string> failures;
  for (const ShownTest& test : data.tests) {
    for (const auto* runs : {&test.base, &test.extension}) {
      for (const ShownCurve& run : *runs) {
        if (run.path.empty()) failures.push_back(test.id + ": a run that was to be shown failed: " + run.reason);
      }
    }
  }
  if (!failures.empty()) chapter.blocks.emplace_back(Bullets{failures});
}

}  // namespace

Chapter wrong_chapter(const ConfrontationData& data) {
  Chapter chapter{"What is wrong", {}};
  if (data.slots.empty()) return chapter;
  chapter.blocks.emplace_back(Paragraph{summary_words(data)});
  const std::string models = data.extension.empty() ? "of the base." : "of the base and of the extension.";
  chapter.blocks.emplace_back(draw_bars(
      data, residual_bars(data),
      {"residuals", "", "Bars of measured less simulated features in standard deviations, test by test, " + models,
       "Residuals of the fitted tests in standard deviations, not projected, " + models}));
  chapter.blocks.emplace_back(wrong_table(data));
  for (PlainTable& part : std::vector<PlainTable>{dropped_table(data), features_table(data)}) {
    if (!part.rows.empty()) chapter.blocks.emplace_back(std::move(part));
  }
  return chapter;
}

Chapter curves_chapter(const ConfrontationData& data) {
  Chapter chapter{"Curves and strengths", {}};
  const std::string by = data.extension.empty() ? "" : " (" + extension_name(data) + ")";
  int number = 0;
  for (const render::ChartFigure& figure : curve_figures(data))
    chapter.blocks.emplace_back(draw_charts(
        data, figure,
        {"curves_" + std::to_string(++number), "",
         "Measured curves of every specimen over the simulated curves of the base and the extension, one "
         "panel a test.",
         "Black: measured specimens. Bands: base and extension" + by + ", between their meshes as far as all reach."}));
  if (const auto strengths = strength_figure(data))
    chapter.blocks.emplace_back(draw_charts(
        data, *strengths,
        {"strength", "", "Peak axial stress over confining pressure: measured specimens, base and extension.",
         "Peak total axial stress of every specimen, and of the base and the extension" + by +
             " on their meshes. Open diamonds: tests that were kept back, so nothing was fitted to them."}));
  if (const auto joints = joint_strength_figure(data))
    chapter.blocks.emplace_back(
        draw_charts(data, *joints,
                    {"joint_strength", "", "Peak shear stress over normal stress: measured joints, base and extension.",
                     "Peak shear stress of every joint, and of the base and the extension" + by +
                         " on their meshes. Open diamonds: tests that were kept back."}));
  add_failures(data, chapter);
  return chapter;
}

}  // namespace asperity::app
