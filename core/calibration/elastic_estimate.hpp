#pragma once
#include "core/config/run_config.hpp"

/// Closed-form estimate of an assembly's elasticity from its particles' and contacts'. Moduli and stresses MPa,
/// stiffnesses MPa/mm, lengths mm.
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

/// 1/8 of the edge density: the estimate's unit of contact compliance, 1/mm.
double contact_share(double edge_mm);

/// Eq. (K26): the ratio k_s / k_t with which particles of this Poisson's ratio make an assembly of `target`, with k_t
/// held; not positive where none does.
double estimate_stiffness_ratio(Elasticity target, double particle_poissons_ratio, double k_t, double edge_mm,
                                PlaneCondition plane);

/// The k_t above which particles that make an assembly of `target` exist at all, whatever k_s, Eq. (K34).
double least_stiffness(Elasticity target, double edge_mm, PlaneCondition plane);

/// Stresses between which a modulus is fitted, MPa.
struct StressWindow {
  double low = 0, high = 0;
};

/// Eq. (K27): by how much the contacts' hardening in shear raises the estimate's 1 / k_s between two axial stresses of
/// a uniaxial test, c_c in MPa. It depends on neither stiffness. 1 for a window at no stress.
double shear_hardening(StressWindow window, double c_c, double friction);

}  // namespace asperity
