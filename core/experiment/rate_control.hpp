#pragma once
#include "core/experiment/model.hpp"

namespace asperity {

/// Where the closing rate of a controlled test stands; plain data, part of the checkpoint.
struct RateControlState {
  double rate = 0;         ///< Closing rate, mm/s.
  double growth = 0;       ///< Its relative growth, 1/s, until the next look.
  double ratio = 0;        ///< Kinetic over strain energy at the last look.
  int separated = 0;       ///< Most contact points near softening, or past it, at any look.
  double crack_time = -1;  ///< s, the last look that found more of them; -1: none.
};

/// Steps between two looks at the kinetic energy.
inline constexpr std::int64_t kRateInterval = 50;

/// Time (s) in which a pressure wave in the particles' material, with its added mass, passes the specimen's height.
double transit_time(const Model& model);

/// Kinetic energy of the motion that strains or breaks the specimen, N mm per mm of thickness: in compression relative
/// to the linear velocity field that joins the platens, Eq. (E4); the whole in a disc.
double relative_kinetic_energy(const Model& model, const ParallelLoops& loops);

/// Looks at the kinetic energy and the cracks and chooses how the rate goes on, Eq. (E5). Call between
/// update_velocities and update_positions every kRateInterval steps.
void choose_growth(const Model& model, RateControlState& state, const ParallelLoops& loops);

/// Carries the rate on by one time step, within its two ends. Returns it, mm/s.
double advance_rate(const Model& model, RateControlState& state);

}  // namespace asperity
