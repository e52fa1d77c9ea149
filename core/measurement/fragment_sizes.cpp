#include "core/measurement/fragment_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

double equivalent_diameter(double area_mm2) { return std::sqrt(4.0 * area_mm2 / std::numbers::pi); }

std::vector<PassingStep> passing_curve(std::span<const double> area_mm2) {
  std::vector<double> areas(area_mm2.begin(), area_mm2.end());
  std::sort(areas.begin(), areas.end());
  double whole = 0.0, passed = 0.0;
  for (const double area : areas) whole += area;
  std::vector<PassingStep> curve;
  for (const double area : areas) {
    passed += area;
    curve.push_back({equivalent_diameter(area), passed / whole});
  }
  return curve;
}

double passing_size(std::span<const double> area_mm2, double share) {
  const std::vector<PassingStep> curve = passing_curve(area_mm2);
  if (curve.empty()) return 0.0;
  const auto found = std::find_if(curve.begin(), curve.end(), [&](const PassingStep& s) { return s.share >= share; });
  return found == curve.end() ? curve.back().size_mm : found->size_mm;
}

}  // namespace asperity
