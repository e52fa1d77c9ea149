#include "core/measurement/line_fit.hpp"

namespace asperity {

Line fit_line(std::span<const double> x, std::span<const double> y) {
  double mx = 0, my = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mx += x[i];
    my += y[i];
  }
  mx /= static_cast<double>(x.size());
  my /= static_cast<double>(x.size());
  double sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - mx) * (x[i] - mx);
    sxy += (x[i] - mx) * (y[i] - my);
  }
  const double slope = sxy / sxx;
  return {slope, my - slope * mx};
}

std::vector<std::size_t> window_rows(std::span<const double> load, std::size_t end, double low, double high) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < end; ++i) {
    if (load[i] >= low && load[i] <= high) rows.push_back(i);
  }
  return rows;
}

std::vector<double> gather(std::span<const double> values, std::span<const std::size_t> rows) {
  std::vector<double> chosen;
  chosen.reserve(rows.size());
  for (const std::size_t row : rows) chosen.push_back(values[row]);
  return chosen;
}

double slope_in_order(std::span<const double> x, std::span<const double> y) {
  const double middle = 0.5 * (static_cast<double>(x.size()) - 1.0);
  double along_x = 0, along_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double order = static_cast<double>(i) - middle;
    along_x += order * x[i];
    along_y += order * y[i];
  }
  return x.size() < 3 || along_x == 0.0 ? 0.0 : along_y / along_x;
}

}  // namespace asperity
