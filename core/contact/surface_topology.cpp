#include "core/contact/surface_topology.hpp"

#include <cmath>

namespace asperity {
namespace {

int edge_index(const Mesh& mesh, int triangle, int from_vertex) {
  for (int k = 0; k < 3; ++k) {
    if (mesh.triangles[triangle][k] == from_vertex) return 3 * triangle + k;
  }
  return -1;
}

/// Contacts follow the mesh's edges in order, without the outline's and those inside a grain.
void join_edges(const Mesh& mesh, const BondedContacts& contacts, SurfaceTopology& topology) {
  std::size_t contact = 0;
  for (const MeshEdge& edge : mesh_edges(mesh)) {
    if (edge.right < 0) continue;
    const int left = edge_index(mesh, edge.left, edge.a), right = edge_index(mesh, edge.right, edge.b);
    topology.partner[left] = right;
    topology.partner[right] = left;
    const bool bonded = contact < contacts.size() && contacts.edges[contact].left_triangle == edge.left &&
                        contacts.edges[contact].right_triangle == edge.right;
    topology.joint[left] = topology.joint[right] = bonded ? static_cast<int>(contact++) : kGrain;
  }
}

/// Edge that bounds triangle t counter-clockwise around its corner: it arrives there.
int arriving_edge(int triangle, int corner) { return 3 * triangle + (corner + 2) % 3; }

double corner_angle(const Mesh& mesh, int triangle, int corner) {
  const auto& v = mesh.triangles[triangle];
  const Vec2 at = mesh.vertices[v[corner]];
  const Vec2 a = mesh.vertices[v[(corner + 1) % 3]] - at, b = mesh.vertices[v[(corner + 2) % 3]] - at;
  return std::atan2(cross(a, b), dot(a, b));
}

/// Lists the fan that contains `start`, which has the outline on its clockwise side if the fan has an end.
void list_fan(const Mesh& mesh, SurfaceTopology& topology, FanEntry start, std::vector<std::uint8_t>& listed) {
  FanEntry entry = start;
  while (true) {
    const int edge = arriving_edge(entry.triangle, entry.corner);
    entry.joint = topology.joint[edge];
    topology.fan.push_back(entry);
    listed[3 * entry.triangle + entry.corner] = 1;
    if (entry.joint == kOutline) return;
    const int beyond = topology.partner[edge];
    entry = {beyond / 3, beyond % 3, 0, corner_angle(mesh, beyond / 3, beyond % 3)};
    if (listed[3 * entry.triangle + entry.corner]) return;
  }
}

void list_fans(const Mesh& mesh, SurfaceTopology& topology) {
  std::vector<std::vector<FanEntry>> around(mesh.vertices.size());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) around[mesh.triangles[t][k]].push_back({t, k, 0, corner_angle(mesh, t, k)});
  }
  std::vector<std::uint8_t> listed(3 * mesh.triangles.size(), 0);
  topology.fan_begin.push_back(0);
  for (const auto& corners : around) {
    for (const FanEntry& c : corners) {
      if (topology.joint[3 * c.triangle + c.corner] == kOutline) list_fan(mesh, topology, c, listed);
    }
    for (const FanEntry& c : corners) {
      if (!listed[3 * c.triangle + c.corner]) list_fan(mesh, topology, c, listed);
    }
    topology.fan_begin.push_back(static_cast<int>(topology.fan.size()));
  }
}

}  // namespace

SurfaceTopology make_surface_topology(const Mesh& mesh, const BondedContacts& contacts) {
  SurfaceTopology topology;
  topology.joint.assign(3 * mesh.triangles.size(), kOutline);
  topology.partner.assign(3 * mesh.triangles.size(), -1);
  topology.vertex = mesh.triangles;
  join_edges(mesh, contacts, topology);
  list_fans(mesh, topology);
  return topology;
}

}  // namespace asperity
