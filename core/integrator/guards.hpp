#pragma once
#include "core/integrator/system.hpp"

namespace asperity {

/// Throws a numerical error that names step, time, place and likely cause where the state is non-finite, a triangle has
/// turned over, or two broken faces overlap by more than half an edge.
void check_state(const System& system);

/// Throws a numerical error where a general contact is too deep to push back.
void check_overlaps(const System& system);

/// Throws a numerical error where the kinetic energy is not finite or exceeds the work done so far (plus what a literal
/// law created); it names the node that moves with most energy.
void check_energy(const System& system, const EnergyBalance& energy);

/// All three checks of the present state, between two steps or after update_velocities.
void check_all(const System& system, const ParallelLoops& loops);

}  // namespace asperity
