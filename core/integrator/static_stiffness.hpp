#pragma once
#include <memory>
#include <vector>

#include "core/integrator/linear_elements.hpp"
#include "core/integrator/system.hpp"

namespace asperity {

/// Whether each node is pressed by a platen (1 or 0) at the present positions.
std::vector<std::uint8_t> nodes_on_platens(const System& system);

/// Out-of-balance force on every node, N per mm of thickness: triangles, contacts, flank pressure and frictionless
/// platens; valid after compute_forces.
std::vector<Vec2> out_of_balance(const System& system);

/// Reaction of each platen (N per mm of thickness, >= 0) and the energy in the platens' springs (N mm per mm).
struct PlatenLoad {
  std::array<double, 2> reaction{0, 0};
  double energy = 0;
};

PlatenLoad platen_load(const System& system);

/// Stiffness of the contact points of an edge in the next increment.
using EdgeStiffness = std::array<PointStiffness, 2>;

/// The assembly's stiffness about its present state, factorised for static solutions; Eq. (I18). It has the particles'
/// linear elasticity, the given stiffness of every contact edge and the springs of the nodes that a platen presses.
class StaticStiffness {
 public:
  /// O(n^1.5) for n nodes. Throws a numerical error where the matrix cannot be factorised.
  StaticStiffness(const System& system, const std::vector<EdgeStiffness>& contacts);
  ~StaticStiffness();

  /// Displacements (mm) under forces on the nodes, N per mm of thickness. Motion that nothing resists, a frictionless
  /// specimen's along the platens, stays bounded.
  std::vector<Vec2> solve(const std::vector<Vec2>& force) const;

  /// The nodes whose platen springs it has.
  const std::vector<std::uint8_t>& on_platens() const { return on_platens_; }

 private:
  struct Factor;
  std::vector<std::uint8_t> on_platens_;
  std::unique_ptr<Factor> factor_;
};

}  // namespace asperity
