#include "core/calibration/elastic_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

/// In-plane compliances 1/E' and nu'/E', 1/MPa: those of particles and contacts add up.
struct Compliance {
  double axial = 0, lateral = 0;
};

Compliance compliance(Elasticity material, PlaneCondition plane) {
  const Elasticity e = plane_elasticity(material, plane);
  return {1.0 / e.youngs_modulus, e.poissons_ratio / e.youngs_modulus};
}

Elasticity elasticity(Compliance c, PlaneCondition plane) {
  return material_elasticity({1.0 / c.axial, c.lateral / c.axial}, plane);
}

/// Eq. (K23).
Compliance contact_compliance(const ContactStiffness& contacts, double edge_mm) {
  const double share = contact_share(edge_mm);
  return {share * (3.0 / contacts.k_t + 1.0 / contacts.k_s()), share * (1.0 / contacts.k_s() - 1.0 / contacts.k_t)};
}

constexpr int kOrientations = 64;  // a quarter turn: the mean is smooth, so more change nothing in four digits
constexpr int kStresses = 64;      // up to a stress

/// x <= 1 of x exp(-x) = y, Eqs 3 and 6; 1 beyond the peak. Newton's iteration climbs a concave curve from its left.
double normalised_displacement(double y) {
  if (y >= 1.0 / std::numbers::e) return 1.0;
  double x = y;
  for (int i = 0; i < 40 && x < 1.0; ++i) x += (y * std::exp(x) - x) / (1.0 - x);
  return std::min(x, 1.0);
}

/// k_s delta_s (MPa) of a contact whose normal makes an angle with the axial stress, loaded from zero in proportion:
/// D2 of core/contact with its peak rising by the share of the stress that presses the contact.
double shear_displacement(double axial_stress, double angle, double c_c, double friction) {
  const double shear = std::sin(angle) * std::cos(angle);
  const double pressure = std::cos(angle) * std::cos(angle) * friction;
  const auto peak = [&](double stress) { return std::numbers::e * (c_c + stress * pressure); };
  const double step = axial_stress / kStresses;
  double from_rising_peak = 0.0;
  for (int i = 0; i < kStresses; ++i) {
    const double stress = (i + 0.5) * step;
    const double y = stress * shear / peak(stress);
    from_rising_peak += (normalised_displacement(y) - y) * std::numbers::e * pressure * step;
  }
  return peak(axial_stress) * normalised_displacement(axial_stress * shear / peak(axial_stress)) - from_rising_peak;
}

}  // namespace

Elasticity plane_elasticity(Elasticity m, PlaneCondition plane) {
  if (plane == PlaneCondition::stress) return m;
  const double nu = m.poissons_ratio;
  return {m.youngs_modulus / (1.0 - nu * nu), nu / (1.0 - nu)};
}

Elasticity material_elasticity(Elasticity in_plane, PlaneCondition plane) {
  if (plane == PlaneCondition::stress) return in_plane;
  const double nu = in_plane.poissons_ratio / (1.0 + in_plane.poissons_ratio);
  return {in_plane.youngs_modulus * (1.0 - nu * nu), nu};
}

double edge_density(double edge_mm) { return 2.0 * std::sqrt(3.0) / edge_mm; }

double contact_share(double edge_mm) { return edge_density(edge_mm) / 8.0; }

Elasticity estimate_assembly(Elasticity particle, const ContactStiffness& contacts, double edge_mm,
                             PlaneCondition plane) {
  const Compliance p = compliance(particle, plane);
  const Compliance c = contact_compliance(contacts, edge_mm);
  return elasticity({p.axial + c.axial, p.lateral + c.lateral}, plane);
}

Elasticity estimate_particle(Elasticity target, const ContactStiffness& contacts, double edge_mm,
                             PlaneCondition plane) {
  const Compliance t = compliance(target, plane);
  const Compliance c = contact_compliance(contacts, edge_mm);
  return elasticity({t.axial - c.axial, t.lateral - c.lateral}, plane);
}

double estimate_stiffness_ratio(Elasticity target, double particle_poissons_ratio, double k_t, double edge_mm,
                                PlaneCondition plane) {
  // Put 1/E'_p of the axial row of Eq. (K25) into its lateral row and solve for 1/k_s.
  const Compliance t = compliance(target, plane);
  const double nu = plane_elasticity({1.0, particle_poissons_ratio}, plane).poissons_ratio;
  const double share = contact_share(edge_mm);
  const double rest = t.lateral - nu * t.axial + share / k_t * (1.0 + 3.0 * nu);
  return share * (1.0 - nu) / (k_t * rest);
}

double least_stiffness(Elasticity target, double edge_mm, PlaneCondition plane) {
  const Elasticity e = plane_elasticity(target, plane);
  return 4.0 * contact_share(edge_mm) * e.youngs_modulus / (1.0 - e.poissons_ratio);
}

double shear_hardening(StressWindow window, double c_c, double friction) {
  if (window.high <= window.low) return 1.0;
  double mean = 0.0;
  for (int i = 0; i < kOrientations; ++i) {
    const double angle = 0.5 * std::numbers::pi * (i + 0.5) / kOrientations;
    const double high = shear_displacement(window.high, angle, c_c, friction);
    const double low = shear_displacement(window.low, angle, c_c, friction);
    mean += (high - low) * std::sin(angle) * std::cos(angle) / kOrientations;
  }
  return 8.0 * mean / (window.high - window.low);
}

}  // namespace asperity
