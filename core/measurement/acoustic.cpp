#include "core/measurement/acoustic.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/disjoint_sets.hpp"
#include "core/base/units.hpp"

namespace asperity {
namespace {

constexpr double kEdgesApart = 3.0;

double shear_wave_speed(const ParticleConfig& p) {
  const double modulus = p.youngs_modulus_gpa * units::kMpaPerGpa / (2.0 * (1.0 + p.poissons_ratio));
  return std::sqrt(modulus / (p.density_kg_per_m3 * units::kTonnePerMm3PerKgPerM3));
}

std::vector<int> join_near_cracks(std::span<const Crack> cracks, double distance, double delay) {
  DisjointSets events(cracks.size());
  for (int i = 0; i < static_cast<int>(cracks.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(cracks.size()) && cracks[j].time_s - cracks[i].time_s <= delay; ++j) {
      if (norm(cracks[j].place - cracks[i].place) <= distance) events.join(i, j);
    }
  }
  return events.names();
}

void add_crack(AcousticEvent& event, double& length, const Crack& crack) {
  length += crack.length_mm;
  if (event.cracks == 0) event.time_s = crack.time_s;
  event.duration_s = crack.time_s - event.time_s;
  ++event.cracks;
  event.tension += crack.mode == BreakMode::tension;
  event.shear += crack.mode == BreakMode::shear;
  event.energy_n_mm += crack.energy_n_mm;
  event.place += crack.length_mm * crack.place;
}

}  // namespace

std::vector<AcousticEvent> group_events(std::span<const Crack> cracks, const RunConfig& config) {
  const double distance = kEdgesApart * config.particles.edge_mm;
  const std::vector<int> root = join_near_cracks(cracks, distance, distance / shear_wave_speed(config.particles));
  std::vector<int> event_of(cracks.size(), -1);
  std::vector<AcousticEvent> events;
  std::vector<double> length;
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    int& event = event_of[root[i]];
    if (event < 0) {
      event = static_cast<int>(events.size());
      events.emplace_back();
      length.push_back(0.0);
    }
    add_crack(events[event], length[event], cracks[i]);
  }
  for (std::size_t e = 0; e < events.size(); ++e) events[e].place = (1.0 / length[e]) * events[e].place;
  return events;
}

}  // namespace asperity
