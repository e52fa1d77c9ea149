#include "core/measurement/gauges.hpp"

#include <cmath>

#include "core/base/error.hpp"

namespace asperity {
namespace {

double mean(const std::vector<int>& nodes, const auto& value) {
  double sum = 0.0;
  for (int node : nodes) sum += value(node);
  return sum / static_cast<double>(nodes.size());
}

/// A band between two rows of nodes would read 0 / 0.
void refuse_empty(const std::array<std::vector<int>, 2>& bands, const char* pointer) {
  if (!bands[0].empty() && !bands[1].empty()) return;
  throw Error(ErrorKind::config,
              {{pointer, "no node of the specimen lies in the gauge", "", "", "make it longer than an edge"}});
}

}  // namespace

Gauges make_gauges(const Particles& p, const ExperimentConfig& experiment, const MeasurementConfig& m, double edge_mm) {
  Gauges gauges;
  const double middle = 0.5 * experiment.height_mm;
  const double half_width = 0.5 * experiment.width_mm;
  for (std::size_t i = 0; i < p.node_count(); ++i) {
    const Vec2 x = p.reference(i);
    for (int side = 0; side < 2; ++side) {
      const double sign = side == 0 ? -1.0 : 1.0;
      if (std::abs(x.y - (middle + sign * 0.5 * m.axial_gauge_mm)) <= edge_mm)
        gauges.axial[side].push_back(static_cast<int>(i));
      const bool on_flank = std::abs(x.x - sign * half_width) < 1e-9 * half_width;
      if (on_flank && std::abs(x.y - middle) <= 0.5 * m.lateral_gauge_mm)
        gauges.lateral[side].push_back(static_cast<int>(i));
    }
  }
  refuse_empty(gauges.axial, "/measurement/axial_gauge_mm");
  refuse_empty(gauges.lateral, "/measurement/lateral_gauge_mm");
  const auto height = [&](int node) { return p.reference(node).y; };
  gauges.axial_base_mm = mean(gauges.axial[1], height) - mean(gauges.axial[0], height);
  gauges.lateral_base_mm = experiment.width_mm;
  return gauges;
}

GaugeReading read_gauges(const Gauges& gauges, const Particles& p) {
  if (gauges.axial_base_mm == 0.0) return {};
  const auto along = [&](int node) { return p.position[node].y - p.reference(node).y; };
  const auto across = [&](int node) { return p.position[node].x - p.reference(node).x; };
  return {(mean(gauges.axial[0], along) - mean(gauges.axial[1], along)) / gauges.axial_base_mm,
          (mean(gauges.lateral[1], across) - mean(gauges.lateral[0], across)) / gauges.lateral_base_mm};
}

}  // namespace asperity
