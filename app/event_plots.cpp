#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "app/crack_plots.hpp"
#include "app/run_frames.hpp"
#include "core/measurement/event_magnitudes.hpp"
#include "render/axes.hpp"
#include "render/charts.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

using render::Chart;
using render::LineLayer;
using render::MarkerShape;
using render::PointLayer;
using render::style::kBlue;
using render::style::kInk;
using render::style::kVermilion;

constexpr double kPointRadius = 8, kLineWidth = 4;  // pixels

/// Events of one bin of magnitudes, and of it and all above.
struct MagnitudeBin {
  double from = 0;
  int events = 0, at_least = 0;
};

std::vector<MagnitudeBin> bins_of(const std::vector<double>& magnitudes) {
  std::map<long, int> counts;
  for (const double m : magnitudes) ++counts[std::lround(std::floor(m / kMagnitudeBin))];
  std::vector<MagnitudeBin> bins;
  for (long k = counts.begin()->first; k <= counts.rbegin()->first; ++k)
    bins.push_back({kMagnitudeBin * static_cast<double>(k), counts.count(k) ? counts[k] : 0, 0});
  int sum = 0;
  for (auto bin = bins.rbegin(); bin != bins.rend(); ++bin) bin->at_least = sum += bin->events;
  return bins;
}

PointLayer points(const std::string& label, MarkerShape shape, render::Colour colour) {
  return {label, {}, {}, {shape, colour, kPointRadius}, {}, {}, {}};
}

/// log10 N = a - b M from the completeness to where less than one event is left.
LineLayer fit_line(const MagnitudeStatistics& s, double last) {
  const double b = *s.b, end = std::min(last, s.a() / b);
  return {fmt::format("b = {:.2f} ± {:.2f}, from {} events", b, *s.error, s.complete),
          {s.completeness, end},
          {s.a() - b * s.completeness, s.a() - b * end},
          {kVermilion, kLineWidth, {}, render::Cap::butt}};
}

Chart magnitude_chart(const std::vector<MagnitudeBin>& bins, const MagnitudeStatistics& statistics) {
  PointLayer all = points("events of at least M", MarkerShape::disc, kBlue),
             each = points(fmt::format("events of M to M + {:g}", kMagnitudeBin), MarkerShape::open_square, kInk);
  for (const MagnitudeBin& bin : bins) {
    all.x.push_back(bin.from);
    all.y.push_back(std::log10(bin.at_least));
    if (bin.events == 0) continue;
    each.x.push_back(bin.from);
    each.y.push_back(std::log10(bin.events));
  }
  const double top = 1.12 * std::log10(bins.front().at_least) + 0.1, last = bins.back().from + kMagnitudeBin;
  Chart chart;
  chart.x_label = "magnitude M = (2/3)(log₁₀E − 4.8), E in J [–]";
  chart.y_label = "number of events [–]";
  chart.layers.emplace_back(LineLayer{"completeness M_{c} = " + render::tick_label(statistics.completeness, 0.1),
                                      {statistics.completeness, statistics.completeness},
                                      {-1.0, top},
                                      {kInk, 2.5, {10, 8}, render::Cap::butt}});
  if (statistics.b) chart.layers.emplace_back(fit_line(statistics, last));
  chart.layers.emplace_back(std::move(each));
  chart.layers.emplace_back(std::move(all));
  chart.x_range = render::Range{bins.front().from - kMagnitudeBin, last};
  chart.y_range = render::Range{-0.12, top};
  chart.y_log = true;
  return chart;
}

std::string magnitude_caption(const MagnitudeStatistics& s) {
  const std::string what =
      "E is an event's fracture energy. b by maximum likelihood (Aki 1965, Utsu 1965), its error after Shi & Bolt "
      "(1982), M_{c} by "
      "maximum curvature.";
  if (s.b) return what;
  if (s.complete >= kLeastEvents) return what + " No b: all events have one magnitude.";
  return fmt::format("{} No b: the sample is too small, {} of at least {} events from M_{{c}} on.", what, s.complete,
                     kLeastEvents);
}

void draw_magnitudes(const RunFolder& folder, const std::vector<double>& magnitudes) {
  const auto statistics = magnitude_statistics(magnitudes);
  if (!statistics) return;
  const std::vector<MagnitudeBin> bins = bins_of(magnitudes);
  render::ChartFigure figure;
  figure.title = fmt::format("Magnitudes of the {} acoustic events", magnitudes.size());
  figure.caption = magnitude_caption(*statistics);
  figure.charts = {magnitude_chart(bins, *statistics)};
  std::vector<std::vector<CsvCell>> rows;
  for (const MagnitudeBin& bin : bins) rows.push_back({bin.from, bin.events, bin.at_least});
  write_plot_files(folder, "magnitudes", render::draw_figure(figure),
                   {"magnitude_from", "events", "events_of_at_least"}, rows);
}

/// The events in their order, each where the test stood.
struct EventSeries {
  std::vector<double> at, energy, magnitude;
  std::vector<bool> tension;  ///< Half its cracks or more.
  double whole_energy() const { return std::accumulate(energy.begin(), energy.end(), 0.0); }
};

/// The abscissa of a curve at a time, between its rows.
double abscissa_at(const std::vector<double>& time, const std::vector<double>& abscissa, double at) {
  const auto next = std::lower_bound(time.begin(), time.end(), at);
  if (next == time.begin()) return abscissa.front();
  if (next == time.end()) return abscissa.back();
  const auto i = static_cast<std::size_t>(next - time.begin());
  return std::lerp(abscissa[i - 1], abscissa[i], (at - time[i - 1]) / (time[i] - time[i - 1]));
}

EventSeries series_of(const CsvData& events, const CsvData& curves, const Abscissa& abscissa) {
  const std::vector<double> time = curves.numbers("time_s"), x = abscissae(curves, abscissa);
  const std::vector<double> tension = events.numbers("tension"), cracks = events.numbers("cracks");
  EventSeries series{{}, events.numbers("energy_n_mm"), {}, {}};
  for (const double t : events.numbers("time_s")) series.at.push_back(abscissa_at(time, x, t));
  for (std::size_t i = 0; i < tension.size(); ++i) {
    series.tension.push_back(2 * tension[i] >= cracks[i]);
    series.magnitude.push_back(event_magnitude(series.energy[i]));
  }
  return series;
}

/// Steps from 0 to 100 % of a sum.
LineLayer growth(const std::string& label, const std::vector<double>& at, const std::vector<double>& parts, double end,
                 const render::Stroke& stroke) {
  const double whole = std::accumulate(parts.begin(), parts.end(), 0.0);
  LineLayer line{label, {0.0}, {0.0}, stroke};
  double sum = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    line.x.insert(line.x.end(), {at[i], at[i]});
    line.y.push_back(100 * sum / whole);
    line.y.push_back(100 * (sum += parts[i]) / whole);
  }
  line.x.push_back(end);
  line.y.push_back(100.0);
  return line;
}

Chart growth_chart(const EventSeries& series, double end) {
  const std::vector<double> ones(series.at.size(), 1.0);
  Chart chart;
  chart.heading = "events and their energy so far";
  chart.y_label = "share of all [%]";
  chart.layers.emplace_back(growth(fmt::format("events, {} in all", series.at.size()), series.at, ones, end,
                                   {kBlue, kLineWidth, {}, render::Cap::butt}));
  chart.layers.emplace_back(growth(fmt::format("their energy, {:.3g} N mm in all", series.whole_energy()), series.at,
                                   series.energy, end, {kVermilion, kLineWidth, {14, 8}, render::Cap::butt}));
  chart.y_range = render::Range{0, 105};
  return chart;
}

Chart event_chart(const EventSeries& series) {
  PointLayer tension = points("mostly tension", MarkerShape::disc, render::style::kTension),
             shear = points("mostly shear", MarkerShape::open_diamond, render::style::kShear);
  for (std::size_t i = 0; i < series.at.size(); ++i) {
    PointLayer& layer = series.tension[i] ? tension : shear;
    layer.x.push_back(series.at[i]);
    layer.y.push_back(series.magnitude[i]);
  }
  Chart chart;
  chart.heading = "each event";
  chart.y_label = "magnitude M [–]";
  chart.y_range = render::widened(render::range_of(series.magnitude), 0.1);
  chart.layers.emplace_back(std::move(shear));
  chart.layers.emplace_back(std::move(tension));
  return chart;
}

Chart stress_chart(const CsvData& curves, const std::vector<double>& x, ExperimentType type) {
  Chart chart;
  chart.heading = "stress";
  chart.y_label = stress_label(type);
  chart.layers.emplace_back(
      LineLayer{"stress", x, curves.numbers(stress_column(type)), {kInk, kLineWidth, {}, render::Cap::butt}});
  return chart;
}

void draw_acoustic(const RunFolder& folder, const EventSeries& series, const CsvData& curves, ExperimentType type) {
  const Abscissa abscissa = abscissa_of(type);
  const std::vector<double> x = abscissae(curves, abscissa);
  render::ChartFigure figure;
  figure.title = "Acoustic events over the test";
  figure.caption =
      "An event is a group of cracks near in space and time (Hazzard & Young 2000), its energy their fracture energy, "
      "M = "
      "(2/3)(log₁₀E − 4.8) with E in J.";
  figure.charts = {stress_chart(curves, x, type), growth_chart(series, x.back()), event_chart(series)};
  for (Chart& chart : figure.charts) chart.x_range = render::Range{0.0, 1.02 * render::range_of(x).high};
  figure.charts.back().x_label = abscissa.label;
  figure.letters = render::Letters::each;
  figure.height = 1700;
  std::vector<std::vector<CsvCell>> rows;
  for (std::size_t i = 0; i < series.at.size(); ++i)
    rows.push_back({series.at[i] / abscissa.factor, series.energy[i], series.magnitude[i],
                    series.tension[i] ? "tension" : "shear"});
  write_plot_files(folder, "acoustic", render::draw_figure(figure),
                   {abscissa.column, "energy_n_mm", "magnitude", "mostly"}, rows);
}

}  // namespace

void draw_event_plots(const RunFolder& folder, const RunConfig& config, const CsvData& curves) {
  const CsvData events = read_csv(folder.events());
  if (events.rows() == 0 || curves.rows() == 0) return;
  draw_magnitudes(folder, event_magnitudes(events.numbers("energy_n_mm")));
  draw_acoustic(folder, series_of(events, curves, abscissa_of(config.experiment.type)), curves, config.experiment.type);
}

}  // namespace asperity::app
