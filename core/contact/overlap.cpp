#include "core/contact/overlap.hpp"

namespace asperity {
namespace {

/// A convex polygon of at most eight corners, each known by its depths below the three edges of a triangle.
struct Polygon {
  std::array<std::array<double, 3>, 8> corner;  // only the first `size` are set
  int size = 0;
  void add(const std::array<double, 3>& depths) { corner[size++] = depths; }
};

/// Keeps the part where keep(depths) >= 0; keep is linear.
template <class Keep>
Polygon clip(const Polygon& polygon, const Keep& keep) {
  std::array<double, 8> at;
  double least = 0.0;
  for (int i = 0; i < polygon.size; ++i) {
    at[i] = keep(polygon.corner[i]);
    least = std::min(least, at[i]);
  }
  if (least == 0.0) return polygon;
  Polygon result;
  for (int i = 0; i < polygon.size; ++i) {
    const int next = i + 1 < polygon.size ? i + 1 : 0;
    const auto &p = polygon.corner[i], &q = polygon.corner[next];
    const double at_p = at[i], at_q = at[next];
    if (at_p >= 0.0) result.add(p);
    if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0)) {
      const double s = at_p / (at_p - at_q);
      std::array<double, 3> cut;
      for (int k = 0; k < 3; ++k) cut[k] = p[k] + s * (q[k] - p[k]);
      result.add(cut);
    }
  }
  return result;
}

/// Sum of all products of three of a, b, c, repetitions included: ten times the mean of the cube of a linear function.
double cubic_mean(double a, double b, double c) {
  return (a * a * (a + b + c) + b * b * (a + b + c) + c * c * (a + b + c) + a * b * c) / 10.0;
}

/// Integral of the pressure depth over a polygon nearest to edge k, in units of (depth 0) x (depth 1) area.
double integral(const Polygon& polygon, int k, double stiffening) {
  double sum = 0.0;
  for (int i = 1; i + 1 < polygon.size; ++i) {
    const auto &a = polygon.corner[0], &b = polygon.corner[i], &c = polygon.corner[i + 1];
    const double twice_area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    sum += 0.5 * twice_area * ((a[k] + b[k] + c[k]) / 3.0 + stiffening * cubic_mean(a[k], b[k], c[k]));
  }
  return sum;
}

}  // namespace

double overlap_potential(const PresentTriangle& in, const std::array<Vec2, 3>& corners, double stiffening,
                         double seat) {
  DepthTable d;
  if (!depth_table(in, corners, seat, d)) return 0.0;
  Polygon shared;
  for (int j = 0; j < 3; ++j) shared.add({d[0][j], d[1][j], d[2][j]});
  for (int k = 0; k < 3; ++k) shared = clip(shared, [k](const auto& p) { return p[k]; });
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    Polygon nearest = clip(shared, [k, l](const auto& p) { return p[l] - p[k]; });
    nearest = clip(nearest, [k, m](const auto& p) { return p[m] - p[k]; });
    sum += integral(nearest, k, stiffening);
  }
  // depth 0 and depth 1 have unit gradients at rest whose angle is the one between two edges.
  const double present_area = cross(in.gradient[0], in.gradient[1]);
  return sum * in.inverse_jacobian / present_area;
}

}  // namespace asperity
