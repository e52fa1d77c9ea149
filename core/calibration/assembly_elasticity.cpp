#include "core/calibration/assembly_elasticity.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/units.hpp"
#include "core/experiment/elastic_start.hpp"
#include "core/integrator/static_stiffness.hpp"
#include "core/measurement/results.hpp"

namespace asperity {
namespace {

constexpr double kSmallClosure = 1e-7;     // of the height: the answer is linear and keeps seven digits
constexpr double kBeforeSoftening = 0.99;  // of the separation at which the first contact softens
constexpr int kRows = 100;                 // over the window

struct PathPoint {
  double stress = 0;  ///< MPa
  GaugeReading strain;
};

PathPoint read_point(const Model& model) {
  const PlatenLoad load = platen_load(model.system);
  const double mean = 0.5 * (load.reaction[0] + load.reaction[1]);
  return {mean / model.config.experiment.width_mm, read_gauges(model.gauges, model.system.particles)};
}

ElasticResult corrected(double slope, double ratio, PlaneCondition plane) {
  const Elasticity e = material_elasticity({slope, ratio}, plane);
  return {e.youngs_modulus / units::kMpaPerGpa, e.poissons_ratio};
}

/// Eq. (K29): one solution with every contact at its initial stiffness.
ElasticResult initial_moduli(Model& model, const ParallelLoops& loops) {
  System& system = model.system;
  const double closure = kSmallClosure * model.config.experiment.height_mm;
  system.platens.y[0] += 0.5 * closure;
  system.platens.y[1] -= 0.5 * closure;
  compute_forces(system, loops);
  const PointStiffness initial{system.contacts.law.k_t, system.contacts.law.k_s};
  const StaticStiffness stiffness(system, std::vector<EdgeStiffness>(system.contacts.size(), {initial, initial}));
  const std::vector<Vec2> moved = stiffness.solve(out_of_balance(system));
  for (std::size_t i = 0; i < moved.size(); ++i) system.particles.position[i] += moved[i];
  const PathPoint at = read_point(model);
  return corrected(at.stress / at.strain.axial, at.strain.lateral / at.strain.axial, model.config.experiment.plane);
}

/// Equilibria from no load to the stress, or as far as they go before a contact softens.
std::vector<PathPoint> static_path(Model model, double stress, int increments, double& separation,
                                   const ParallelLoops& loops) {
  std::vector<PathPoint> path{PathPoint{}};
  try {
    const auto go_on = [&] {
      path.push_back(read_point(model));
      return path.back().stress < stress;
    };
    separation = solve_elastic_start(model, loops, go_on, increments).separation;
  } catch (const Error& error) {
    constexpr std::size_t kFewest = 4;  // the unloaded specimen and three rows of fit_moduli
    if (error.kind() != ErrorKind::numerical || path.size() < kFewest) throw;
    separation = kBeforeSoftening;
  }
  return path;
}

GaugeReading strain_at(const std::vector<PathPoint>& path, double stress) {
  const auto after =
      std::find_if(path.begin() + 1, path.end() - 1, [&](const PathPoint& p) { return p.stress > stress; });
  const PathPoint &a = *(after - 1), &b = *after;
  const double t = (stress - a.stress) / (b.stress - a.stress);
  return {std::lerp(a.strain.axial, b.strain.axial, t), std::lerp(a.strain.lateral, b.strain.lateral, t)};
}

/// The strain on a path of endless increments: the error falls with their size, and the coarse path's are twice as
/// large.
double extrapolated(double fine, double coarse) { return 2.0 * fine - coarse; }

/// Rows at equal stresses inside the window, as a test's curves would have them.
std::vector<Sample> rows(const std::vector<PathPoint>& fine, const std::vector<PathPoint>& coarse,
                         StressWindow window) {
  std::vector<Sample> samples(kRows);
  for (int i = 0; i < kRows; ++i) {
    Sample& s = samples[i];
    s.stress_mpa = window.low + (i + 0.5) / kRows * (window.high - window.low);
    const GaugeReading a = strain_at(fine, s.stress_mpa), b = strain_at(coarse, s.stress_mpa);
    s.gauge_axial_strain = extrapolated(a.axial, b.axial);
    s.lateral_strain = extrapolated(a.lateral, b.lateral);
  }
  return samples;
}

/// Eq. (K30). The window is cut where the path ends, and then begins at half that stress at the latest.
void read_window(const Model& model, StressWindow wanted, AssemblyElasticity& found, const ParallelLoops& loops) {
  constexpr int kCoarse = kElasticIncrements / 2;
  double coarse_separation = 0.0;
  const auto fine = static_path(model, wanted.high, kElasticIncrements, found.separation, loops);
  const double reached = fine.back().stress;
  const auto coarse = static_path(model, std::min(reached, wanted.high), kCoarse, coarse_separation, loops);
  found.window_reached = reached >= wanted.high;
  found.window = found.window_reached ? wanted : StressWindow{std::min(wanted.low, 0.5 * reached), reached};
  RunConfig all_rows = model.config;
  all_rows.measurement.modulus_window_low = 0.0;
  all_rows.measurement.modulus_window_high = 1.0;
  const Peak end{static_cast<std::size_t>(kRows), found.window.high};
  const ElasticResult moduli = fit_moduli(rows(fine, coarse, found.window), end, all_rows).value();
  found.youngs_modulus_gpa = moduli.youngs_modulus_gpa;
  found.poissons_ratio = moduli.poissons_ratio;
}

void refuse_other_tests(const RunConfig& config) {
  if (config.experiment.type == ExperimentType::uniaxial) return;
  throw Error(ErrorKind::config, {{"/experiment/type", "has no E and nu to compensate", "", "uniaxial", ""}});
}

}  // namespace

StressWindow modulus_window(const RunConfig& config, double uniaxial_strength_mpa) {
  return {config.measurement.modulus_window_low * uniaxial_strength_mpa,
          config.measurement.modulus_window_high * uniaxial_strength_mpa};
}

AssemblyElasticity read_assembly(const RunConfig& config, ElasticReading reading, double uniaxial_strength_mpa) {
  refuse_other_tests(config);
  RunConfig at_rest = config;
  at_rest.integration = {};  // nothing steps in time
  at_rest.experiment.platens.friction_coefficient = 0.0;
  at_rest.experiment.loading.elastic_start_fraction = kBeforeSoftening;
  const ParallelLoops loops;
  Model model = build_model(at_rest, loops);
  AssemblyElasticity found;
  found.critical_time_step_s = model.critical_time_step;
  if (reading == ElasticReading::window) {
    read_window(model, modulus_window(config, uniaxial_strength_mpa), found, loops);
  } else {
    const ElasticResult moduli = initial_moduli(model, loops);
    found.youngs_modulus_gpa = moduli.youngs_modulus_gpa;
    found.poissons_ratio = moduli.poissons_ratio;
  }
  return found;
}

}  // namespace asperity
