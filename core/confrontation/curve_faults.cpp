#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/confrontation/curve_columns.hpp"
#include "core/confrontation/measured_curve.hpp"
#include "core/measurement/curve_loops.hpp"
#include "core/measurement/curve_shape.hpp"

namespace asperity {
namespace {

/// While the path goes back the load falls by this share of the largest, or nothing is unloaded.
constexpr double kLeastUnloading = 0.05;
/// A total stress begins at this share of the confining pressure at least.
constexpr double kLeastStart = 0.5;

/// What the checks of one curve share.
struct Look {
  const MeasuredTest& test;
  const SpecimenCurve& curve;
  std::vector<Fault>& faults;

  void fault(std::size_t row, std::string what, double value, std::string allowed, std::string hint) const {
    faults.push_back({fmt::format("{}:{}", test.curve_file.string(), curve.lines[row]), std::move(what),
                      fmt::format("{:g}", value), std::move(allowed), std::move(hint)});
  }
  /// "of specimen A2" where the file has several.
  std::string of() const { return test.curves.size() > 1 ? " of specimen " + curve.specimen : ""; }
};

bool check_numbers(const Look& look) {
  bool good = true;
  for (const ColumnKind& kind : curve_columns(look.test.experiment)) {
    const std::vector<double>& values = look.curve.curve.*(kind.member);
    const auto bad = std::find_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
    if (bad == values.end()) continue;
    look.fault(static_cast<std::size_t>(bad - values.begin()), std::string(kind.base) + " is no finite number", *bad,
               "a number in every row", "leave the row out where nothing was read");
    good = false;
  }
  return good;
}

bool check_rows(const Look& look) {
  const std::size_t rows = look.curve.lines.size();
  if (rows >= kLeastRows) return true;
  look.fault(rows - 1, "the curve" + look.of() + " has too few rows", static_cast<double>(rows),
             fmt::format("{} or more", kLeastRows), "give single numbers under \"results\"");
  return false;
}

std::string unit_hint(const ColumnKind& kind) {
  if (kind.quantity == Quantity::strain)
    return fmt::format("name the column {}_percent if it is in percent", kind.base);
  return "is the unit at the end of the column's name that of its numbers?";
}

/// How many rows count: a gauge on the specimen may go over its range once the specimen is broken.
std::size_t rows_that_count(const Look& look, const ColumnKind& kind) {
  const Curve& curve = look.curve.curve;
  if (kind.member != &Curve::gauge_strain && kind.member != &Curve::lateral_strain) return curve.load.size();
  return static_cast<std::size_t>(std::max_element(curve.load.begin(), curve.load.end()) - curve.load.begin()) + 1;
}

bool check_size(const Look& look, const ColumnKind& kind) {
  std::vector<double> values = look.curve.curve.*(kind.member);
  values.resize(std::min(values.size(), rows_that_count(look, kind)));
  const auto by_size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto largest = std::max_element(values.begin(), values.end(), by_size);
  const QuantityLimit limit = limit_of(kind.quantity);
  if (values.empty() || std::abs(*largest) <= limit.largest) return true;
  look.fault(static_cast<std::size_t>(largest - values.begin()),
             fmt::format("{} is too large for {}", kind.base, limit.word), *largest,
             fmt::format("up to {:g}{}{}", limit.largest, limit.unit.empty() ? "" : " ", limit.unit), unit_hint(kind));
  return false;
}

bool check_sizes(const Look& look) {
  bool good = true;
  for (const ColumnKind& kind : curve_columns(look.test.experiment)) {
    const bool copied = kind.member == &Curve::gauge_strain && path_is_gauge(look.test);
    if (!copied && !check_size(look, kind)) good = false;
  }
  return good;
}

bool check_sign(const Look& look) {
  const std::vector<double>& load = look.curve.curve.load;
  const auto [least, most] = std::minmax_element(load.begin(), load.end());
  if (*most > 0.0 && *most >= -*least) return true;
  look.fault(static_cast<std::size_t>(least - load.begin()), "the load" + look.of() + " points the wrong way", *least,
             "compression and shear positive", "turn the column's sign");
  return false;
}

bool check_total(const Look& look) {
  const double base = base_load(reading_of(look.test));
  const double start = look.curve.curve.load.front();
  if (base == 0.0 || start >= kLeastStart * base) return true;  // without pressure a load cell's zero may lie below 0
  look.fault(0, "the first axial stress lies below the confining pressure", start,
             fmt::format("total stress: {:g} MPa at strain zero", base),
             "add the confining pressure to a stress difference");
  return false;
}

double least_load(const Curve& curve, std::size_t begin, std::size_t end) {
  return *std::min_element(curve.load.begin() + begin, curve.load.begin() + end);
}

bool check_ways_back(const Look& look) {
  const Curve& curve = look.curve.curve;
  const double largest = *std::max_element(curve.load.begin(), curve.load.end());
  for (const CurveLoop& loop : find_loops(curve, reading_of(look.test))) {
    const std::string what = "the displacement goes backwards without a reload" + look.of();
    const std::size_t end = std::min(loop.back, curve.path.size());
    if (loop.back >= curve.path.size()) {
      look.fault(loop.top + 1, what, curve.path[loop.bottom], fmt::format("after {:g} only more", curve.path[loop.top]),
                 "end the curve where the specimen was unloaded for good");
      return false;
    }
    if (curve.load[loop.top] - least_load(curve, loop.top, end) < kLeastUnloading * largest) {
      look.fault(loop.top + 1, what, curve.path[loop.bottom],
                 fmt::format("after {:g} only more, unless the load falls too", curve.path[loop.top]),
                 "rows belong in the order of time; give each specimen its own name");
      return false;
    }
  }
  return true;
}

void check_peak(const Look& look) {
  if (look.test.ends_before_peak) return;
  const CurveShape shape = shape_of(look.curve.curve, reading_of(look.test));
  const std::vector<double>& load = look.curve.curve.load;
  const bool last = std::max_element(load.begin(), load.end()) + 1 == load.end();
  if (shape.peak_passed && !last) return;
  look.fault(load.size() - 1, "the curve" + look.of() + " ends at its peak", load.back(), "rows behind the peak",
             "where the specimen was not taken to failure, say \"ends_before_peak\": true");
}

void check_events(const Look& look) {
  const std::vector<double>& events = look.curve.curve.events;
  const auto falls = std::adjacent_find(events.begin(), events.end(), std::greater<>());
  if (falls != events.end()) {
    look.fault(static_cast<std::size_t>(falls - events.begin()) + 1, "acoustic_events falls", *(falls + 1),
               "a cumulative count", "add the counts up");
  } else if (!events.empty() && events.front() < 0.0) {
    look.fault(0, "acoustic_events is negative", events.front(), "a cumulative count, 0 or more",
               "count from the test's beginning");
  }
}

void check_lateral(const Look& look) {
  const Curve& curve = look.curve.curve;
  if (curve.lateral_strain.empty()) return;
  const auto top = std::max_element(curve.load.begin(), curve.load.end()) - curve.load.begin();
  if (curve.lateral_strain[top] >= 0.0) return;
  look.fault(static_cast<std::size_t>(top), "lateral_strain is negative at the peak", curve.lateral_strain[top],
             "positive outwards", "turn the column's sign");
}

}  // namespace

std::vector<Fault> curve_faults(const MeasuredTest& test) {
  std::vector<Fault> faults;
  for (const SpecimenCurve& curve : test.curves) {
    const Look look{test, curve, faults};
    if (!check_numbers(look) || !check_rows(look) || !check_sizes(look)) continue;
    check_events(look);
    check_lateral(look);
    if (check_sign(look) && check_total(look) && check_ways_back(look)) check_peak(look);
  }
  return faults;
}

}  // namespace asperity
