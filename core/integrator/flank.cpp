#include "core/integrator/flank.hpp"

#include <algorithm>

#include "core/integrator/platen_contact.hpp"

namespace asperity {
namespace {

bool on_platen(const System& system, int node) {
  const double y = system.particles.position[node].y;
  const double skin = system.platen_springs.at(node).skin;
  const double rise = face_rise(system.platens, system.particles.reference(node).x);
  return y < system.platens.y[0] - skin || y > system.platens.y[1] + rise + skin;
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
    if (!contacts.is_broken(c)) continue;
    const auto points = contacts.points(c);
    if (points[0].traction_n < 0.0 || points[1].traction_n < 0.0) {
      touching.push_back({contacts.edges[c].left_triangle(), contacts.edges[c].right_triangle()});
    }
  }
  return touching;
}

/// The outline's edges, then both faces of every broken contact.
std::vector<ExposedEdge> present_surface(const System& system) {
  std::vector<ExposedEdge> surface = system.flank.outline;
  const BondedContacts& contacts = system.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (!contacts.is_broken(c)) continue;
    const ContactEdge& e = contacts.edges[c];
    surface.push_back(
        {{e.left1, e.left2}, e.left_triangle(), on_platen(system, e.left1) && on_platen(system, e.left2)});
    surface.push_back(
        {{e.right2, e.right1}, e.right_triangle(), on_platen(system, e.right1) && on_platen(system, e.right2)});
  }
  return surface;
}

bool anything_broken(const BondedContacts& contacts) {
  return std::any_of(contacts.broken.begin(), contacts.broken.end(),
                     [](const BrokenEdge& b) { return b.break_time >= 0.0; });
}

/// Whether the loads' nodes are those of the edges.
bool is_listed(const NodeLoads& loads, const std::vector<LoadedEdge>& edges) {
  return std::equal(edges.begin(), edges.end(), loads.places.begin(), loads.places.end(),
                    [&](const LoadedEdge& e, const std::array<int, 2>& place) {
                      return loads.nodes[place[0]] == e.nodes[0] && loads.nodes[place[1]] == e.nodes[1];
                    });
}

void list_loaded_nodes(NodeLoads& loads, const std::vector<LoadedEdge>& edges) {
  loads = {};
  for (const LoadedEdge& e : edges) loads.nodes.insert(loads.nodes.end(), e.nodes.begin(), e.nodes.end());
  std::sort(loads.nodes.begin(), loads.nodes.end());
  loads.nodes.erase(std::unique(loads.nodes.begin(), loads.nodes.end()), loads.nodes.end());
  loads.forces.resize(loads.nodes.size());
  const auto place_of = [&](int node) {
    return static_cast<int>(std::lower_bound(loads.nodes.begin(), loads.nodes.end(), node) - loads.nodes.begin());
  };
  for (const LoadedEdge& e : edges) loads.places.push_back({place_of(e.nodes[0]), place_of(e.nodes[1])});
}

}  // namespace

void follow_outer_surface(System& system) {
  if (system.flank.pressure == 0.0 || system.step % kFlankInterval != 0 || !system.general.law.enabled) return;
  if (!anything_broken(system.contacts)) return;
  const Particles& p = system.particles;
  const std::vector<std::uint8_t> carries =
      carrying_triangles(system.contacts, p, triangles_on_platen(system), touching_triangles(system));
  const std::vector<int> joined = joined_nodes(system.contacts, p.node_count());
  system.flank.edges = find_loaded_edges(closed_positions(p.position, joined), present_surface(system), carries);
}

void apply_flank_pressure(System& system) {
  NodeLoads& loads = system.loads;
  const std::vector<LoadedEdge>& edges = system.flank.edges;
  if (system.flank.pressure == 0.0) {
    loads = {};
    return;
  }
  if (!is_listed(loads, edges)) list_loaded_nodes(loads, edges);
  std::fill(loads.forces.begin(), loads.forces.end(), Vec2{});
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Vec2 force = pressure_on_end(edges[i], system.particles.position, system.flank.pressure);
    for (int place : loads.places[i]) loads.forces[place] += force;
  }
}

}  // namespace asperity
