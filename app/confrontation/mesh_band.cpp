#include "app/confrontation/mesh_band.hpp"

#include <algorithm>
#include <limits>

namespace asperity::app {
namespace {

/// The rows that lie farther than all before them.
ShownCurve forward(const ShownCurve& curve) {
  ShownCurve rows;
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.path.size(); ++i) {
    if (!(curve.path[i] > farthest)) continue;
    farthest = curve.path[i];
    rows.path.push_back(curve.path[i]);
    rows.load.push_back(curve.load[i]);
  }
  return rows;
}

/// Linear between rows; `at` lies within the path.
double load_at(const ShownCurve& curve, double at) {
  const auto above = std::lower_bound(curve.path.begin(), curve.path.end(), at);
  const auto i = static_cast<std::size_t>(above - curve.path.begin());
  if (i == 0) return curve.load.front();
  if (i == curve.path.size()) return curve.load.back();
  const double share = (at - curve.path[i - 1]) / (curve.path[i] - curve.path[i - 1]);
  return curve.load[i - 1] + share * (curve.load[i] - curve.load[i - 1]);
}

}  // namespace

MeshBand mesh_band(const std::vector<ShownCurve>& curves, int points) {
  std::vector<ShownCurve> all;
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
  for (const ShownCurve& curve : curves) {
    if (curve.path.size() < 2) continue;
    all.push_back(forward(curve));
    from = std::max(from, all.back().path.front());
    to = std::min(to, all.back().path.back());
  }
  MeshBand band;
  if (all.size() < 2 || !(to > from)) return band;
  for (int i = 0; i < points; ++i) {
    const double at = from + (to - from) * i / (points - 1);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const ShownCurve& curve : all) {
      low = std::min(low, load_at(curve, at));
      high = std::max(high, load_at(curve, at));
    }
    band.path.push_back(at);
    band.lower.push_back(low);
    band.upper.push_back(high);
  }
  return band;
}

}  // namespace asperity::app
