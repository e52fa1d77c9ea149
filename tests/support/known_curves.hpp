#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "core/confrontation/curve_columns.hpp"
#include "core/measurement/curve.hpp"
#include "core/output/csv.hpp"

/// Curves whose features are known: in closed form, or simulated ones kept in tests/support/curves.
namespace asperity::known {

/// Share of the peak that is left far behind it.
inline constexpr double kResidual = 0.4;

/// Load over the peak where the path without toe is u times the peak's: straight at first, round at the peak (its
/// curvature the same on both sides), falling to a residual. Before the peak the form of Carreira & Chu (1985), ACI J.
/// 82; behind it the same, steeper, onto the residual.
inline double backbone(double u) {
  const double n = u <= 1.0 ? 4.0 : 6.0;
  const double rise = n * u / (n - 1.0 + std::pow(u, n));
  return u <= 1.0 ? rise : kResidual + (1.0 - kResidual) * rise;
}

/// Path that a toe of travel a adds at a load, gone within a fifth of the peak.
inline double toe(double a, double load) { return a * (1.0 - std::exp(-load / 0.06)); }

/// The numbers of an analytic curve: loads over the peak, paths over the peak's path without toe.
struct Analytic {
  double peak, peak_path, base;
  double toe_travel = 0.15, reload_travel = 0.1;
  double loop_from = 0.5, loop_load = 0.02, loop_stiffness = 1.7;  ///< u where it unloads, to which load, how stiff.
};

/// One row: load over the peak and path over the peak's, both without offsets.
struct Row {
  double u, load, path;
};

/// Rows of loading to u, a loop of unloading and reloading along one line with a toe of its own, and loading to the
/// end.
inline std::vector<Row> rows_of(const Analytic& a, int count, double end) {
  std::vector<Row> rows;
  const auto on = [&](double u) { return Row{u, backbone(u), u + toe(a.toe_travel, backbone(u))}; };
  const int split = static_cast<int>(count * a.loop_from / end), loop = count / 6;
  for (int i = 0; i <= split; ++i) rows.push_back(on(i * a.loop_from / split));
  const Row top = rows.back();
  const auto inside = [&](double q) {
    const double line = top.path - (top.load - q) / a.loop_stiffness;
    return Row{top.u, q, line + toe(a.reload_travel, q) - toe(a.reload_travel, top.load)};
  };
  for (int i = 1; i < loop; ++i) rows.push_back(inside(top.load + (a.loop_load - top.load) * i / loop));
  for (int i = loop; i > 0; --i) rows.push_back(inside(top.load + (a.loop_load - top.load) * i / loop));
  for (int i = split + 1; i <= count; ++i)
    rows.push_back(on(a.loop_from + (end - a.loop_from) * (i - split) / (count - split)));
  return rows;
}

/// Triaxial compression with gauge, lateral strain and events.
inline Curve compression(const Analytic& a, int count = 6000) {
  Curve c;
  for (const Row& r : rows_of(a, count, 2.5)) {
    const double strain = a.peak_path * r.path, elastic = 0.8 * a.peak_path * (r.path - toe(a.toe_travel, r.load));
    c.path.push_back(strain);
    c.load.push_back(a.base + a.peak * r.load);
    c.gauge_strain.push_back(elastic);
    c.lateral_strain.push_back(0.25 * elastic * (1.0 + 0.5 * std::pow(std::min(r.u, 1.2), 3)));
    c.events.push_back(std::floor(100000.0 * r.u * r.u));
  }
  return c;
}

inline Curve disc(const Analytic& a, int count = 6000) {
  Curve c;
  for (const Row& r : rows_of(a, count, 2.5)) {
    c.path.push_back(a.peak_path * r.path);
    c.load.push_back(a.peak * r.load);
    c.events.push_back(std::floor(100000.0 * r.u * r.u));
  }
  return c;
}

/// A joint that dilates at one rate up to the peak, less behind it, its front a tenth faster.
inline Curve joint(const Analytic& a, int count = 6000) {
  Curve c = disc(a, count);
  for (const Row& r : rows_of(a, count, 2.5)) {
    const double rise = 0.4 * a.peak_path * (r.u <= 1.0 ? r.u : 1.0 + 0.5 * (r.u - 1.0));
    c.dilation_mm.push_back(rise);
    c.dilation_front_mm.push_back(1.1 * rise);
    c.dilation_rear_mm.push_back(0.9 * rise);
  }
  return c;
}

/// A simulated curve of tests/support/curves.
inline Curve simulated(const std::string& name, ExperimentType experiment) {
  const CsvData table = read_csv(std::string(ASPERITY_SOURCE_DIR) + "/tests/support/curves/" + name + ".csv");
  Curve c;
  for (const ColumnKind& kind : curve_columns(experiment)) {
    const std::string column = std::string(kind.base) + std::string(unit_suffixes(kind.quantity).front().suffix);
    if (table.has(column)) c.*(kind.member) = table.numbers(column);
  }
  return c;
}

}  // namespace asperity::known
