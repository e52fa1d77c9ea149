#pragma once
#include <functional>

#include "core/experiment/model.hpp"

namespace asperity {

/// What the static path of an elastic start came to.
struct ElasticStart {
  int increments = 0;
  int factorisations = 0;
  int iterations = 0;     ///< Solutions with a factorised stiffness.
  double separation = 0;  ///< Largest normalised separation of a contact point at its end, Eq. (E6).
};

/// Increments of equal rise to the end of the path: rows for the modulus, and steps along the law, whose error falls
/// with their size.
inline constexpr int kElasticIncrements = 20;

/// Closes the platens from the present state through static equilibria until the largest normalised separation reaches
/// `experiment.loading.elastic_start_fraction`, Eqs. (E6)-(E8); `on_equilibrium` is called at each, with reactions and
/// energies of the system up to date, and says whether to go on. At the end the specimen moves with the platens'
/// closing rate along the path's last increment, and that motion's kinetic energy is booked as work. Call between
/// update_positions and compute_forces. Throws a numerical error where no equilibrium is found.
ElasticStart solve_elastic_start(Model& model, const ParallelLoops& loops, const std::function<bool()>& on_equilibrium,
                                 int increments = kElasticIncrements);

}  // namespace asperity
