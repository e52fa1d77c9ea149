#include "core/measurement/results.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.hpp"
#include "core/base/units.hpp"

namespace asperity {
namespace {

/// Least-squares line y = intercept + slope x.
struct Line {
  double slope = 0, intercept = 0;
};

Line fit_line(std::span<const double> x, std::span<const double> y) {
  double mx = 0, my = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mx += x[i];
    my += y[i];
  }
  mx /= static_cast<double>(x.size());
  my /= static_cast<double>(x.size());
  double sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - mx) * (x[i] - mx);
    sxy += (x[i] - mx) * (y[i] - my);
  }
  const double slope = sxy / sxx;
  return {slope, my - slope * mx};
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
  constexpr double kDrop = 0.1;
  double largest = 0.0;
  for (const Sample& s : samples) {
    if (s.axial_strain > strain_limit) break;
    largest = std::max(largest, s.stress_mpa);
    const bool cracked = s.cracks_tension + s.cracks_shear > 0;
    if (cracked && s.stress_mpa < (1.0 - kDrop) * largest) return largest;
  }
  return std::nullopt;
}

std::optional<ElasticResult> fit_moduli(std::span<const Sample> samples, const Peak& peak, const RunConfig& config) {
  const double base = config.experiment.confining_pressure_mpa;
  const double low = base + config.measurement.modulus_window_low * (peak.stress_mpa - base);
  const double high = base + config.measurement.modulus_window_high * (peak.stress_mpa - base);
  std::vector<double> stress, axial, lateral;
  for (std::size_t i = 0; i < peak.index; ++i) {
    const Sample& s = samples[i];
    if (s.stress_mpa < low || s.stress_mpa > high) continue;
    stress.push_back(s.stress_mpa);
    axial.push_back(s.gauge_axial_strain);
    lateral.push_back(s.lateral_strain);
  }
  if (stress.size() < 3) return std::nullopt;
  const double modulus = 1.0 / fit_line(stress, axial).slope;
  const double ratio = fit_line(axial, lateral).slope;
  if (config.experiment.plane == PlaneCondition::stress) return ElasticResult{modulus / units::kMpaPerGpa, ratio};
  const double nu = ratio / (1.0 + ratio);
  return ElasticResult{modulus * (1.0 - nu * nu) / units::kMpaPerGpa, nu};
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
