#pragma once
#include "core/integrator/system.hpp"

namespace asperity {

/// Critical time step 2 / omega_max (s), Eq. (I13), of the intact model in its reference position: the largest
/// eigenvalue of M^-1 K by power iteration, to a relative change below 1e-5. K has all contacts at their initial
/// stiffness or the fracture surfaces' penalty, the platens' penalty on every node and that of general contact on the
/// outline; viscous contact damping shortens the step further.
double critical_time_step(const System& system, const ParallelLoops& loops);

/// Makes nodes heavier so that none needs a step below time_step / safety_factor by Gershgorin's bound, Eq. (I14).
/// Returns the added mass over the mass before.
double scale_masses(System& system, double time_step, double safety_factor);

}  // namespace asperity
