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

/// Makes nodes heavier until the specimen's critical time step (s) is the given one to 0.1 %, each node needing the
/// same step by Gershgorin's bound or none so short; Eq. (I19). Returns the added mass over the mass before. Throws a
/// numerical error where the step lies below that of the unscaled specimen.
double scale_masses_uniformly(System& system, double critical_step, const ParallelLoops& loops);

}  // namespace asperity
