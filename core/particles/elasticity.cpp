#include "core/particles/elasticity.hpp"

namespace asperity {

ElasticConstants elastic_constants(double e, double nu, PlaneCondition plane) {
  const double shear = e / (2.0 * (1.0 + nu));
  if (plane == PlaneCondition::stress) {
    const double c11 = e / (1.0 - nu * nu);
    return {c11, nu * c11, shear, 0.0};
  }
  const double lame = e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  return {lame + 2.0 * shear, lame, shear, nu};
}

TriangleShape triangle_shape(Vec2 a, Vec2 b, Vec2 c) {
  const double twice_area = cross(b - a, c - a);
  const auto gradient = [&](Vec2 from, Vec2 to) {
    return Vec2{(from.y - to.y) / twice_area, (to.x - from.x) / twice_area};
  };
  return {{gradient(b, c), gradient(c, a), gradient(a, b)}, 0.5 * twice_area};
}

std::array<double, 4> cauchy_stress(const DeformationGradient& f, const BiotState& s, const ElasticConstants& c) {
  const double t21 = s.t12 - s.spin, t12 = s.t12 + s.spin;
  const double p11 = s.cosine * s.t11 - s.sine * t21;
  const double p12 = s.cosine * t12 - s.sine * s.t22;
  const double p21 = s.sine * s.t11 + s.cosine * t21;
  const double p22 = s.sine * t12 + s.cosine * s.t22;
  const double inverse = 1.0 / f.jacobian();
  const double xx = inverse * (p11 * f.xx + p12 * f.xy);
  const double yy = inverse * (p21 * f.yx + p22 * f.yy);
  const double xy = inverse * (p11 * f.yx + p12 * f.yy);
  return {xx, yy, c.out_of_plane * (xx + yy), xy};
}

}  // namespace asperity
