#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace asperity {

/// A fall of a load: rows of its beginning and of the least load before it rises again by as much.
struct Drop {
  std::size_t high = 0, low = 0;
};

/// Falls by `least` or more from a running maximum; Eq. (F18).
std::vector<Drop> find_drops(std::span<const double> load, double least);

/// What tells a first drop from an uneven beginning.
struct FirstDropRule {
  double bearing = 0;  ///< Where events are not recorded: the load that the largest so far reaches.
  double noise = 0;    ///< The fall is above this.
};

/// The largest load so far where the load first lies a tenth below it, Eq. (M28), and something is broken. `events` may
/// be empty: not recorded.
std::optional<double> first_drop(std::span<const double> load, std::span<const double> events,
                                 const FirstDropRule& rule);

/// Rows whose path lies in its last share; Eq. (F17).
std::vector<std::size_t> late_rows(std::span<const double> path, double share);

/// Mean of the values at some rows.
double mean_at(std::span<const double> values, std::span<const std::size_t> rows);

}  // namespace asperity
