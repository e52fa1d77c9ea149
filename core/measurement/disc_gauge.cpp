#include "core/measurement/disc_gauge.hpp"

#include <limits>

#include "core/base/units.hpp"
#include "core/integrator/platen_contact.hpp"

namespace asperity {
namespace {

Vec2 centroid_at_rest(const Particles& p, std::size_t triangle) {
  const auto& n = p.triangles[triangle];
  return (1.0 / 3.0) * (p.reference(n[0]) + p.reference(n[1]) + p.reference(n[2]));
}

void add_rim_edge(DiscGauge& gauge, const Particles& p, int edge) {
  const auto& nodes = p.triangles[edge / 3];
  const int a = nodes[edge % 3], b = nodes[(edge % 3 + 1) % 3];
  const double half = 0.5 * norm(p.reference(b) - p.reference(a));
  gauge.rim.push_back({a, half});
  gauge.rim.push_back({b, half});
}

/// Eq. (M14).
void read_centre(const DiscGauge& gauge, const Particles& p, DiscReading& reading) {
  double area = 0.0, horizontal = 0.0, vertical = 0.0;
  for (const int triangle : gauge.centre) {
    const double share = p.shape(triangle).area;
    const auto stress = triangle_stress(p, triangle);
    area += share;
    horizontal += share * stress[0];
    vertical += share * stress[1];
  }
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  reading.centre_tension_mpa = area > 0.0 ? horizontal / area : kNothing;
  reading.centre_compression_mpa = area > 0.0 ? -vertical / area : kNothing;
}

/// Eq. (M15).
double contact_half_angle(const DiscGauge& gauge, const System& system) {
  double pressed = 0.0;
  for (const RimEnd& end : gauge.rim) {
    if (platen_contact(system, end.node).overlap > 0.0) pressed += end.length_mm;
  }
  return pressed / (2.0 * gauge.diameter_mm);
}

}  // namespace

DiscGauge make_disc_gauge(const BondedContacts& contacts, const Particles& p, double diameter_mm) {
  DiscGauge gauge;
  gauge.diameter_mm = diameter_mm;
  const Vec2 centre{0.0, 0.5 * diameter_mm};
  for (std::size_t t = 0; t < p.triangle_count(); ++t) {
    if (norm(centroid_at_rest(p, t) - centre) <= kCentreRadius * diameter_mm) {
      gauge.centre.push_back(static_cast<int>(t));
    }
    for (int edge = 3 * static_cast<int>(t); edge < 3 * static_cast<int>(t) + 3; ++edge) {
      if (contacts.joint(edge) == kOutline) add_rim_edge(gauge, p, edge);
    }
  }
  return gauge;
}

DiscReading read_disc_gauge(const DiscGauge& gauge, const System& system) {
  DiscReading reading;
  if (gauge.diameter_mm == 0.0) return reading;
  read_centre(gauge, system.particles, reading);
  reading.contact_half_angle_deg = contact_half_angle(gauge, system) / units::kRadPerDeg;
  return reading;
}

}  // namespace asperity
