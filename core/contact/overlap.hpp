#pragma once
#include <algorithm>
#include <array>

#include "core/base/vec2.hpp"
#include "core/particles/elasticity.hpp"

/// Overlap of two triangles and its potential, Eqs. (C40)-(C43): pure functions of the corners' positions. Edge k of a
/// triangle runs from corner k to corner k + 1.
namespace asperity {

/// A triangle as it lies now, seen from its own shape at rest. Depths are those of the material point at rest, mm.
struct PresentTriangle {
  std::array<Vec2, 3> x;         ///< Corners, mm.
  std::array<Vec2, 3> gradient;  ///< Of the depth below each edge, with respect to present position.
  std::array<double, 3> height;  ///< Altitude on each edge at rest, mm.
  double inverse_jacobian;       ///< Area at rest over present area.

  /// Depth of point y below edge k, positive on the triangle's side.
  double depth(int k, Vec2 y) const { return dot(gradient[k], y - x[k]); }
};

inline PresentTriangle present_triangle(const TriangleShape& shape, const std::array<Vec2, 3>& x) {
  PresentTriangle t;
  t.x = x;
  const double area = 0.5 * cross(x[1] - x[0], x[2] - x[0]);
  t.inverse_jacobian = shape.area / area;
  for (int k = 0; k < 3; ++k) {
    t.height[k] = 1.0 / norm(shape.gradient[(k + 2) % 3]);
    const Vec2 along = x[(k + 1) % 3] - x[k];
    t.gradient[k] = (0.5 * t.height[k] / area) * Vec2{-along.y, along.x};
  }
  return t;
}

/// Depths of the three corners of one triangle below the three edges of another: [edge of the other][corner].
using DepthTable = std::array<std::array<double, 3>, 3>;

/// Fills the table with depths less `seat` (mm), Eq. (C54); false as soon as one edge of `in` has all of `corners`
/// outside.
inline bool depth_table(const PresentTriangle& in, const std::array<Vec2, 3>& corners, double seat, DepthTable& table) {
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 3; ++j) table[k][j] = in.depth(k, corners[j]) - seat;
    if (table[k][0] <= 0.0 && table[k][1] <= 0.0 && table[k][2] <= 0.0) return false;
  }
  return true;
}

/// Pressure at depth phi over the penalty, Eq. (C40): linear, and stiffer where the overlap gets deep. `stiffening` is
/// 1 / mm2; 0: linear throughout.
inline double pressure_depth(double phi, double stiffening) { return phi * (1.0 + stiffening * phi * phi); }

/// The part of an edge that lies inside another triangle, as parameters 0 to 1 along the edge, and the moments of the
/// pressure depth q over it: int q ds and int s q ds (mm).
struct EdgePart {
  double begin = 0, end = 0;
  double m0 = 0, m1 = 0;
  double deepest = 0;  ///< Largest phi, mm.

  double centre() const { return m1 / m0; }  ///< Of the pressure, as a parameter along the edge.
};

namespace detail {

/// The smallest of three linear functions at s, each given by its values at 0 and 1.
inline double least(const DepthTable& d, int j, double s) {
  const int next = (j + 1) % 3;
  double least = d[0][j] + s * (d[0][next] - d[0][j]);
  for (int k = 1; k < 3; ++k) least = std::min(least, d[k][j] + s * (d[k][next] - d[k][j]));
  return least;
}

/// Where two of the three linear functions cross inside (begin, end): up to three values, sorted.
inline int crossings(const DepthTable& d, int j, double begin, double end, std::array<double, 3>& s) {
  const int next = (j + 1) % 3;
  int count = 0;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3;
    const double at0 = d[k][j] - d[l][j], at1 = d[k][next] - d[l][next];
    if (at0 * at1 >= 0.0) continue;
    const double cut = at0 / (at0 - at1);
    if (cut <= begin || cut >= end) continue;
    int place = count++;
    for (; place > 0 && s[place - 1] > cut; --place) s[place] = s[place - 1];
    s[place] = cut;
  }
  return count;
}

/// Adds the moments between u and v, where phi is linear: three Gauss points are exact for the polynomial of degree 4.
inline void add_moments(EdgePart& part, double u, double phi_u, double v, double phi_v, double stiffening) {
  constexpr std::array<double, 3> place{0.1127016653792583, 0.5, 0.8872983346207417};
  constexpr std::array<double, 3> weight{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  for (int g = 0; g < 3; ++g) {
    const double q = (v - u) * weight[g] * pressure_depth(phi_u + place[g] * (phi_v - phi_u), stiffening);
    part.m0 += q;
    part.m1 += q * (u + place[g] * (v - u));
  }
}

}  // namespace detail

/// The part of edge j of the triangle whose depths stand in the table, with phi the depth below the nearest edge of the
/// other triangle. The integrals are exact: phi is linear between crossings.
inline EdgePart edge_part(const DepthTable& d, int j, double stiffening = 0.0) {
  const int next = (j + 1) % 3;
  EdgePart part{0.0, 1.0, 0.0, 0.0, 0.0};
  for (int k = 0; k < 3; ++k) {
    const double at0 = d[k][j], at1 = d[k][next];
    if (at0 <= 0.0 && at1 <= 0.0) return {};
    if (at0 < 0.0) part.begin = std::max(part.begin, at0 / (at0 - at1));
    if (at1 < 0.0) part.end = std::min(part.end, at0 / (at0 - at1));
  }
  if (part.begin >= part.end) return {};
  std::array<double, 3> cuts;
  const int count = detail::crossings(d, j, part.begin, part.end, cuts);
  double u = part.begin, phi_u = std::max(0.0, detail::least(d, j, u));
  for (int i = 0; i <= count; ++i) {
    const double v = i < count ? cuts[i] : part.end;
    const double phi_v = std::max(0.0, detail::least(d, j, v));
    detail::add_moments(part, u, phi_u, v, phi_v, stiffening);
    part.deepest = std::max({part.deepest, phi_u, phi_v});
    u = v;
    phi_u = phi_v;
  }
  return part;
}

/// Integral of the pressure depth of `in`, beyond a seat (mm), over its overlap with another triangle, in the rest area
/// of `in` (mm3); Eqs. (C41), (C54).
double overlap_potential(const PresentTriangle& in, const std::array<Vec2, 3>& corners, double stiffening = 0.0,
                         double seat = 0.0);

}  // namespace asperity
