#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "core/measurement/crack_network.hpp"
#include "core/measurement/crack_pattern.hpp"
#include "tests/support/models.hpp"
#include "tests/unit/experiment/small_models.hpp"

using namespace asperity;
using namespace asperity::testing;

/// Mechanisms of contacts and surfaces in whole tests, coarse ones of some two hundred particles.
namespace {

RunConfig with(RunConfig config, const std::string& type, const std::map<std::string, double>& values = {}) {
  config.mechanisms.push_back({type, std::nullopt, values});
  return config;
}

/// A weak specimen, loaded quickly through its peak.
RunConfig uniaxial() {
  RunConfig config = small_config(ExperimentType::uniaxial);
  config.experiment.loading.closing_rate_mm_per_s = 400;
  config.experiment.stop.axial_strain = 0.01;
  config.contacts.tensile_strength_mpa = 2;
  config.contacts.cohesion_mpa = 1.2;
  config.contacts.friction_angle_deg = 25;
  config.contacts.fracture_energy_n_per_mm = 0.02;
  return config;
}

struct Run {
  Model model;
  RunState state;

  double peak() const {
    double peak = 0.0;
    for (const Sample& s : state.samples) peak = std::max(peak, s.stress_mpa);
    return peak;
  }
  /// Largest error of the account over the work done by then, from a tenth of all work on.
  double energy_error() const {
    const double all = state.samples.back().energy.external_work;
    double worst = 0.0;
    for (const Sample& s : state.samples) {
      if (s.energy.external_work < 0.1 * all) continue;
      worst = std::max(worst, std::abs(s.energy.error()) / s.energy.external_work);
    }
    return worst;
  }
  int cracks() const { return state.samples.back().cracks_tension + state.samples.back().cracks_shear; }
};

Run run(const RunConfig& config, const ParallelLoops& loops = ParallelLoops()) {
  Run result{build_model(config, loops), {}};
  result.state = start_run(result.model);
  run_experiment(result.model, result.state, loops, {});
  return result;
}

bool same_bits(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec2)) == 0;
}

bool same_motion(const Run& a, const Run& b) {
  return a.model.system.step == b.model.system.step &&
         same_bits(a.model.system.particles.position, b.model.system.particles.position) &&
         same_bits(a.model.system.particles.velocity, b.model.system.particles.velocity);
}

double largest_wear(const Run& r) {
  double largest = 0.0;
  for (const double wear : r.model.system.general.wear) largest = std::max(largest, wear);
  return largest;
}

}  // namespace

TEST_CASE("energy is closed through the peak with each of the contacts' mechanisms on, and each changes the test") {
  const Run base = run(uniaxial());
  WARN("base: peak " << base.peak() << " MPa, " << base.cracks() << " cracks, energy error " << base.energy_error());
  REQUIRE(base.cracks() > 10);
  for (const std::string type :
       {"curved_envelope", "crack_closure", "coulomb_peak", "shear_softening", "strength_scatter", "initial_defects",
        "weak_plane", "weak_skin", "slip_weakening", "rate_strengthening"}) {
    const Run varied = run(with(uniaxial(), type));
    WARN(type << ": peak " << varied.peak() << " MPa, " << varied.cracks() << " cracks, energy error "
              << varied.energy_error() << ", largest wear " << largest_wear(varied) << " mm");
    CHECK(varied.energy_error() < 1e-3);
    CHECK_FALSE(same_motion(varied, base));
  }
}

TEST_CASE("a mechanism at its neutral values is the base model to the last bit of a cracked specimen") {
  const Run base = run(uniaxial());
  REQUIRE(base.cracks() > 0);
  using Values = std::map<std::string, double>;
  const std::pair<std::string, Values> neutral[] = {
      {"curved_envelope", {{"exponent", 1.0}}},      {"crack_closure", {{"stiffness_ratio", 1.0}}},
      {"coulomb_peak", {{"excess_deg", 0.0}}},       {"weak_plane", {{"strength_ratio", 1.0}}},
      {"weak_skin", {{"strength_ratio", 1.0}}},      {"initial_defects", {{"fraction", 0.0}}},
      {"slip_weakening", {{"residual_share", 1.0}}}, {"rate_strengthening", {{"per_decade", 0.0}}}};
  for (const auto& [type, values] : neutral) {
    INFO(type);
    CHECK(same_motion(run(with(uniaxial(), type, values)), base));
  }
}

TEST_CASE("worn surfaces among defects under pressure: one and two threads give the same bits, and energy is closed") {
  RunConfig config = with(crushed_triaxial(), "slip_weakening", {{"slip_mm", 0.02}});
  config = with(config, "initial_defects", {{"fraction", 0.05}});
  config.experiment.stop.axial_strain = 0.03;
  const Run one = run(config), two = run(config, ParallelLoops(2));
  CHECK(same_motion(one, two));
  CHECK(one.model.system.general.wear == two.model.system.general.wear);
  CHECK(largest_wear(one) > 0.01);
  WARN("crushed specimen: largest wear " << largest_wear(one) << " mm, energy error " << one.energy_error());
  CHECK(one.energy_error() < 1e-3);
}

TEST_CASE("defects: no cracks of the test, not even before it, but open from the first step") {
  const RunConfig config = with(uniaxial(), "initial_defects", {{"fraction", 0.15}});
  Model model = small_model(config);
  const BondedContacts& contacts = model.system.contacts;
  const auto defects = static_cast<int>(contacts.broken.size());
  REQUIRE(defects > 20);
  const ParallelLoops loops;
  const CrackCounts counts = count_cracks(contacts, loops);
  CHECK(counts.tension + counts.shear + counts.softening == 0);
  CHECK(list_cracks(contacts, model.system.particles).empty());
  CHECK(crack_pattern(contacts, model.system.particles, 1.0).empty());
  const std::vector<CrackSegment> segments = crack_segments(contacts, model.system.particles);
  CHECK(static_cast<int>(segments.size()) == defects);
  for (const CrackSegment& segment : segments) CHECK(segment.mode == CrackMode::defect);
  compute_forces(model.system, loops);
  CHECK(static_cast<int>(model.system.general.handing_over.size()) == defects);  // general contact knows them

  const Run whole = run(config);
  const auto listed = list_cracks(whole.model.system.contacts, whole.model.system.particles);
  CHECK(static_cast<int>(listed.size()) == whole.cracks());
  for (const Crack& crack : listed) CHECK(crack.time_s > 0.0);
  CHECK(test::broken(whole.model.system.contacts) == whole.cracks() + defects);
}

TEST_CASE("the literal law and the second form take strengths and defects too") {
  for (const bool literal : {true, false}) {
    RunConfig config = uniaxial();
    if (literal) {
      config.contacts.law.reading = LawReading::literal;
    } else {
      config.contacts.law.form = LawForm::cohesive_frictional;
    }
    const Run base = run(config);
    const Run scattered = run(with(config, "strength_scatter", {{"weibull_modulus", 3.0}}));
    const Run defective = run(with(config, "initial_defects", {{"fraction", 0.1}}));
    WARN((literal ? "literal" : "cohesive_frictional")
         << ": peaks " << base.peak() << ", scattered " << scattered.peak() << ", with defects " << defective.peak()
         << " MPa; energy errors " << base.energy_error() << ", " << scattered.energy_error() << ", "
         << defective.energy_error());
    CHECK(scattered.peak() < base.peak());
    CHECK(scattered.cracks() > 10);
    CHECK(defective.cracks() > 10);
    // The literal law's own account is far from closed; mechanisms do not open it further.
    const double allowed = literal ? 1.2 * base.energy_error() : 1e-3;
    CHECK(scattered.energy_error() < allowed);
    CHECK(defective.energy_error() < allowed);
  }
}
