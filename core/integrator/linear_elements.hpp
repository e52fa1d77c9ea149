#pragma once
#include <array>

#include "core/contact/bonded_contacts.hpp"
#include "core/particles/elasticity.hpp"

/// Linear elastic forces of triangles and contact edges for small displacements: the element matrices of K.
namespace asperity {

/// Linear elastic forces (N per mm of thickness) of a triangle for small corner displacements u (mm).
inline std::array<Vec2, 3> linear_triangle(const TriangleShape& shape, const std::array<Vec2, 3>& u,
                                           const ElasticConstants& c) {
  double exx = 0, eyy = 0, gxy = 0;
  for (int i = 0; i < 3; ++i) {
    exx += u[i].x * shape.gradient[i].x;
    eyy += u[i].y * shape.gradient[i].y;
    gxy += u[i].x * shape.gradient[i].y + u[i].y * shape.gradient[i].x;
  }
  const double sxx = c.c11 * exx + c.c12 * eyy, syy = c.c12 * exx + c.c11 * eyy, sxy = c.shear * gxy;
  std::array<Vec2, 3> force;
  for (int i = 0; i < 3; ++i) {
    const Vec2 g = shape.gradient[i];
    force[i] = shape.area * Vec2{sxx * g.x + sxy * g.y, sxy * g.x + syy * g.y};
  }
  return force;
}

/// Stiffness of one contact point along the normal and the tangent, MPa/mm.
struct PointStiffness {
  double normal = 0, shear = 0;
};

/// Linear forces (N per mm of thickness) of a contact edge for small displacements u (mm) of left1, left2, right1,
/// right2.
inline std::array<Vec2, 4> linear_contact(const ContactEdge& edge, const ContactFrame& frame,
                                          const std::array<Vec2, 4>& u, const std::array<PointStiffness, 2>& points) {
  const Vec2 gap[2] = {u[2] - u[0], u[3] - u[1]};
  constexpr double weight[2][2] = {{kNearGauss, kFarGauss}, {kFarGauss, kNearGauss}};
  Vec2 end[2] = {};
  for (int q = 0; q < 2; ++q) {
    const Vec2 d = weight[q][0] * gap[0] + weight[q][1] * gap[1];
    const Vec2 traction = (points[q].normal * dot(d, frame.normal)) * frame.normal +
                          (points[q].shear * dot(d, frame.tangent)) * frame.tangent;
    for (int i = 0; i < 2; ++i) end[i] += (0.5 * edge.length * weight[q][i]) * traction;
  }
  return {Vec2{} - end[0], Vec2{} - end[1], end[0], end[1]};
}

/// The same with both points at the law's initial stiffness.
inline std::array<Vec2, 4> linear_contact(const ContactEdge& edge, const ContactFrame& frame,
                                          const std::array<Vec2, 4>& u, const LawParameters& law) {
  const PointStiffness initial{law.k_t, law.k_s};
  return linear_contact(edge, frame, u, {initial, initial});
}

/// Columns of an element's matrix over 2 N displacements, x before y of each node; apply(u) is K u of the element.
template <std::size_t N, class Apply>
std::array<std::array<Vec2, N>, 2 * N> element_columns(const Apply& apply) {
  std::array<std::array<Vec2, N>, 2 * N> columns;
  for (std::size_t j = 0; j < 2 * N; ++j) {
    std::array<Vec2, N> u{};
    (j % 2 == 0 ? u[j / 2].x : u[j / 2].y) = 1.0;
    columns[j] = apply(u);
  }
  return columns;
}

}  // namespace asperity
