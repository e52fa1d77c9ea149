#include "app/report/joint_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "core/experiment/joint_results.hpp"
#include "core/geometry/joint_profile.hpp"

namespace asperity::app {
namespace {

std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

std::vector<ToothNumbers> teeth_of(const Value& failure) {
  std::vector<ToothNumbers> teeth;
  for (const Value& t : failure["teeth"].items()) {
    teeth.push_back({t["angle_deg"].number(), t["end_mm"].number() - t["begin_mm"].number(),
                     if_finite(t["sheared_off_at_mm"].number()), t["leading_flank_at_peak"]["shear_mpa"].number(),
                     t["leading_flank_most_mpa"].number(), t["leading_flank_most_at_mm"].number(),
                     t["share_of_most_with_first"].number(), t["attached_share_at_end"].number()});
  }
  return teeth;
}

/// Cracks are ordered by time.
BrokenNumbers broken_until(const CsvData& cracks, double time_s) {
  const std::vector<double> times = cracks.numbers("time_s"), lengths = cracks.numbers("length_mm");
  const std::vector<double> heights = cracks.numbers("y_mm");
  const std::vector<std::string> modes = cracks.words("mode");
  BrokenNumbers b;
  double tension = 0, moment = 0, second = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] > time_s) continue;
    b.length_mm += lengths[i];
    if (modes[i] == "tension") tension += lengths[i];
    moment += lengths[i] * heights[i];
    second += lengths[i] * heights[i] * heights[i];
  }
  if (b.length_mm == 0) return b;
  b.tension_share = tension / b.length_mm;
  b.mean_height_mm = moment / b.length_mm;
  b.height_sd_mm = std::sqrt(std::max(0.0, second / b.length_mm - b.mean_height_mm * b.mean_height_mm));
  return b;
}

std::size_t row_at(const std::vector<double>& displacements, double value) {
  const auto found = std::lower_bound(displacements.begin(), displacements.end(), value);
  return std::min(static_cast<std::size_t>(found - displacements.begin()), displacements.size() - 1);
}

void add_at_peak(JointNumbers& n, const CsvData& curves, const CsvData& cracks) {
  const std::size_t row = row_at(curves.numbers("shear_displacement_mm"), n.peak_mm);
  n.normal_at_peak_mpa = curves.numbers("normal_stress_mpa")[row];
  n.softening_at_peak = static_cast<int>(curves.numbers("contacts_softening")[row]);
  n.at_peak = broken_until(cracks, curves.numbers("time_s")[row]);
  n.at_end = broken_until(cracks, curves.numbers("time_s").back());
  double leading = 0;
  for (const ToothNumbers& t : n.teeth) leading += t.leading_at_peak_mpa;
  n.leading_share_at_peak = leading / n.peak_mpa;
}

void add_last_quarter(JointNumbers& n, const CsvData& curves) {
  const std::vector<double> u = curves.numbers("shear_displacement_mm"), v = curves.numbers("dilation_mm");
  const std::vector<double> tension = curves.numbers("cracks_tension"), shear = curves.numbers("cracks_shear");
  const std::size_t row = row_at(u, 0.75 * u.back());
  if (u.back() > u[row]) n.last_quarter_slope = (v.back() - v[row]) / (u.back() - u[row]);
  n.last_quarter_cracks = static_cast<int>(tension.back() + shear.back() - tension[row] - shear[row]);
}

}  // namespace

std::optional<JointNumbers> joint_numbers(const RunConfig& config, const Value& summary, const CsvData& curves,
                                          const CsvData& cracks) {
  const std::optional<ToothedJoint> joint = toothed_joint(config, joint_profile(config.joint));
  const Value results = summary["results"], failure = summary["failure_mode"];
  const double peak = results["peak_shear_stress_mpa"].number();
  if (!joint || !std::isfinite(peak) || peak <= 0 || curves.rows() == 0) return std::nullopt;
  JointNumbers n;
  n.normal_mpa = config.experiment.normal_stress_mpa;
  n.length_mm = joint->length_mm;
  n.edge_mm = config.particles.edge_mm;
  n.shear_fracture_energy_n_per_mm = config.contacts.shear_fracture_energy_n_per_mm;
  n.peak_mpa = peak;
  n.peak_mm = results["peak_shear_displacement_mm"].number();
  n.residual_mpa = results["residual_shear_stress_mpa"].number();
  n.end_mm = results["end_shear_displacement_mm"].number();
  n.dilation_rate = results["dilation_rate_before_peak"].number();
  n.teeth_failed = failure["teeth_failed"].text();
  const int first = failure["first_tooth_to_fail"].count();
  if (first > 0) n.first = static_cast<std::size_t>(first - 1);
  n.teeth = teeth_of(failure);
  n.joint = *joint;
  n.forms = joint_strength(*joint, n.normal_mpa);
  add_at_peak(n, curves, cracks);
  add_last_quarter(n, curves);
  return n;
}

}  // namespace asperity::app
