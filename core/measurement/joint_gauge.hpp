#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/joint_strips.hpp"
#include "core/integrator/system.hpp"

namespace asperity {

/// Teeth that are measured one by one; of a profile with more, these are the first.
inline constexpr std::size_t kMostTeeth = 8;

/// Rise of the upper half, mm.
struct DilationReading {
  double mean = 0;   ///< Of the block.
  double front = 0;  ///< Of the upper half's end towards which the lower half moves...
  double rear = 0;   ///< ...and of the other.
  DilationReading& operator-=(const DilationReading& o);
};

/// One tooth of the lower half, the mean over its strips. Forces are those of the lower half on the upper one, N per mm
/// of thickness.
struct ToothReading {
  Vec2 leading;               ///< On the flank that faces the lower half's motion.
  Vec2 trailing;              ///< On the other flank.
  double attached_share = 1;  ///< Of the tooth's area: what still hangs together with the lower half's body.
  int cracks = 0;             ///< Broken contacts in the tooth, of all strips together.
};

/// What is read off a joint; stress on the plan area by Eq. (M30).
struct JointReading {
  double normal_stress_mpa = 0;  ///< On the plan area.
  DilationReading dilation;
  std::array<ToothReading, kMostTeeth> teeth;
};

/// Where to read, found on the joint at rest; Eqs. (M31)-(M33).
struct JointGauge {
  std::array<std::vector<int>, 2> ends;  ///< Nodes of the upper half's rear and front end.
  std::vector<std::uint8_t> lower;       ///< 1: a triangle of the lower half.
  std::vector<int> flank_of_triangle;    ///< 2 tooth + (1 on the leading side) of the lower half's teeth; -1: none.
  std::vector<double> tooth_area_mm2;    ///< Of all strips together.
  JointStrips strips;
  std::vector<int> bodies;  ///< A triangle of each strip's lower half's body.
};

/// `lower` has 1 for every triangle of a lower half.
JointGauge make_joint_gauge(const Particles& particles, const JointProfile& profile, const JointStrips& strips,
                            std::vector<std::uint8_t> lower);

DilationReading read_dilation(const JointGauge& gauge, const System& system);

/// Dilation and teeth at the present instant; the stress is left to the caller. Valid after compute_forces().
JointReading read_joint(const JointGauge& gauge, const System& system);

}  // namespace asperity
