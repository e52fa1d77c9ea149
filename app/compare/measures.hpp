#pragma once
#include <limits>
#include <string>
#include <vector>

#include "app/compare/alignment.hpp"
#include "core/measurement/crack_pattern.hpp"
#include "core/measurement/frame.hpp"
#include "core/measurement/pattern_comparison.hpp"

namespace asperity::app {

/// The cracks of a cracks.csv that had broken by a time (s), as lines at rest; ends at one place are one vertex.
CrackPattern crack_pattern(const CsvData& cracks, double until_s);

/// One pattern in figures. NaN: there is none. Shares 0 to 1; angles from the loading axis y, positive to the right.
struct PatternMeasures {
  static constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

  double time_s = 0, displacement_mm = 0, axial_strain = kNothing, stress_mpa = 0;
  double cracks_tension = 0, cracks_shear = 0, contacts_softening = 0;
  double crack_length_mm = 0, tension_share_of_length = kNothing;
  double mean_orientation_deg = kNothing, orientation_resultant = kNothing;
  double orientation_distance_to_first_deg = kNothing;  ///< Eq. (M41) in core/measurement.
  double main_crack_angle_deg = kNothing;               ///< Of the largest cluster, Eq. (M21).
  double main_crack_share_of_length = kNothing;
  double damage_overlap_same_mesh = kNothing, damage_overlap_on_grid = kNothing;  ///< With the first, Eq. (M43).
  double grid_mm = kNothing;                                                      ///< Of the latter.
  double fragments = 0, largest_fragment_share = 0;
  double external_work_n_mm = 0;
  double elastic_share = 0, fracture_share = 0, friction_share = 0, damping_share = 0, kinetic_share = 0,
         plasticity_share = 0;  ///< Of the external work; elastic: particles and contacts.
  OrientationShares orientation{};
};

/// A pattern, its cracks, and what was measured.
struct MeasuredPattern {
  Frame frame;
  AlignedFrame aligned;
  CrackPattern cracks;
  PatternMeasures measures;
};

/// The patterns of aligned frames, each measured by itself and against the first.
std::vector<MeasuredPattern> measure_patterns(const std::vector<ComparedRun>& runs, const AlignedFrames& aligned);

/// A column of the table: key with unit in the CSV, words and unit for readers.
struct MeasureKind {
  const char* key;
  const char* name;
  const char* unit;
  double PatternMeasures::*value;
};
const std::vector<MeasureKind>& measure_kinds();

}  // namespace asperity::app
