#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/contact/bonded_contacts.hpp"
#include "core/contact/general_contact.hpp"
#include "core/integrator/drive_line.hpp"
#include "core/integrator/outer_surface.hpp"
#include "core/particles/particles.hpp"

namespace asperity {

/// The face of a curved jaw, Eq. (I20): an arc, concave towards the specimen, in a block that is level beyond it.
struct JawFace {
  double radius = 0;      ///< mm; 0: flat platens.
  double centre_x = 0;    ///< Of the arc, mm.
  double half_width = 0;  ///< Of the arc, mm.
  double depth = 0;       ///< Of its apex under the level, mm.
  bool operator==(const JawFace&) const = default;
};

/// How the upper platen's face is turned: its height grows with the place along the specimen at rest; Eqs. (I24),
/// (I25).
struct FaceTurn {
  double slope = 0;    ///< Tangent of the angle, counter-clockwise.
  double pivot_x = 0;  ///< Where the face is as high as the platen, mm.
  double reach = 0;    ///< Largest distance from there along x in the specimen at rest, mm.
  double inertia = 0;  ///< About the hinge, tonne mm2 per mm of thickness; 0: it cannot turn.
  double rate = 0;     ///< Of the slope during the coming step, 1/s.
  double last_rate = 0;
};

/// Two rigid platens below and above the specimen, horizontal or curved, with penalty contact on every node; Eqs. (I5),
/// (I6). Index 0 is the bottom one, 1 the top one.
struct Platens {
  bool present = false;
  std::array<double, 2> y{0, 0};              ///< mm; of a jaw: its apex.
  std::array<double, 2> velocity{0, 0};       ///< mm/s during the coming step.
  std::array<double, 2> last_velocity{0, 0};  ///< mm/s during the last step.
  double friction = 0;                        ///< Coulomb coefficient.
  JawFace jaw;
  FaceTurn upper;
};

/// How a node meets the platens: a spring (N/mm per mm of thickness) that acts beyond a depth (mm).
struct PlatenSpring {
  double stiffness = 0;
  double skin = 0;
};

/// The springs of all nodes: those of the loaded edges' nodes apart, in ascending order, the others' alike.
struct PlatenSprings {
  std::vector<int> nodes;
  std::vector<PlatenSpring> springs;  ///< Of `nodes`.
  PlatenSpring other;
  PlatenSpring at(std::size_t node) const;
};

/// How a block turns against a spring about the middle of its nodes, or each of its parts about its own; Eq. (I26).
struct BlockTurn {
  std::vector<Vec2> arms;  ///< From the middle to each of the block's nodes at rest, mm; empty: it does not turn.
  double stiffness = 0;    ///< N mm per rad and mm of thickness.
  double inertia = 0;      ///< Tonne mm2 per mm of thickness.
  double angle = 0;        ///< Counter-clockwise, rad.
  double rate = 0;         ///< rad/s during the coming step.
  double last_rate = 0;
};

/// A rigid block bonded to some nodes, which move with it; Eqs. (I21)-(I23), (I26).
struct RigidBlock {
  std::vector<int> nodes;     ///< Ascending.
  double mass = 0;            ///< Of its nodes, tonne per mm of thickness, and what the block adds.
  bool free_along_y = false;  ///< It follows the forces along y; its velocity is given otherwise.
  double load = 0;            ///< On a free one, along y, N per mm of thickness.
  Vec2 velocity;              ///< mm/s during the coming step.
  Vec2 last_velocity;         ///< During the last step.
  Vec2 reaction;              ///< Force of the specimen on the block at the last update, N per mm of thickness.
  Vec2 displacement;          ///< mm, since the start.
  BlockTurn turn;
};

/// External forces (N per mm of thickness) on the few nodes that bear any, in ascending order.
struct NodeLoads {
  std::vector<int> nodes;
  std::vector<Vec2> forces;
  std::vector<std::array<int, 2>> places;  ///< Of each loaded edge's two nodes in `nodes`.
  Vec2 at(std::size_t node) const;         ///< 0 where there is none.
};

/// Per node, which forces act on it (compressed rows); only where particles share nodes.
struct NodeGather {
  std::vector<int> begin, index;
};

/// Confining pressure (MPa) on the edges of the present outer surface.
struct FlankPressure {
  std::vector<LoadedEdge> edges;
  double pressure = 0;
  std::vector<ExposedEdge> outline;  ///< All edges of the outline at rest; never changes.
};

/// The energy account, N mm per mm of thickness; Eqs. (I7)-(I12). Every term comes from its own formula.
struct EnergyBalance {
  double external_work = 0;  ///< By platens, pressure, body force and held nodes, and the initial kinetic energy.
  double elastic = 0;        ///< In the particles.
  double recoverable = 0;    ///< In contacts, platens' penalty springs included.
  double fracture = 0;
  double friction = 0;
  double damping = 0;
  double kinetic = 0;
  double plasticity = 0;      ///< Spent on plastic strain of particles that yield, Eq. P7.
  double created_by_law = 0;  ///< Literal law only: what the law itself adds; not part of the balance.
  double sum() const { return elastic + recoverable + fracture + friction + damping + kinetic + plasticity; }
  double error() const { return external_work - sum(); }
  /// Of a specimen so many mm thick, in N mm.
  EnergyBalance times(double thickness) const {
    return {external_work * thickness, elastic * thickness,    recoverable * thickness,
            fracture * thickness,      friction * thickness,   damping * thickness,
            kinetic * thickness,       plasticity * thickness, created_by_law * thickness};
  }
};

/// Sums over nodes gathered in one velocity update.
struct NodeSums {
  std::array<Vec2, 2> on_blocks;           ///< Force of the specimen on the rigid blocks, N per mm of thickness.
  std::array<double, 2> reaction{0, 0};    ///< Force on the bottom and top platen along y, N per mm of thickness, >= 0.
  double turning = 0;                      ///< Moment on the upper platen about its hinge, N mm per mm of thickness.
  double work_before = 0, work_after = 0;  ///< External work of the half steps before and after this instant.
  double damping = 0, platen_friction = 0, platen_energy = 0, kinetic = 0;
  double fastest = 0;  ///< Largest squared speed, mm2/s2.
  NodeSums& operator+=(const NodeSums& other);
};

/// The model and everything its motion needs. Forces are N per mm of thickness.
struct System {
  Particles particles;
  BondedContacts contacts;
  GeneralContacts general;
  Platens platens;
  std::array<DriveLine, 2> lines;  ///< Of the bottom and top platen, or the first of the block that is driven.
  FlankPressure flank;
  Vec2 body_acceleration{0, 0};    ///< mm/s2, e.g. gravity.
  std::vector<std::uint8_t> held;  ///< Nodes that keep their velocity; empty: none.
  std::vector<RigidBlock> blocks;  ///< At most two.
  std::vector<int> block_of;       ///< Block of each node, -1: none; empty: there are no blocks.
  double local_damping = 0;
  double time_step = 0;  ///< s
  double time = 0;       ///< s
  std::int64_t step = 0;
  double initial_kinetic = 0;

  Kernel kernel = Kernel::fast;  ///< Set before prepare().

  PlatenSprings platen_springs;
  std::vector<double> platen_shear;  ///< Tangential platen force on each node along the face; empty: no friction.
  NodeSums sums;                     ///< Of the last velocity update.
  double external_work = 0, damping_energy = 0, platen_friction_energy = 0;  ///< Up to the present instant, see step().

  std::vector<Vec2> forces;  ///< Slots of triangle edges (force_slots.hpp), then corners where triangles write theirs.
  NodeLoads loads;           ///< Flank pressure.
  NodeGather gather;
};

/// Allocates the work arrays. Call once particles, contacts and kernel stand.
void prepare(System& system);

/// Forces at the present positions. Where every triangle has its own nodes, the fast kernel leaves the triangles' share
/// to update_velocities().
void compute_forces(System& system, const ParallelLoops& loops);

/// Velocities half a step ahead: Eqs. (I1)-(I4); fills system.sums. Positions stay.
void update_velocities(System& system, const ParallelLoops& loops);

/// Positions and platens one step ahead, Eq. (I2).
void update_positions(System& system, const ParallelLoops& loops);

/// Net force of triangles and contacts on a node, gathered in fixed order; valid after compute_forces().
Vec2 internal_force(const System& system, std::size_t node);

/// The same from a list of forces laid out as `System::forces` with corners.
inline Vec2 gather_force(const System& system, std::size_t node, std::span<const Vec2> forces) {
  if (!system.particles.separate) {
    Vec2 force;
    const NodeGather& gather = system.gather;
    for (int i = gather.begin[node]; i < gather.begin[node + 1]; ++i) force += forces[gather.index[i]];
    return force;
  }
  const std::size_t first = node - node % 3, k = node % 3;
  const std::vector<int>& slot = system.contacts.slot_of_edge;
  return forces[2 * system.contacts.slot_count() + node] + forces[2 * slot[node]] +
         forces[2 * slot[first + (k + 2) % 3] + 1];
}

/// All energies at the present instant; valid between update_velocities and update_positions.
EnergyBalance energy_balance(const System& system, const ParallelLoops& loops);

/// Elastic energy of all particles, Eq. (I8).
double elastic_energy(const Particles& particles, const ParallelLoops& loops);

/// Counts the kinetic energy of the present velocities as work that entered before the first step.
void book_initial_kinetic_energy(System& system);

}  // namespace asperity
