#pragma once
#include <string>
#include <vector>

#include "core/config/run_config.hpp"

namespace asperity {

/// A curve measured in a laboratory, of one specimen, in the quantities of the run's own curves. NaN: not measured.
struct MeasuredCurve {
  std::string name;                ///< For a legend: /output/measured_name, and the specimen where the file names one.
  std::vector<double> abscissa;    ///< Shear displacement, mm; or axial strain, closure over height or diameter.
  std::vector<double> stress_mpa;  ///< Shear stress, axial stress (total), or 2P/(pi D) of a load per mm of thickness.
  std::vector<double> lateral_strain;                 ///< Compression: widening positive.
  std::vector<double> dilation_mm, dilation_rear_mm;  ///< Direct shear.
};

/// The curves of the file /output/measured_curve, one a specimen in the order of the file; none where it is not given.
/// Columns, by experiment; those in brackets may be missing, others are not read:
/// compression `axial_strain, axial_stress_mpa[, lateral_strain]`; disc `platen_displacement_mm, load_n_per_mm`;
/// direct shear `shear_displacement_mm, shear_stress_mpa[, dilation_mm][, dilation_rear_mm]`; all `[specimen]`.
/// Throws Error(config) with everything that is missing, at the file, or the line that is no number.
std::vector<MeasuredCurve> read_measured_curves(const RunConfig& config);

}  // namespace asperity
