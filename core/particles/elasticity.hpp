#pragma once
#include <array>
#include <cmath>

#include "core/base/vec2.hpp"
#include "core/config/run_config.hpp"

namespace asperity {

/// Plane constants of an isotropic elastic material, Eq. (P1): MPa. out_of_plane is sigma_zz / (sigma_xx + sigma_yy).
struct ElasticConstants {
  double c11 = 0, c12 = 0, shear = 0, out_of_plane = 0;
};

/// Eq. (P1) from Young's modulus (MPa) and Poisson's ratio.
ElasticConstants elastic_constants(double youngs_modulus_mpa, double poissons_ratio, PlaneCondition plane);

/// Reference shape of a constant-strain triangle: gradients of its three shape functions (1/mm) and its area (mm2).
struct TriangleShape {
  std::array<Vec2, 3> gradient;
  double area = 0;
};

/// Shape of a counter-clockwise triangle with corners a, b, c (mm).
TriangleShape triangle_shape(Vec2 a, Vec2 b, Vec2 c);

/// Deformation gradient F, row by row.
struct DeformationGradient {
  double xx, xy, yx, yy;
  double jacobian() const { return xx * yy - xy * yx; }
};

/// F of a triangle whose corners are at x (mm).
inline DeformationGradient deformation_gradient(const TriangleShape& shape, const std::array<Vec2, 3>& x) {
  // The gradients sum to zero, so differences from the first corner suffice and large coordinates cost no digits.
  const Vec2 p = x[1] - x[0];
  const Vec2 q = x[2] - x[0];
  const Vec2 gp = shape.gradient[1];
  const Vec2 gq = shape.gradient[2];
  return {p.x * gp.x + q.x * gq.x, p.x * gp.y + q.x * gq.y, p.y * gp.x + q.y * gq.x, p.y * gp.y + q.y * gq.y};
}

/// Rotation R (cosine, sine), Biot strain e = U - I and Biot stress t = C : e of a triangle; Eqs. (P2), (P3).
struct BiotState {
  double cosine, sine;
  double e11, e22, e12;
  double t11, t22, t12;
  double spin = 0;  ///< Skew part that P needs where t and U have other axes, Eq. (P8); 0 without plastic strain.
  double energy_density() const { return 0.5 * (t11 * e11 + t22 * e22) + t12 * e12; }
};

inline BiotState biot_state(const DeformationGradient& f, const ElasticConstants& c) {
  const double a = f.xx + f.yy;
  const double b = f.yx - f.xy;
  const double r = 1.0 / std::sqrt(a * a + b * b);
  BiotState s;
  s.cosine = a * r;
  s.sine = b * r;
  s.e11 = s.cosine * f.xx + s.sine * f.yx - 1.0;
  s.e22 = s.cosine * f.yy - s.sine * f.xy - 1.0;
  s.e12 = s.cosine * f.xy + s.sine * f.yy;
  s.t11 = c.c11 * s.e11 + c.c12 * s.e22;
  s.t22 = c.c12 * s.e11 + c.c11 * s.e22;
  s.t12 = 2.0 * c.shear * s.e12;
  return s;
}

/// Plastic Biot strain of a triangle, at constant area: half the difference of its normal components, and the shear
/// one.
struct PlasticStrain {
  double difference = 0, shear = 0;
};

/// Elastic stress of the strain as it is, and the spin, Eq. (P8), for a plastic strain.
inline void set_stress(BiotState& s, const ElasticConstants& c, const PlasticStrain& plastic) {
  s.t11 = c.c11 * s.e11 + c.c12 * s.e22;
  s.t22 = c.c12 * s.e11 + c.c11 * s.e22;
  s.t12 = 2.0 * c.shear * s.e12;
  const double twist = (s.t11 - s.t22) * plastic.shear - 2.0 * s.t12 * plastic.difference;
  s.spin = -twist / (2.0 + s.e11 + s.e22);
}

/// The same beyond a plastic strain, Eqs. (P7), (P8): e becomes the elastic strain.
inline BiotState biot_state(const DeformationGradient& f, const ElasticConstants& c, const PlasticStrain& plastic) {
  BiotState s = biot_state(f, c);
  s.e11 -= plastic.difference;
  s.e22 += plastic.difference;
  s.e12 -= plastic.shear;
  set_stress(s, c, plastic);
  return s;
}

/// Plastic strain at which the yield stress has doubled, Eq. (P7): particles then lock before they turn over.
inline constexpr double kLockingStrain = 0.2;
inline constexpr double kLocking = 1.0 / (kLockingStrain * kLockingStrain);

/// Lets a state that passes half of the yield stress Y (MPa, of a virgin particle) slip back onto it, Eq. (P7). Returns
/// the work that the slip took, N mm per mm3.
inline double yield(BiotState& s, PlasticStrain& plastic, const ElasticConstants& c, double virgin) {
  const double square = plastic.difference * plastic.difference + plastic.shear * plastic.shear;
  const double half_yield = virgin * (1.0 + kLocking * square);
  const double difference = 0.5 * (s.t11 - s.t22);
  const double radius = std::sqrt(difference * difference + s.t12 * s.t12);
  if (radius <= half_yield) return 0.0;
  const double compliance = 1.0 / (2.0 * c.shear), excess = compliance * (1.0 - half_yield / radius);
  const double normal = excess * difference, shear = excess * s.t12;
  plastic.difference += normal;
  plastic.shear += shear;
  s.e11 -= normal;
  s.e22 += normal;
  s.e12 -= shear;
  set_stress(s, c, plastic);
  return 2.0 * half_yield * compliance * (radius - half_yield);
}

/// Forces on the three corners (N per mm of thickness): f_a = -A (R t) grad N_a, Eq. (P4), the exact gradient of Eq.
/// (P3).
inline std::array<Vec2, 3> corner_forces(const TriangleShape& shape, const BiotState& s) {
  const double t21 = s.t12 - s.spin, t12 = s.t12 + s.spin;
  const double p11 = s.cosine * s.t11 - s.sine * t21;
  const double p12 = s.cosine * t12 - s.sine * s.t22;
  const double p21 = s.sine * s.t11 + s.cosine * t21;
  const double p22 = s.sine * t12 + s.cosine * s.t22;
  std::array<Vec2, 3> force;
  for (int i = 1; i < 3; ++i) {
    const Vec2 g = shape.gradient[i];
    force[i] = {-shape.area * (p11 * g.x + p12 * g.y), -shape.area * (p21 * g.x + p22 * g.y)};
  }
  force[0] = {-force[1].x - force[2].x, -force[1].y - force[2].y};
  return force;
}

/// Cauchy stress (xx, yy, zz, xy) in MPa, tension positive: sigma = P F' / det F, Eq. (P5).
std::array<double, 4> cauchy_stress(const DeformationGradient& f, const BiotState& s, const ElasticConstants& c);

}  // namespace asperity
