#pragma once
#include <string>
#include <vector>

#include "core/experiment/run.hpp"
#include "core/output/summary.hpp"

namespace asperity {

/// Kinetic over stored energy before the peak, up to which a test counts as quasi-static.
constexpr double kQuasiStaticKineticShare = 0.02;

/// What a test found, for summary.json: results with their units, energies, cracks, and everything a careful reader
/// should be warned of. Costs are filled by the caller.
Summary summarise(const Model& model, const RunState& state);

/// "reached the stop strain", "fell below the stop fraction of the peak", ...
std::string describe(StopReason reason);

/// |external work - sum of energies| / external work.
double relative_closure_error(const EnergyBalance& energy);

}  // namespace asperity
