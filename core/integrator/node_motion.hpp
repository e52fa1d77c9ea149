#pragma once
#include "core/integrator/system.hpp"

/// One node's step, and the pass of the vector kernel over many. Internal to core/integrator.
namespace asperity {

/// Whether triangles write their forces for the nodes to gather, as they must where nodes are shared.
bool corners_written(const System& system);

/// Velocity of a node half a step ahead under the force (N per mm of thickness) of triangles and contacts, Eqs.
/// (I1)-(I6); what the energy account needs goes to sums.
void move_node(System& system, std::size_t node, Vec2 internal, NodeSums& sums);

/// Forces and velocities of all nodes of triangles [begin, end), whose nodes are their own; begin is a multiple of 8.
/// With `advance`, positions go one step ahead too.
NodeSums move_triangles_fast(System& system, std::size_t begin, std::size_t end, bool advance);

/// Forces of triangles [begin, end) on their corners, written behind the slots.
void compute_corner_forces(System& system, std::size_t begin, std::size_t end);

}  // namespace asperity
