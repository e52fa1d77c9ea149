#pragma once
#include "core/config/run_config.hpp"

/// Closed-form estimate of an assembly's elasticity from its particles' and contacts'. Moduli MPa, stiffnesses MPa/mm,
/// lengths mm.
namespace asperity {

/// Young's modulus (MPa) and Poisson's ratio.
struct Elasticity {
  double youngs_modulus = 0, poissons_ratio = 0;
};

/// Stiffness of the contacts between particles.
struct ContactStiffness {
  double k_t = 0;    ///< MPa/mm
  double ratio = 0;  ///< k_s / k_t
  double k_s() const { return ratio * k_t; }
};

/// E' and nu' of the plane problem, Eq. (K20): what stress and strain in the plane obey.
Elasticity plane_elasticity(Elasticity material, PlaneCondition plane);

/// Its inverse, Eq. (K21).
Elasticity material_elasticity(Elasticity in_plane, PlaneCondition plane);

/// Length of contact edges per area (1/mm) of equilateral triangles with this edge, Eq. (K22).
double edge_density(double edge_mm);

/// Eq. (K24): what the assembly shows, exact for equilateral triangles and a bound from below for its stiffness else.
Elasticity estimate_assembly(Elasticity particle, const ContactStiffness& contacts, double edge_mm,
                             PlaneCondition plane);

/// Eq. (K25): what particles must have for the assembly to have `target`. A Young's modulus that is not positive means
/// that the contacts alone are more compliant than the target.
Elasticity estimate_particle(Elasticity target, const ContactStiffness& contacts, double edge_mm, PlaneCondition plane);

/// Eq. (K26): the ratio k_s / k_t with which particles of this Poisson's ratio make an assembly of `target`, with k_t
/// held; not positive where none does.
double estimate_stiffness_ratio(Elasticity target, double particle_poissons_ratio, double k_t, double edge_mm,
                                PlaneCondition plane);

}  // namespace asperity
