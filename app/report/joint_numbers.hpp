#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/report/document.hpp"
#include "core/config/run_config.hpp"
#include "core/contact/joint_strength.hpp"
#include "core/output/csv.hpp"

namespace asperity::app {

/// One tooth, from summary.json; stresses are shares of the joint's shear stress on the plan area.
struct ToothNumbers {
  double angle_deg = 0, base_mm = 0;
  std::optional<double> sheared_off_mm;
  double leading_at_peak_mpa = 0;
  double most_mpa = 0, most_at_mm = 0;  ///< Eq. (E16)
  double share_with_first = 0;          ///< Eq. (E17)
  double attached_at_end = 1;
};

/// Broken contacts up to a moment; lengths in mm at rest, heights over the joint's plane weighted by length.
struct BrokenNumbers {
  double length_mm = 0, tension_share = 0;
  double mean_height_mm = 0, height_sd_mm = 0;
};

/// What the sentences about a direct shear test are made of, all of it from the run's folder. Displacements mm.
struct JointNumbers {
  double normal_mpa = 0, length_mm = 0, edge_mm = 0;
  std::optional<double> shear_fracture_energy_n_per_mm;
  double peak_mpa = 0, peak_mm = 0, residual_mpa = 0, end_mm = 0;
  double dilation_rate = 0;  ///< Before the peak, Eq. (E14).
  double normal_at_peak_mpa = 0;
  double leading_share_at_peak = 0;  ///< Of the shear stress: what the teeth's leading flanks bear.
  int softening_at_peak = 0;
  BrokenNumbers at_peak, at_end;
  double last_quarter_slope = 0;  ///< Rise of the upper half over displacement.
  int last_quarter_cracks = 0;
  std::string teeth_failed;          ///< Eq. (E17)
  std::optional<std::size_t> first;  ///< Tooth that failed first.
  std::vector<ToothNumbers> teeth;
  ToothedJoint joint;
  JointStrength forms;
};

/// Nothing where the material's cohesion and friction angle, or the results, are missing.
std::optional<JointNumbers> joint_numbers(const RunConfig& config, const Value& summary, const CsvData& curves,
                                          const CsvData& cracks);

}  // namespace asperity::app
