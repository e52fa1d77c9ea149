#include "core/measurement/results.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/error.hpp"

using namespace asperity;

namespace {

// The fits sum some hundred terms of order one: what is left of exact data is their rounding.
constexpr double kRounding = 1e-11;

Sample point(double strain, double stress) {
  Sample s;
  s.axial_strain = strain;
  s.gauge_axial_strain = strain;
  s.stress_mpa = stress;
  s.time_s = 10.0 * strain;
  return s;
}

std::vector<Sample> points(const std::vector<double>& stresses) {
  std::vector<Sample> samples;
  for (double stress : stresses) samples.push_back(point(0.001 * static_cast<double>(samples.size()), stress));
  return samples;
}

/// A material's response to axial stress: what its gauges show per MPa.
struct Gauge {
  double axial, lateral;
};

/// Linear from 0.25 to 0.45 of the peak, bent away from it outside, and falling with another slope behind the peak.
/// Stress counts from the confining pressure, as strain does.
std::vector<Sample> bent_curve(double confining, double peak, Gauge gauge) {
  std::vector<Sample> samples;
  for (int i = 0; i <= 200; ++i) {
    const double f = i <= 150 ? i / 150.0 : 1.0 - (i - 150) / 60.0;
    const double inside = std::clamp(f, 0.25, 0.45);
    const double bend = i <= 150 ? 3.0 * (f - inside) * (f - inside) : 10.0;
    Sample s = point(1e-4 * i, confining + f * peak);
    s.gauge_axial_strain = f * peak * gauge.axial + bend;
    s.lateral_strain = f * peak * gauge.lateral - bend;
    samples.push_back(s);
  }
  return samples;
}

RunConfig window_config(PlaneCondition plane, double confining) {
  RunConfig config;
  config.experiment.type = ExperimentType::uniaxial;
  config.experiment.plane = plane;
  config.experiment.confining_pressure_mpa = confining;
  config.measurement.modulus_window_low = 0.25;
  config.measurement.modulus_window_high = 0.45;
  return config;
}

ElasticResult moduli(const RunConfig& config, Gauge gauge) {
  const std::vector<Sample> samples = bent_curve(config.experiment.confining_pressure_mpa, 8.0, gauge);
  return fit_moduli(samples, find_peak(samples, 1.0), config).value();
}

/// sigma_1 at failure of a material with cohesion c and friction angle phi (deg).
double mohr_coulomb(double c, double phi_deg, double s3) {
  const double t = std::tan(std::numbers::pi / 4 + phi_deg * std::numbers::pi / 360);
  return 2 * c * t + t * t * s3;
}

}  // namespace

TEST_CASE("the peak is the largest stress up to the strain limit") {
  const std::vector<Sample> samples = points({0, 2, 5, 3, 4, 9});
  const Peak peak = find_peak(samples, 0.0045);
  CHECK(peak.index == 2);
  CHECK(peak.stress_mpa == 5);
  CHECK(peak.axial_strain == 0.002);
  CHECK(peak.time_s == 0.02);
  CHECK_FALSE(peak.at_end);
  CHECK(find_peak(samples, 1.0).index == 5);
}

TEST_CASE("of equal peaks the first one counts") { CHECK(find_peak(points({0, 5, 1, 5, 0}), 1.0).index == 1); }

TEST_CASE("a peak at the end of the range searched is flagged") {
  CHECK(find_peak(points({0, 1, 2, 3}), 1.0).at_end);
  CHECK(find_peak(points({0, 1, 2, 3, 1}), 0.0035).at_end);
  CHECK_FALSE(find_peak(points({0, 1, 2, 3, 1}), 1.0).at_end);
}

TEST_CASE("no sample, no peak") { CHECK_THROWS_AS(find_peak({}, 1.0), Error); }

TEST_CASE("moduli in plane stress are the slopes themselves") {
  const ElasticResult r = moduli(window_config(PlaneCondition::stress, 0.0), {1.0 / 1300, 0.2 / 1300});
  CHECK(r.youngs_modulus_gpa == Approx(1.3).epsilon(kRounding));
  CHECK(r.poissons_ratio == Approx(0.2).epsilon(kRounding));
}

TEST_CASE("moduli in plane strain are those of the material") {
  // Hooke's law with no strain out of the plane: shortening (1 - nu^2) / E, widening nu (1 + nu) / E per MPa.
  constexpr double kE = 1300, kNu = 0.2;
  const ElasticResult r =
      moduli(window_config(PlaneCondition::strain, 0.0), {(1 - kNu * kNu) / kE, kNu * (1 + kNu) / kE});
  CHECK(r.youngs_modulus_gpa == Approx(1.3).epsilon(kRounding));
  CHECK(r.poissons_ratio == Approx(0.2).epsilon(kRounding));
}

TEST_CASE("the window of the moduli counts from the confining pressure") {
  const ElasticResult r = moduli(window_config(PlaneCondition::stress, 6.0), {1.0 / 1300, 0.2 / 1300});
  CHECK(r.youngs_modulus_gpa == Approx(1.3).epsilon(kRounding));
}

TEST_CASE("fewer than three samples in the window give no moduli") {
  const RunConfig config = window_config(PlaneCondition::stress, 0.0);
  const auto fit = [&](const std::vector<Sample>& samples) {
    return fit_moduli(samples, find_peak(samples, 1.0), config);
  };
  CHECK_FALSE(fit(points({0, 3, 4, 10, 1})).has_value());
  CHECK(fit(points({0, 3, 3.5, 4, 10, 1})).has_value());
}

TEST_CASE("exact Mohr-Coulomb data give their cohesion and friction angle") {
  const std::vector<double> confining{0, 0.5, 1.0, 5.0};
  for (double c : {0.0, 0.1, 1.75, 20.0}) {
    for (double phi : {0.0, 10.0, 40.0, 60.0}) {
      std::vector<double> peaks;
      for (double s3 : confining) peaks.push_back(mohr_coulomb(c, phi, s3));
      const MohrCoulomb fit = fit_mohr_coulomb(confining, peaks);
      CHECK(fit.cohesion_mpa == Approx(c).margin(kRounding * 20.0));
      CHECK(fit.friction_angle_deg == Approx(phi).margin(kRounding * 60.0));
      CHECK(fit.residual_mpa == Approx(0.0).margin(kRounding * 100.0));
    }
  }
}

TEST_CASE("an outlier in the middle lifts the Mohr-Coulomb line by a third of itself and shows in the residual") {
  const std::vector<double> confining{0, 0.5, 1.0};
  std::vector<double> peaks;
  for (double s3 : confining) peaks.push_back(mohr_coulomb(1.75, 40, s3));
  const double before = peaks[0];
  peaks[1] += 0.3;
  const MohrCoulomb fit = fit_mohr_coulomb(confining, peaks);
  CHECK(fit.friction_angle_deg == Approx(40).epsilon(kRounding));
  CHECK(fit.cohesion_mpa == Approx(1.75 * (before + 0.1) / before).epsilon(kRounding));
  CHECK(fit.residual_mpa == Approx(std::sqrt((0.01 + 0.04 + 0.01) / 3)).epsilon(kRounding));
}

TEST_CASE("one confining pressure makes no Mohr-Coulomb line") {
  const std::vector<double> one{0.5}, same{0.5, 0.5}, two{0.0, 1.0}, peaks{7, 8};
  CHECK_THROWS_AS(fit_mohr_coulomb(one, one), Error);
  CHECK_THROWS_AS(fit_mohr_coulomb(same, peaks), Error);
  CHECK_THROWS_AS(fit_mohr_coulomb(two, one), Error);
  CHECK_THROWS_AS(fit_mohr_coulomb({}, {}), Error);
}

TEST_CASE("the first drop is by a tenth, with a crack, and not the largest stress of all") {
  std::vector<Sample> samples = points({1, 2, 1.7, 3, 2.8, 2.6, 5, 6});
  CHECK_FALSE(first_drop(samples, 1.0).has_value());  // nothing has broken
  for (std::size_t i = 3; i < samples.size(); ++i) samples[i].cracks_tension = 1;
  CHECK(first_drop(samples, 1.0) == 3.0);  // at 2.6: 2.8 is within a tenth
  CHECK_FALSE(first_drop(samples, 0.0045).has_value());
}

TEST_CASE("the splitting stress is 2P / (pi D t)") {
  CHECK(splitting_stress(135.71680263507907, 54.0) == Approx(1.6).epsilon(1e-14));  // 1.6 * 27 pi by hand
}
