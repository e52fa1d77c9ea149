#pragma once
#include <span>
#include <vector>

#include "core/config/run_config.hpp"
#include "core/measurement/crack_network.hpp"

namespace asperity {

/// A group of cracks near in space and time: a row of events.csv. After Hazzard & Young (2000).
struct AcousticEvent {
  double time_s = 0;  ///< Of its first crack.
  double duration_s = 0;
  Vec2 place;  ///< Mean of its cracks' places, weighted by length; mm.
  int cracks = 0, tension = 0, shear = 0;
  double energy_n_mm = 0;  ///< Fracture energy of its cracks, per mm of thickness.
};

/// Joins cracks closer than three edge lengths and, in time, than a shear wave needs for three edge lengths, Eq. (M11);
/// ordered by time. `cracks` must be ordered by time.
std::vector<AcousticEvent> group_events(std::span<const Crack> cracks, const RunConfig& config);

}  // namespace asperity
