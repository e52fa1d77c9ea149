#pragma once
#include "core/integrator/system.hpp"

/// One node's step, and the pass of the vector kernel over many. Internal to core/integrator.
namespace asperity {

/// Whether triangles write their forces for the nodes to gather, as they must where nodes are shared.
bool corners_written(const System& system);

/// Cundall's local damping, limited so that it never turns the motion round: Eq. (I4). `impulse` is 2 m / dt. Returns
/// the damping force.
double damping_force(double force, double coefficient, double mean_velocity, double impulse);

/// Velocities of nodes [begin, end) half a step ahead under the forces that each gathers, Eqs. (I1)-(I6), one after the
/// other.
NodeSums move_nodes_reference(System& system, std::size_t begin, std::size_t end);

/// One of those nodes under a given force of triangles and contacts.
void move_node_reference(System& system, std::size_t node, Vec2 internal, NodeSums& sums);

/// As move_nodes_reference(), in vector registers where nothing but forces acts on a node; begin is a multiple of 8.
/// Not with curved jaws or a body force.
NodeSums move_nodes_fast(System& system, std::size_t begin, std::size_t end);

/// The same for the nodes of one triangle, which are its own, under given forces of triangle and contacts (N per mm of
/// thickness).
void move_triangle_reference(System& system, std::size_t triangle, const std::array<Vec2, 3>& internal, NodeSums& sums);

/// Forces and velocities of all nodes of triangles [begin, end), whose nodes are their own; begin is a multiple of 8.
NodeSums move_triangles_fast(System& system, std::size_t begin, std::size_t end);

/// Forces of triangles [begin, end) on their corners, written behind the slots.
void compute_corner_forces(System& system, std::size_t begin, std::size_t end);

/// The same in vector registers, to the last bit; begin is a multiple of 8.
void compute_corner_forces_fast(System& system, std::size_t begin, std::size_t end);

}  // namespace asperity
