#pragma once
#include "core/confrontation/measured_data.hpp"

namespace asperity {

/// Keeps tests back where the user leaves the split open, by what kind of test each is and never by a value: of the
/// distinct confining pressures of compression (uniaxial: 0) and of the normal stresses of joints every third, but
/// neither the lowest nor the highest, as long as twice as many tests stay fitted as are kept back.
void propose_split(MeasuredData& data);

}  // namespace asperity
