#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/units.hpp"
#include "core/experiment/model.hpp"
#include "core/experiment/run.hpp"
#include "core/integrator/platen_contact.hpp"
#include "core/measurement/disc_gauge.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;

RunConfig between_jaws() {
  RunConfig config = test::plaster();
  config.experiment.platens.shape = PlatenShape::curved;
  config.experiment.loading.ramp_time_s = 1e-3;
  return config;
}

/// Strengths that no load here comes near.
RunConfig elastic_disc(std::uint64_t seed) {
  RunConfig config = between_jaws();
  config.particles.seed = seed;
  config.contacts.tensile_strength_mpa = config.contacts.cohesion_mpa = 1e12;
  config.contacts.fracture_energy_n_per_mm = 1e25;
  config.experiment.loading.closing_rate_mm_per_s = 80;
  config.experiment.stop.axial_strain = 0.012;
  config.measurement.samples = 60;
  return config;
}

/// What Hondros (1959) gives for the tension at the centre over 2P/(pi D t), the load spread evenly over 2 alpha.
double hondros(double alpha) { return std::sin(2.0 * alpha) / alpha - 1.0; }

/// The same for point loads along the normals that the jaws now press with, by superposition of the diametral pairs'
/// stresses, 1 across and -3 along each, over the load along y.
double superposed(const System& system) {
  double tension = 0.0, load = 0.0;
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    const PlatenContact c = platen_contact(system, i);
    if (c.overlap <= 0.0) continue;
    const Vec2 arm = system.particles.position[i] - Vec2{0.0, 27.0};
    const double force = c.spring.stiffness * c.overlap, sine = arm.x / norm(arm);
    tension += force * (1.0 - 4.0 * sine * sine);
    load += force * std::abs(c.touch.normal.y);
  }
  return tension / load;
}

/// Sideways force of each jaw over the load.
std::array<double, 2> sideways(const System& system) {
  std::array<double, 2> force{0, 0};
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    const PlatenContact c = platen_contact(system, i);
    if (c.overlap > 0.0) force[c.side] += c.spring.stiffness * c.overlap * c.touch.normal.x;
  }
  for (int side = 0; side < 2; ++side) force[side] /= system.sums.reaction[side];
  return force;
}

struct ElasticRun {
  Model model;
  RunState state;

  explicit ElasticRun(std::uint64_t seed) : model(build_model(elastic_disc(seed), kLoops)) {
    state = start_run(model);
    run_experiment(model, state, kLoops, {});
  }
};

}  // namespace

TEST_CASE("An elastic disc between jaws: account, contact, centre stress and side force") {
  double ratio = 0.0, ratio_of_forces = 0.0, closure_error = 0.0, aside = 0.0;
  constexpr int kMeshes = 4;
  for (std::uint64_t seed = 1; seed <= kMeshes; ++seed) {
    const ElasticRun run(seed);
    const std::vector<Sample>& samples = run.state.samples;
    double angle = 0.0;
    for (const Sample& s : samples) {
      if (s.energy.external_work <= 0.0) continue;
      closure_error = std::max(closure_error, std::abs(s.energy.error() / samples.back().energy.external_work));
      if (s.axial_strain < 0.002) continue;
      CHECK(s.disc.contact_half_angle_deg >= angle);
      angle = s.disc.contact_half_angle_deg;
    }
    const Sample& end = samples.back();
    CHECK(end.cracks_tension + end.cracks_shear == 0);
    CHECK(end.disc.contact_half_angle_deg > 1.5 * samples[samples.size() / 4].disc.contact_half_angle_deg);
    // The gauge's mean over a radius of 0.1 D is 0.96 of the centre's tension; core/measurement, M14.
    const double found = end.disc.centre_tension_mpa / end.stress_mpa / 0.96;
    const double alpha = end.disc.contact_half_angle_deg * units::kRadPerDeg;
    WARN("elastic disc between jaws, seed " << seed << ": contact half angle " << end.disc.contact_half_angle_deg
                                            << " deg, centre tension over 2P/(pi D t) " << found << ", Hondros "
                                            << hondros(alpha) << ", by the forces themselves "
                                            << superposed(run.model.system));
    ratio += found / hondros(alpha) / kMeshes;
    ratio_of_forces += found / superposed(run.model.system) / kMeshes;
    for (const double force : sideways(run.model.system)) aside = std::max(aside, std::abs(force));
  }
  WARN("centre tension over Hondros " << ratio << ", over the forces' own " << ratio_of_forces << "; account open by "
                                      << closure_error << " of the work, side force " << aside << " of the load");
  CHECK(closure_error < 1e-3);
  CHECK(ratio == Approx(1.0).epsilon(0.05));
  CHECK(ratio_of_forces == Approx(1.0).epsilon(0.03));
  CHECK(aside < 0.02);
}

TEST_CASE("The account of a disc crushed between jaws closes, smooth or rough") {
  RunConfig config = between_jaws();
  config.particles.edge_mm = 5.0;
  config.particles.edge_deviation_mm = 0.5;
  config.contacts.cohesion_mpa = 2.0;
  config.experiment.platens.friction_coefficient = GENERATE(0.0, 0.3);
  config.experiment.stop.axial_strain = 0.06;
  Model model = build_model(config, kLoops);
  RunState state = start_run(model);
  run_experiment(model, state, kLoops, {});
  const Sample& end = state.samples.back();
  WARN("coarse disc between jaws, friction "
       << config.experiment.platens.friction_coefficient << ": cracks " << end.cracks_tension << " + "
       << end.cracks_shear << ", closure error over work " << end.energy.error() / end.energy.external_work);
  CHECK(end.cracks_tension + end.cracks_shear > 5);
  CHECK(std::abs(end.energy.error()) < 1e-3 * end.energy.external_work);
  CHECK(std::abs(end.reaction_bottom_n / end.reaction_top_n - 1.0) < 0.05);
}

TEST_CASE("Between jaws the static path is that of slow loading") {
  RunConfig config = between_jaws();
  config.particles.edge_mm = 5.0;
  config.particles.edge_deviation_mm = 0.6;
  config.experiment.loading.closing_rate_mm_per_s = 40;
  config.experiment.loading.ramp_time_s = 0.0;
  config.experiment.loading.elastic_start_fraction = 0.3;
  config.experiment.stop.axial_strain = 0.006;
  config.measurement.samples = 1000;
  const auto run = [&] {
    Model model = build_model(config, kLoops);
    RunState state = start_run(model);
    run_experiment(model, state, kLoops, {});
    return state;
  };
  const RunState direct = run();
  config.experiment.loading.elastic_start_fraction = 0.0;
  const RunState stepped = run();
  const double end = direct.loading.elastic_start_closure_mm;
  REQUIRE(end > 0.0);
  REQUIRE(end < stepped.samples.back().closure_mm);
  const auto at = [&](const RunState& state) {
    return std::find_if(state.samples.begin(), state.samples.end(),
                        [&](const Sample& s) { return s.closure_mm >= end; });
  };
  WARN("between jaws, static against stepped at " << end << " mm: " << at(direct)->stress_mpa << ", "
                                                  << at(stepped)->stress_mpa);
  CHECK(at(direct)->stress_mpa == Approx(at(stepped)->stress_mpa).epsilon(0.01));
  for (const Sample& s : direct.samples) {
    if (s.energy.external_work > 0.0) CHECK(std::abs(s.energy.error()) < 2e-4 * s.energy.external_work);
  }
}
