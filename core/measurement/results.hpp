#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/config/run_config.hpp"
#include "core/measurement/drops.hpp"
#include "core/measurement/sample.hpp"

namespace asperity {

/// Peak of a test: the sample of largest stress up to measurement.peak_strain_limit, Eq. (M3).
struct Peak {
  std::size_t index = 0;
  double stress_mpa = 0, axial_strain = 0, time_s = 0;
  bool at_end = false;  ///< The largest value is the last one inside the limit: no peak was passed.
};

/// Throws a tolerance error for an empty series.
Peak find_peak(std::span<const Sample> samples, double strain_limit);

/// The stress (MPa) from which the curve first fell by a tenth, Eq. (M28), among samples up to a strain: a disc that
/// jaws hold together after it has split may bear more later. Empty where it never did.
std::optional<double> first_drop(std::span<const Sample> samples, double strain_limit);

/// Young's modulus (GPa) and Poisson's ratio over the stress window; Eqs. (M4)-(M6).
struct ElasticResult {
  double youngs_modulus_gpa = 0, poissons_ratio = 0;
};

/// Columns of one length from which moduli are read: axial stress (MPa), gauge strains.
struct ElasticColumns {
  std::span<const double> stress_mpa, axial_strain, lateral_strain;
  double axial_noise = 0;  ///< Standard deviation of a row's axial strain.
};

/// Total axial stresses between which a modulus is read, MPa.
struct StressRange {
  double low_mpa = 0, high_mpa = 0;
};

/// Least-squares slopes over the rows before `end` whose stress lies in the window; Eqs. (M4)-(M6), corrected for the
/// plane condition where there is one (a real specimen has none). Empty where fewer than three rows lie in it.
std::optional<ElasticResult> elastic_slopes(const ElasticColumns& columns, std::size_t end, const StressRange& window,
                                            std::optional<PlaneCondition> plane);

/// The same of a run between the two fractions of the peak (measured from the confining
/// pressure), before the peak; corrected for plane strain. Empty where fewer than three samples lie in the window.
std::optional<ElasticResult> fit_moduli(std::span<const Sample> samples, const Peak& peak, const RunConfig& config);

/// Splitting strength 2 P / (pi D t) in MPa, Eq. (M7); load in N per mm of thickness.
double splitting_stress(double load_n_per_mm, double diameter_mm);

/// Mohr-Coulomb line through peak stresses at several confining pressures, Eqs. (M8), (M9).
struct MohrCoulomb {
  double cohesion_mpa = 0, friction_angle_deg = 0;
  double residual_mpa = 0;  ///< Root mean square of sigma_1 about the line.
};

/// Least squares of sigma_1 over sigma_3; needs two different confining pressures. Throws a config error otherwise, and
/// a tolerance error where the line falls.
MohrCoulomb fit_mohr_coulomb(std::span<const double> confining_mpa, std::span<const double> peak_mpa);

}  // namespace asperity
