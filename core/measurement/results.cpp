#include "core/measurement/results.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.hpp"
#include "core/base/units.hpp"
#include "core/measurement/line_fit.hpp"

namespace asperity {
namespace {

/// Least-squares slope of y over x, freed of the flattening by noise of x; Eq. (F27).
double ratio_without_noise(std::span<const double> x, std::span<const double> y, double noise) {
  const double slope = fit_line(x, y).slope;
  if (noise == 0.0) return slope;
  const auto n = static_cast<double>(x.size());
  double mean = 0.0, square = 0.0;
  for (const double v : x) mean += v / n;
  for (const double v : x) square += (v - mean) * (v - mean);
  const double own = square - (n - 1.0) * noise * noise;
  return own > 0.0 ? slope * square / own : slope;
}

}  // namespace
Peak find_peak(std::span<const Sample> samples, double strain_limit) {
  if (samples.empty()) throw Error(ErrorKind::tolerance, "no sample was recorded, so there is no peak");
  Peak peak;
  std::size_t last = 0;
  for (std::size_t i = 0; i < samples.size() && samples[i].axial_strain <= strain_limit; ++i) {
    last = i;
    if (samples[i].stress_mpa > peak.stress_mpa) {
      peak = {i, samples[i].stress_mpa, samples[i].axial_strain, samples[i].time_s, false};
    }
  }
  peak.at_end = peak.index == last;
  return peak;
}

std::optional<double> first_drop(std::span<const Sample> samples, double strain_limit) {
  std::vector<double> stress, cracks;
  for (const Sample& s : samples) {
    if (s.axial_strain > strain_limit) break;
    stress.push_back(s.stress_mpa);
    cracks.push_back(s.cracks_tension + s.cracks_shear);
  }
  return first_drop(stress, cracks, FirstDropRule{});
}

std::optional<ElasticResult> elastic_slopes(const ElasticColumns& columns, std::size_t end, const StressRange& window,
                                            std::optional<PlaneCondition> plane) {
  const auto rows = window_rows(columns.stress_mpa, end, window.low_mpa, window.high_mpa);
  if (rows.size() < 3) return std::nullopt;
  const std::vector<double> axial = gather(columns.axial_strain, rows);
  const double modulus = 1.0 / fit_line(gather(columns.stress_mpa, rows), axial).slope;
  const double ratio = ratio_without_noise(axial, gather(columns.lateral_strain, rows), columns.axial_noise);
  if (plane != PlaneCondition::strain) return ElasticResult{modulus / units::kMpaPerGpa, ratio};
  const double nu = ratio / (1.0 + ratio);
  return ElasticResult{modulus * (1.0 - nu * nu) / units::kMpaPerGpa, nu};
}

std::optional<ElasticResult> fit_moduli(std::span<const Sample> samples, const Peak& peak, const RunConfig& config) {
  const double base = config.experiment.confining_pressure_mpa;
  const StressRange window{base + config.measurement.modulus_window_low * (peak.stress_mpa - base),
                           base + config.measurement.modulus_window_high * (peak.stress_mpa - base)};
  std::vector<double> stress, axial, lateral;
  double farthest = 0.0;
  for (const Sample& s : samples.first(peak.index)) {
    if (s.closure_mm < farthest) continue;  // a loop of unloading
    farthest = s.closure_mm;
    stress.push_back(s.stress_mpa);
    axial.push_back(s.gauge_axial_strain);
    lateral.push_back(s.lateral_strain);
  }
  return elastic_slopes({stress, axial, lateral}, stress.size(), window, config.experiment.plane);
}

double splitting_stress(double load_n_per_mm, double diameter_mm) {
  return 2.0 * load_n_per_mm / (std::numbers::pi * diameter_mm);
}

MohrCoulomb fit_mohr_coulomb(std::span<const double> confining, std::span<const double> peaks) {
  bool varied = false;
  for (double s3 : confining) varied = varied || s3 != confining.front();
  if (!varied || confining.size() != peaks.size()) {
    throw Error(ErrorKind::config, "a Mohr-Coulomb line needs peak stresses at two confining pressures or more");
  }
  const Line line = fit_line(confining, peaks);
  if (line.slope <= 0.0)
    throw Error(ErrorKind::tolerance, "the peak stress falls with the confining pressure: no Mohr-Coulomb line");
  const double sine = (line.slope - 1.0) / (line.slope + 1.0);
  double square = 0.0;
  for (std::size_t i = 0; i < confining.size(); ++i) {
    const double miss = peaks[i] - line.intercept - line.slope * confining[i];
    square += miss * miss;
  }
  return {line.intercept / (2.0 * std::sqrt(line.slope)), std::asin(sine) / units::kRadPerDeg,
          std::sqrt(square / static_cast<double>(peaks.size()))};
}

}  // namespace asperity
