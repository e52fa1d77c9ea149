#include "core/integrator/flank.hpp"

#include <algorithm>

namespace asperity {
namespace {

bool on_platen(const System& system, int node) {
  const double y = system.particles.position[node].y;
  const double skin = system.platen_springs[node].skin;
  return y < system.platens.y[0] - skin || y > system.platens.y[1] + skin;
}

std::vector<std::uint8_t> triangles_on_platen(const System& system) {
  const Particles& p = system.particles;
  std::vector<std::uint8_t> flags(p.triangle_count(), 0);
  for (std::size_t t = 0; t < p.triangle_count(); ++t) {
    const auto& n = p.triangles[t];
    flags[t] = on_platen(system, n[0]) || on_platen(system, n[1]) || on_platen(system, n[2]);
  }
  return flags;
}

/// Pairs of triangles that press on each other: general contacts, and broken contacts still with their own pair.
std::vector<std::array<int, 2>> touching_triangles(const System& system) {
  std::vector<std::array<int, 2>> touching;
  const GeneralContacts& general = system.general;
  for (const Touch& touch : general.touches) {
    const MemberPair& pair = general.pairs[touch.pair];
    touching.push_back({general.members[pair.a].triangle, general.members[pair.b].triangle});
  }
  const BondedContacts& contacts = system.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.break_time[c] < 0.0) continue;
    const auto& points = contacts.points[c];
    if (points[0].traction_n < 0.0 || points[1].traction_n < 0.0) {
      touching.push_back({contacts.edges[c].left_triangle, contacts.edges[c].right_triangle});
    }
  }
  return touching;
}

/// The outline's edges, then both faces of every broken contact.
std::vector<ExposedEdge> present_surface(const System& system) {
  std::vector<ExposedEdge> surface = system.flank.outline;
  const BondedContacts& contacts = system.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.break_time[c] < 0.0) continue;
    const ContactEdge& e = contacts.edges[c];
    surface.push_back({{e.left1, e.left2}, e.left_triangle, on_platen(system, e.left1) && on_platen(system, e.left2)});
    surface.push_back(
        {{e.right2, e.right1}, e.right_triangle, on_platen(system, e.right1) && on_platen(system, e.right2)});
  }
  return surface;
}

bool anything_broken(const BondedContacts& contacts) {
  return std::any_of(contacts.break_time.begin(), contacts.break_time.end(), [](double time) { return time >= 0.0; });
}

}  // namespace

void follow_outer_surface(System& system) {
  if (system.flank.pressure == 0.0 || system.step % kFlankInterval != 0 || !system.general.law.enabled) return;
  if (!anything_broken(system.contacts)) return;
  for (const LoadedEdge& e : system.flank.edges) {
    for (int node : e.nodes) system.external_force[node] = {0, 0};
  }
  const Particles& p = system.particles;
  const std::vector<std::uint8_t> carries =
      carrying_triangles(system.contacts, p, triangles_on_platen(system), touching_triangles(system));
  const std::vector<int> joined = joined_nodes(system.contacts, p.node_count());
  system.flank.edges = find_loaded_edges(closed_positions(p.position, joined), present_surface(system), carries);
}

void apply_flank_pressure(System& system) {
  for (const LoadedEdge& e : system.flank.edges) {
    for (int node : e.nodes) system.external_force[node] = {0, 0};
  }
  for (const LoadedEdge& e : system.flank.edges) {
    const Vec2 force = pressure_on_end(e, system.particles.position, system.flank.pressure);
    for (int node : e.nodes) system.external_force[node] += force;
  }
}

}  // namespace asperity
