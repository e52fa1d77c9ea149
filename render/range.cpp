#include "render/range.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::render {

Range range_of(const std::vector<double>& values) { return percentiles(values, 0, 1); }

Range united(Range a, Range b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

Range widened(Range range, double margin) {
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  const double length = std::max(range.high - range.low, size > 0 ? 1e-6 * size : 1e-6);
  return {range.low - margin * length, range.high + margin * length};
}

Range reaching_zero(Range range) {
  constexpr double kZeroIsNear = 0.35;
  const double length = range.high - range.low;
  if (range.low > 0 && range.low < kZeroIsNear * length) range.low = 0;
  if (range.high < 0 && -range.high < kZeroIsNear * length) range.high = 0;
  return range;
}

Range with_headroom(Range range) {
  constexpr double kHeadroom = 0.04;
  const Range wide = widened(range, kHeadroom);
  return {range.low == 0 ? 0 : wide.low, range.high == 0 ? 0 : wide.high};
}

Range percentiles(std::vector<double> values, double low, double high) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return {0, 0};
  const auto pick = [&](double part) {
    const auto place = values.begin() + std::lround(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  const double bottom = pick(low);
  return {bottom, pick(high)};
}

double round_step(double length, int parts) {
  const double raw = length / parts;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double lead = raw / power;
  return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

}  // namespace asperity::render
