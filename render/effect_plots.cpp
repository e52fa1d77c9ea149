#include "render/effect_plots.hpp"

#include <algorithm>

#include "render/style.hpp"

namespace asperity::render {
namespace {

constexpr int kRowHeight = 330, kHeadHeight = 150, kFootHeight = 150, kWidth = 1600;  // pixels
constexpr double kLineWidth = 5, kTargetWidth = 3;                                    // pixels
constexpr Colour kBandFill{0xB9, 0xD9, 0xEC};                                         // of style::kBlue, pale

Range range_of_curve(const EffectCurve& curve) {
  return united(range_of(curve.mean),
                curve.lower.empty() ? range_of(curve.mean) : united(range_of(curve.lower), range_of(curve.upper)));
}

Range range_of_row(const EffectRow& row) {
  Range range = range_of_curve(row.curves.front());
  for (const EffectCurve& curve : row.curves) range = united(range, range_of_curve(curve));
  if (row.target) range = united(range, {*row.target, *row.target});
  return with_headroom(range);
}

Chart effect_chart(const EffectCurve& curve, const EffectRow& row) {
  Chart chart;
  chart.x_range = range_of(curve.x);
  if (!curve.lower.empty())
    chart.layers.emplace_back(BandLayer{"95 % confidence band", curve.x, curve.lower, curve.upper, kBandFill});
  if (row.target)
    chart.layers.emplace_back(LineLayer{"target",
                                        {chart.x_range->low, chart.x_range->high},
                                        {*row.target, *row.target},
                                        {style::kVermilion, kTargetWidth, {14, 8}, Cap::butt}});
  chart.layers.emplace_back(LineLayer{"model", curve.x, curve.mean, {style::kBlue, kLineWidth, {}, Cap::butt}});
  return chart;
}

/// Inner charts share the axes of the first column and the last row.
void share_axes(Chart& chart, std::size_t column, bool last_row, const std::string& x, const std::string& y) {
  if (last_row) chart.x_label = x;
  if (column == 0) chart.y_label = y;
}

ChartFigure rows_of_charts(const std::string& title, const std::string& caption, std::size_t rows) {
  ChartFigure figure;
  figure.title = title;
  figure.caption = caption;
  figure.letters = Letters::each;
  figure.width = kWidth;
  figure.height = kHeadHeight + kFootHeight + kRowHeight * static_cast<int>(rows);
  return figure;
}

Chart interaction_chart(const InteractionPair& pair, const Interactions& given) {
  static constexpr std::array<Colour, 3> colours{style::kBlue, style::kInk, style::kVermilion};
  static const std::array<std::vector<double>, 3> dashes{std::vector<double>{}, {5, 8}, {22, 10}};
  Chart chart;
  chart.heading = pair.heading;
  for (std::size_t i = 0; i < 3; ++i)
    chart.layers.emplace_back(LineLayer{
        given.level_names[i], pair.curves[i].x, pair.curves[i].mean, {colours[i], kLineWidth, dashes[i], Cap::butt}});
  chart.x_range = range_of(pair.curves[0].x);
  return chart;
}

Range range_of_pairs(const InteractionRow& row) {
  Range range = range_of_curve(row.pairs.front().curves[0]);
  for (const InteractionPair& pair : row.pairs)
    for (const EffectCurve& curve : pair.curves) range = united(range, range_of(curve.mean));
  return with_headroom(range);
}

}  // namespace

ChartFigure main_effects(const MainEffects& effects) {
  ChartFigure figure = rows_of_charts(effects.title, effects.caption, effects.rows.size());
  figure.columns = static_cast<int>(std::max<std::size_t>(1, effects.factor_labels.size()));
  for (std::size_t r = 0; r < effects.rows.size(); ++r) {
    const EffectRow& row = effects.rows[r];
    for (std::size_t c = 0; c < row.curves.size(); ++c) {
      Chart chart = effect_chart(row.curves[c], row);
      chart.y_range = range_of_row(row);
      share_axes(chart, c, r + 1 == effects.rows.size(), effects.factor_labels[c], row.label);
      figure.charts.push_back(std::move(chart));
    }
  }
  return figure;
}

ChartFigure interactions(const Interactions& given) {
  ChartFigure figure = rows_of_charts(given.title, given.caption, given.rows.size());
  figure.columns = 1;
  for (std::size_t r = 0; r < given.rows.size(); ++r) {
    const InteractionRow& row = given.rows[r];
    figure.columns = std::max(figure.columns, static_cast<int>(row.pairs.size()));
    for (std::size_t c = 0; c < row.pairs.size(); ++c) {
      Chart chart = interaction_chart(row.pairs[c], given);
      chart.y_range = range_of_pairs(row);
      share_axes(chart, c, r + 1 == given.rows.size(), row.pairs[c].x_label, row.label);
      figure.charts.push_back(std::move(chart));
    }
  }
  return figure;
}

}  // namespace asperity::render
