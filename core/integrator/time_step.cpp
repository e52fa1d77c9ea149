#include "core/integrator/time_step.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/random.hpp"
#include "core/integrator/linear_elements.hpp"

namespace asperity {
namespace {

/// The bonded law, or what a broken contact becomes where that is stiffer.
LawParameters stiffest_law(const System& system) {
  LawParameters law = system.contacts.law;
  if (!system.general.law.enabled) return law;
  const SurfaceLaw& fracture = system.general.law.surfaces[static_cast<int>(SurfaceKind::fracture)];
  law.k_t = std::max(law.k_t, fracture.k_n);
  law.k_s = std::max(law.k_s, fracture.k_s);
  return law;
}

/// Springs to the ground that stand for what a node may meet, N/mm per mm of thickness: a platen, or another body's
/// surface of equal mass, against which half an edge's penalty counts twice.
std::vector<double> ground_springs(const System& system) {
  const Particles& p = system.particles;
  std::vector<double> springs(p.node_count(), 0.0);
  const int edges = system.general.law.enabled ? static_cast<int>(3 * p.triangle_count()) : 0;
  for (int edge = 0; edge < edges; ++edge) {
    if (system.contacts.joint(edge) != kOutline) continue;
    const auto& nodes = p.triangles[edge / 3];
    const int a = nodes[edge % 3], b = nodes[(edge % 3 + 1) % 3];
    const SurfaceLaw& law = system.general.law.surfaces[static_cast<int>(SurfaceKind::outline)];
    const double stiffness = std::max(law.k_n, law.k_s) * norm(p.reference(b) - p.reference(a));
    springs[a] += stiffness;
    springs[b] += stiffness;
  }
  if (system.platens.present) {
    for (std::size_t i = 0; i < springs.size(); ++i) {
      springs[i] = std::max(springs[i], system.platen_springs.at(i).stiffness);
    }
  }
  return springs;
}

/// K u, node by node.
std::vector<Vec2> apply_stiffness(const System& system, const std::vector<double>& springs, const std::vector<Vec2>& u,
                                  const ParallelLoops& loops) {
  const Particles& p = system.particles;
  const std::size_t triangles = p.triangle_count();
  const LawParameters law = stiffest_law(system);
  const std::size_t corners = 2 * system.contacts.slot_count();
  std::vector<Vec2> forces(corners + 3 * triangles);
  loops.for_blocks(triangles, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& n = p.triangles[t];
      const auto f = linear_triangle(p.shape(t), {u[n[0]], u[n[1]], u[n[2]]}, p.elastic_of(t));
      for (std::size_t i = 0; i < 3; ++i) forces[corners + 3 * t + i] = f[i];
    }
  });
  loops.for_blocks(system.contacts.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const ContactEdge& e = system.contacts.edges[c];
      const auto f = linear_contact(e, reference_frame(e, p), {u[e.left1], u[e.left2], u[e.right1], u[e.right2]}, law);
      forces[force_index(c, ContactNode::left1)] = f[0];
      forces[force_index(c, ContactNode::left2)] = f[1];
      forces[force_index(c, ContactNode::right1)] = f[2];
      forces[force_index(c, ContactNode::right2)] = f[3];
    }
  });
  std::vector<Vec2> result(u.size());
  loops.for_blocks(u.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
      result[node] = springs[node] * u[node] + gather_force(system, node, forces);
    }
  });
  return result;
}

std::vector<Vec2> random_start(std::size_t n) {
  RandomStream random(1, "power iteration");
  std::vector<Vec2> u(n);
  for (Vec2& v : u) v = {random.normal(), random.normal()};
  return u;
}

/// Adds, for each of N nodes, the larger row sum of |K| over its two components; apply(u) is K u of one element.
template <std::size_t N, class Apply>
void add_row_sums(const std::array<int, N>& nodes, const Apply& apply, std::vector<double>& rows) {
  std::array<Vec2, N> sum{};
  for (std::size_t j = 0; j < 2 * N; ++j) {
    std::array<Vec2, N> u{};
    (j % 2 == 0 ? u[j / 2].x : u[j / 2].y) = 1.0;
    const std::array<Vec2, N> column = apply(u);
    for (std::size_t i = 0; i < N; ++i) sum[i] += {std::abs(column[i].x), std::abs(column[i].y)};
  }
  for (std::size_t i = 0; i < N; ++i) rows[nodes[i]] += std::max(sum[i].x, sum[i].y);
}

/// Gershgorin's bound of each node's stiffness: sums over its elements and its spring to the ground.
std::vector<double> gershgorin_rows(const System& system) {
  const Particles& p = system.particles;
  std::vector<double> rows = ground_springs(system);
  const LawParameters law = stiffest_law(system);
  for (std::size_t t = 0; t < p.triangle_count(); ++t) {
    add_row_sums<3>(
        p.triangles[t], [&](const auto& u) { return linear_triangle(p.shape(t), u, p.elastic_of(t)); }, rows);
  }
  for (const ContactEdge& e : system.contacts.edges) {
    const ContactFrame frame = reference_frame(e, p);
    add_row_sums<4>(
        {e.left1, e.left2, e.right1, e.right2}, [&](const auto& u) { return linear_contact(e, frame, u, law); }, rows);
  }
  return rows;
}

}  // namespace

double critical_time_step(const System& system, const ParallelLoops& loops) {
  const std::vector<double>& mass = system.particles.mass;
  const std::vector<double> springs = ground_springs(system);
  std::vector<Vec2> u = random_start(mass.size());
  double eigenvalue = 0.0;
  for (int iteration = 0; iteration < 2000; ++iteration) {
    double size = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) size += mass[i] * dot(u[i], u[i]);
    for (Vec2& v : u) v = (1.0 / std::sqrt(size)) * v;
    const std::vector<Vec2> ku = apply_stiffness(system, springs, u, loops);
    double rayleigh = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) rayleigh += dot(u[i], ku[i]);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = (1.0 / mass[i]) * ku[i];
    const double change = std::abs(rayleigh - eigenvalue);
    eigenvalue = rayleigh;
    if (iteration > 20 && change < 1e-5 * eigenvalue) {
      const double ratio = system.general.law.damping_ratio;
      return 2.0 / std::sqrt(eigenvalue) * (std::sqrt(1.0 + ratio * ratio) - ratio);
    }
  }
  throw Error(ErrorKind::numerical, "the power iteration for the stable time step did not converge in 2000 iterations");
}

double scale_masses_uniformly(System& system, double critical_step, const ParallelLoops& loops) {
  constexpr double kTolerance = 1e-3;
  const std::vector<double> unscaled = system.particles.mass;
  double own_step = critical_step;
  double added = 0.0;
  for (int iteration = 0; iteration < 20; ++iteration) {
    system.particles.mass = unscaled;
    added = scale_masses(system, own_step, 1.0);
    const double found = critical_time_step(system, loops);
    if (std::abs(found - critical_step) < kTolerance * critical_step) return added;
    own_step *= critical_step / found;
  }
  throw Error(ErrorKind::numerical, "mass scaling did not reach the critical time step asked for in 20 iterations");
}

double scale_masses(System& system, double time_step, double safety_factor) {
  const std::vector<double> rows = gershgorin_rows(system);
  const double step = time_step / safety_factor;
  double before = 0.0, added = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double needed = 0.25 * rows[i] * step * step;
    before += system.particles.mass[i];
    if (needed > system.particles.mass[i]) {
      added += needed - system.particles.mass[i];
      system.particles.mass[i] = needed;
    }
  }
  return added / before;
}

}  // namespace asperity
