#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/contact/bonded_contacts.hpp"
#include "core/geometry/mesh.hpp"
#include "core/particles/particles.hpp"

namespace asperity {

/// What joins a triangle's edge to the triangle beyond it: the index of a bonded contact, or one of these.
inline constexpr int kOutline = -1;  ///< Nothing: the edge lies on the outline.
inline constexpr int kGrain = -2;    ///< The same grain: the two share their nodes for good.

/// One triangle around a mesh vertex.
struct FanEntry {
  int triangle;
  int corner;    ///< Its corner at the vertex.
  int joint;     ///< What joins it to the next entry counter-clockwise; kOutline ends a fan.
  double angle;  ///< Of that corner at rest, rad.
};

/// How triangles hang together at rest: never changes. Edge k of triangle t has index 3 t + k.
struct SurfaceTopology {
  std::vector<int> joint;    ///< Of each triangle edge: a contact, kOutline or kGrain.
  std::vector<int> partner;  ///< Of each triangle edge: index of the edge beyond it, -1 on the outline.
  std::vector<int> fan_begin;
  std::vector<FanEntry> fan;  ///< Entries of vertex v: fan[fan_begin[v]] ... counter-clockwise, fan after fan.
  std::vector<std::array<int, 3>> vertex;  ///< Mesh vertices of each triangle's corners.
};

SurfaceTopology make_surface_topology(const Mesh& mesh, const BondedContacts& contacts);

}  // namespace asperity
