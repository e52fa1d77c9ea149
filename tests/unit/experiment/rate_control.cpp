#include "core/experiment/rate_control.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/experiment/small_models.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

const ParallelLoops kLoops;

RunConfig controlled(ExperimentType type) {
  RunConfig c = small_config(type);
  c.experiment.loading.closing_rate_mm_per_s = 80;
  c.experiment.loading.rate_control.enabled = true;
  c.experiment.stop.axial_strain = 0.035;
  c.measurement.peak_strain_limit = 0.035;
  return c;
}

/// One look of the controller.
struct Look {
  double closure = 0, rate = 0, growth = 0, ratio = 0;
  bool crack = false;  ///< More contact points near softening than ever before.
};

std::vector<Look> looks_of(const RunConfig& config) {
  Model model = small_model(config);
  RunState state = start_run(model);
  std::vector<Look> looks;
  int separated = 0;
  RunObserver observer;
  observer.interrupted = [&] {
    if ((model.system.step - 1) % kRateInterval != 0) return false;
    const RateControlState& s = state.loading.rate_control;
    looks.push_back({closure(model, state.loading), s.rate, s.growth, s.ratio, s.separated > separated});
    separated = s.separated;
    return false;
  };
  run_experiment(model, state, kLoops, observer);
  return looks;
}

}  // namespace

TEST_CASE("the linear velocity field has no relative kinetic energy, and a jolt counts whole") {
  Model model = small_model(controlled(ExperimentType::uniaxial));
  start_loading(model);
  CHECK(relative_kinetic_energy(model, kLoops) < 1e-24);
  model.system.particles.velocity[7].x += 3.0;
  CHECK(relative_kinetic_energy(model, kLoops) == Approx(4.5 * model.system.particles.mass[7]));
}

TEST_CASE("a wave of the particles' material passes the specimen in a transit, later where it was made heavier") {
  Model model = small_model(controlled(ExperimentType::uniaxial));
  const double modulus = 1300.0 / (1.0 - 0.2 * 0.2);  // plane strain
  CHECK(transit_time(model) == Approx(65.0 / std::sqrt(modulus / 1.2e-9)));
  const double before = transit_time(model);
  model.added_mass_fraction = 3.0;
  CHECK(transit_time(model) == Approx(2.0 * before));
}

TEST_CASE("the rate rises while little moves, holds the bound, and falls to the closing rate where cracks run") {
  RunConfig config = controlled(ExperimentType::uniaxial);
  config.experiment.loading.rate_control.fastest_rate_factor = 16.0;
  const double bound = config.experiment.loading.rate_control.kinetic_ratio_bound = 2e-4;
  const std::vector<Look> looks = looks_of(config);
  const Model model = small_model(config);
  const double interval = kRateInterval * model.system.time_step / transit_time(model);
  const auto first_crack = std::find_if(looks.begin(), looks.end(), [](const Look& l) { return l.crack; });
  REQUIRE(first_crack != looks.end());
  REQUIRE(first_crack - looks.begin() > 50);
  double fastest = 0.0, largest_ratio = 0.0;
  for (auto look = looks.begin(); look != first_crack; ++look) {
    fastest = std::max(fastest, look->rate);
    if (look->closure > 0.002 * 65) largest_ratio = std::max(largest_ratio, look->ratio);
  }
  CHECK(fastest > 4.0 * 80.0);
  CHECK(largest_ratio > 0.1 * bound);  // it is used, not only kept
  CHECK(largest_ratio < bound);
  for (std::size_t i = 1; i < looks.size(); ++i) {
    if (looks[i].crack && looks[i].rate > 80.0 * 1.001) CHECK(looks[i].growth < 0.0);
    // No jump: e^2 down and e^(1/4) up a transit at most.
    const double change = std::log(looks[i].rate / looks[i - 1].rate);
    REQUIRE(change <= 0.25 * interval * 1.001);
    REQUIRE(change >= -2.0 * interval * 1.001);
  }
  const auto slow =
      std::min_element(first_crack, looks.end(), [](const Look& a, const Look& b) { return a.rate < b.rate; });
  CHECK(slow->rate <= 80.0 * 1.01);
  CHECK(slow->rate >= 0.25 * 80.0);
}

TEST_CASE("a bound that the closing rate itself breaks makes the test slower than asked") {
  RunConfig config = controlled(ExperimentType::uniaxial);
  config.experiment.stop.axial_strain = 0.004;
  config.experiment.loading.rate_control.kinetic_ratio_bound = 1e-8;
  CHECK(looks_of(config).back().rate < 0.5 * 80.0);
}

TEST_CASE("a controlled run's rows stand at equal closures") {
  RunConfig config = controlled(ExperimentType::uniaxial);
  config.experiment.stop.axial_strain = 0.01;
  Model model = small_model(config);
  RunState state = start_run(model);
  run_experiment(model, state, kLoops, {});
  CHECK(std::abs(static_cast<int>(state.samples.size()) - 101) <= 1);
  const double step = 8.0 * 80.0 * model.system.time_step;
  for (std::size_t i = 1; i < state.samples.size(); ++i) {
    CHECK(state.samples[i].closure_mm - state.samples[i - 1].closure_mm == Approx(0.0065).margin(step));
  }
}

TEST_CASE("a controlled peak agrees with that of slow loading") {
  RunConfig config = controlled(ExperimentType::uniaxial);
  config.experiment.stop.fraction_of_peak = 0.8;
  const auto peak_of = [](const RunConfig& c) {
    Model model = small_model(c);
    RunState state = start_run(model);
    run_experiment(model, state, kLoops, {});
    double peak = 0.0;
    for (const Sample& s : state.samples) peak = std::max(peak, s.stress_mpa);
    return peak;
  };
  const double fast = peak_of(config);
  config.experiment.loading.rate_control.enabled = false;
  config.experiment.loading.closing_rate_mm_per_s = 40;
  CHECK(fast == Approx(peak_of(config)).epsilon(0.02));
}
