#include "core/measurement/joint_curve.hpp"

#include <algorithm>

#include "core/measurement/line_fit.hpp"

namespace asperity {

std::optional<double> slope_between(std::span<const double> displacement, std::span<const double> values, double from,
                                    double to) {
  const std::vector<std::size_t> rows = window_rows(displacement, displacement.size(), from, to);
  if (rows.size() < 3) return std::nullopt;
  const std::vector<double> x = gather(displacement, rows);
  if (*std::max_element(x.begin(), x.end()) <= *std::min_element(x.begin(), x.end())) return std::nullopt;
  return fit_line(x, gather(values, rows)).slope;
}

}  // namespace asperity
