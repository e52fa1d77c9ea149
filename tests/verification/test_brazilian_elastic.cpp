#include <Eigen/SparseCholesky>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/geometry/specimen.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

constexpr double kDiameter = 54.0, kRadius = 27.0, kLoad = 100.0;  // mm, mm, N per mm of thickness

Particles disc(double edge, std::uint64_t seed) {
  RunConfig config = test::plaster();
  config.particles.edge_mm = edge;
  config.particles.edge_deviation_mm = 0.1 * edge;
  config.particles.seed = seed;
  return make_particles(test::continuum(make_mesh(config.experiment, config.particles)), config.particles,
                        PlaneCondition::stress);
}

std::array<std::array<double, 6>, 6> triangle_stiffness(const TriangleShape& shape, const ElasticConstants& c) {
  std::array<std::array<double, 6>, 6> k{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec2 a = shape.gradient[i], b = shape.gradient[j];
      k[2 * i][2 * j] = shape.area * (c.c11 * a.x * b.x + c.shear * a.y * b.y);
      k[2 * i][2 * j + 1] = shape.area * (c.c12 * a.x * b.y + c.shear * a.y * b.x);
      k[2 * i + 1][2 * j] = shape.area * (c.c12 * a.y * b.x + c.shear * a.x * b.y);
      k[2 * i + 1][2 * j + 1] = shape.area * (c.c11 * a.y * b.y + c.shear * a.x * b.x);
    }
  }
  return k;
}

int node_at(const Particles& p, Vec2 place) {
  for (std::size_t i = 0; i < p.node_count(); ++i) {
    if (norm(p.reference(i) - place) < 1e-9) return static_cast<int>(i);
  }
  return -1;
}

/// K of the disc; three stiff springs take its rigid motions and carry no load, because the loads balance.
Eigen::SparseMatrix<double> stiffness(const Particles& p, int bottom, int top) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t t = 0; t < p.triangle_count(); ++t) {
    const auto k = triangle_stiffness(p.shape(t), p.elastic);
    const auto dof = [&](std::size_t i) { return 2 * p.triangles[t][i / 2] + static_cast<int>(i % 2); };
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) entries.emplace_back(dof(i), dof(j), k[i][j]);
    }
  }
  for (int dof : {2 * bottom, 2 * bottom + 1, 2 * top}) entries.emplace_back(dof, dof, 1e4);
  const int size = 2 * static_cast<int>(p.node_count());
  Eigen::SparseMatrix<double> k(size, size);
  k.setFromTriplets(entries.begin(), entries.end());
  return k;
}

void load_poles(Particles& p) {
  const int bottom = node_at(p, {0, 0}), top = node_at(p, {0, kDiameter});
  REQUIRE(bottom >= 0);
  REQUIRE(top >= 0);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * static_cast<int>(p.node_count()));
  load[2 * bottom + 1] = kLoad;
  load[2 * top + 1] = -kLoad;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(stiffness(p, bottom, top));
  REQUIRE(solver.info() == Eigen::Success);
  // Small displacements, so that the core's finite strain stress is the linear one to 1e-6.
  const Eigen::VectorXd u = 1e-5 * solver.solve(load);
  for (std::size_t i = 0; i < p.node_count(); ++i) p.position[i] = p.reference(i) + Vec2{u[2 * i], u[2 * i + 1]};
}

/// sigma_xx of the exact solution at a place off the centre: two point loads' radial fields and a uniform tension.
double exact_stress(Vec2 r) {
  double sum = 1.0 / kDiameter;
  for (const double y : {kRadius - r.y, kRadius + r.y}) {
    const double square = r.x * r.x + y * y;
    sum -= r.x * r.x * y / (square * square);
  }
  return 2.0 * kLoad / std::numbers::pi * sum;
}

struct Centre {
  double found = 0, exact = 0;
};

/// Mean sigma_xx over the triangles within a fifth of the radius, and that of the exact field.
Centre centre_stress(const Particles& p) {
  Centre sum;
  double area = 0.0;
  for (std::size_t t = 0; t < p.triangle_count(); ++t) {
    Vec2 place{0, -kRadius};
    for (int node : p.triangles[t]) place += (1.0 / 3.0) * p.reference(static_cast<std::size_t>(node));
    if (norm(place) > 0.2 * kRadius) continue;
    area += p.shape(t).area;
    sum.found += 1e5 * p.shape(t).area * triangle_stress(p, t)[0];
    sum.exact += p.shape(t).area * exact_stress(place);
  }
  return {sum.found / area, sum.exact / area};
}

/// Root mean square over meshes of the relative error of the centre stress.
double centre_error(double edge) {
  constexpr int kMeshes = 4;
  double square = 0.0, ratio = 0.0;
  for (std::uint64_t seed = 1; seed <= kMeshes; ++seed) {
    Particles p = disc(edge, seed);
    load_poles(p);
    const Centre c = centre_stress(p);
    square += std::pow(c.found / c.exact - 1.0, 2) / kMeshes;
    ratio += c.found / (2.0 * kLoad / std::numbers::pi / kDiameter) / kMeshes;
  }
  WARN("elastic disc, edge " << edge << " mm: mean over the middle " << ratio
                             << " of 2P/(pi D t); rms error against the exact "
                             << "mean there " << std::sqrt(square));
  return std::sqrt(square);
}

}  // namespace

TEST_CASE("The elastic disc's centre stress converges to 2P/(pi D t)") {
  CHECK(exact_stress({0, 0}) == Approx(2.0 * kLoad / std::numbers::pi / kDiameter));
  const double coarse = centre_error(5.4), middle = centre_error(3.6), fine = centre_error(2.4);
  const double slope = std::log(coarse / fine) / std::log(5.4 / 2.4);
  WARN("elastic disc: convergence slope " << slope);
  // Some (edge / radius of the mean)^2 / 24 = 4 % and 0.8 % for constant-strain triangles.
  CHECK(coarse < 0.05);
  CHECK(middle < coarse);
  CHECK(fine < 0.01);
  CHECK(slope > 1.0);  // means of a constant-strain mesh converge with slope 2; four irregular meshes scatter about it
}
