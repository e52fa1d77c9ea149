#include "core/calibration/elastic_estimate.hpp"

#include <cmath>
#include <limits>

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
  const double share = edge_density(edge_mm) / 8.0;
  return {share * (3.0 / contacts.k_t + 1.0 / contacts.k_s()), share * (1.0 / contacts.k_s() - 1.0 / contacts.k_t)};
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
  const double share = edge_density(edge_mm) / 8.0;
  const double rest = t.lateral - nu * t.axial + share / k_t * (1.0 + 3.0 * nu);
  return share * (1.0 - nu) / (k_t * rest);
}

}  // namespace asperity
