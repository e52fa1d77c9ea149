#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "core/config/run_config.hpp"

namespace asperity {

/// The curve of one specimen, measured or simulated, as plain columns of one length in the order of time. Columns that
/// were not recorded are empty. Stresses compression positive; a triaxial test's are total, its strains zero after the
/// hydrostatic stage.
struct Curve {
  std::vector<double> path;          ///< Axial strain (compression), platen or shear displacement, mm (disc, joint).
  std::vector<double> load;          ///< Axial stress, MPa (compression), load, N/mm (disc), shear stress, MPa (joint).
  std::vector<double> gauge_strain;  ///< Axial strain between two points of the specimen, shortening positive.
  std::vector<double> lateral_strain;     ///< Widening positive.
  std::vector<double> dilation_mm;        ///< Joint: rise of the upper half.
  std::vector<double> dilation_front_mm;  ///< Of its end towards which the lower half moves.
  std::vector<double> dilation_rear_mm;   ///< Of the other.
  std::vector<double> events;             ///< Acoustic events or cracks so far.
};

/// How a curve is to be read: the test it is of, and what its instruments do to it.
struct CurveReading {
  ExperimentType experiment = ExperimentType::uniaxial;
  std::optional<PlaneCondition> plane;  ///< Of a simulation; unset: a real specimen, whose slopes are its moduli.
  bool path_is_gauge = false;           ///< Compression: the path is a gauge's strain, no platens'.
  std::optional<double> diameter_mm;    ///< Of a disc.
  double confining_pressure_mpa = 0.0;  ///< Triaxial.
  double path_limit = std::numeric_limits<double>::infinity();  ///< The peak is sought up to here.
  double modulus_window_low = 0.2;                              ///< Fractions of the peak.
  double modulus_window_high = 0.5;
  double load_noise = 0.0;  ///< Standard deviation over the largest load; 0: rows are taken as they are.
  double path_noise = 0.0;  ///< Standard deviation over the largest path.
};

/// What the load stands at before the test proper: the confining pressure (MPa), else 0.
inline double base_load(const CurveReading& reading) {
  return reading.experiment == ExperimentType::triaxial ? reading.confining_pressure_mpa : 0.0;
}

/// The rows of a curve, columns that are empty staying so.
Curve select_rows(const Curve& curve, const std::vector<std::size_t>& rows);

}  // namespace asperity
