#pragma once
#include "core/calibration/elastic_estimate.hpp"
#include "core/config/run_config.hpp"

namespace asperity {

/// Which modulus of an assembly counts.
enum class ElasticReading {
  window,  ///< What a test shows between the fractions `measurement.modulus_window` of its peak stress.
  initial  ///< The tangent of the unloaded specimen.
};

/// What the gauges of one specimen read.
struct AssemblyElasticity {
  double youngs_modulus_gpa = 0, poissons_ratio = 0;
  StressWindow window;              ///< Axial stresses the fit went over, MPa; both 0 for the initial reading.
  bool window_reached = true;       ///< False: contacts soften below the window's upper end, so it was cut off.
  double separation = 0;            ///< Largest normalised separation of a contact on the path, E6 of core/experiment.
  double critical_time_step_s = 0;  ///< Of the specimen.
};

/// Axial stresses (MPa) of a uniaxial test between which its moduli are fitted if it fails at `strength`, M4 of
/// core/measurement.
StressWindow modulus_window(const RunConfig& config, double uniaxial_strength_mpa);

/// Reads E and nu of a uniaxial test's specimen off its gauges without stepping in time, Eqs. (K29), (K30). The platens
/// are taken without friction: the gauges lie far from them. `uniaxial_strength_mpa` places the window. Throws a config
/// error for another test or bad values, a numerical error where not even three equilibria are found.
AssemblyElasticity read_assembly(const RunConfig& config, ElasticReading reading, double uniaxial_strength_mpa);

}  // namespace asperity
