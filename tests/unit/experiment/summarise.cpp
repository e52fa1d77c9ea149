#include "core/experiment/summarise.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/experiment/failure_entries.hpp"
#include "tests/unit/experiment/small_models.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

/// Curve with its peak of 4 MPa in the middle and a closed, quiet energy account.
std::vector<Sample> good_samples() {
  std::vector<Sample> samples;
  for (int i = 0; i <= 10; ++i) {
    Sample s;
    s.axial_strain = s.gauge_axial_strain = 0.001 * i;
    s.lateral_strain = 0.0002 * i;
    s.closure_mm = 0.054 * i;
    s.stress_mpa = i <= 5 ? 0.8 * i : 8.0 - 0.8 * i;
    s.load_n_per_mm = 100.0 * s.stress_mpa;
    s.disc = i == 5 ? DiscReading{0.25, 0.75, 7.5} : DiscReading{9, 9, 9};
    s.energy.external_work = 1.0 + i;
    s.energy.elastic = 0.99 * (1.0 + i);
    s.energy.kinetic = 0.01 * (1.0 + i);
    s.cracks_tension = i > 5 ? 2 : 0;
    samples.push_back(s);
  }
  return samples;
}

struct Case {
  Model model;
  RunState state;

  explicit Case(ExperimentType type = ExperimentType::brazilian) : model(small_model(small_config(type))) {
    state.samples = good_samples();
    state.stop = StopReason::strain;
  }
  Summary summary() const { return summarise(model, state); }
  /// Whether some warning holds these words.
  bool warns(const std::string& words) const {
    for (const std::string& warning : summary().warnings) {
      if (warning.find(words) != std::string::npos) return true;
    }
    return false;
  }
};

}  // namespace

TEST_CASE("a good run has no warnings") { CHECK(Case().summary().warnings.empty()); }

TEST_CASE("the literal law's own energy is a warning with its figure and share") {
  Case c;
  c.model.config.contacts.law.reading = LawReading::literal;
  c.state.samples.back().energy.created_by_law = 0.55;
  CHECK(c.warns("literal contact law itself added 0.55 N mm"));
  CHECK(c.warns("5 % of the external work"));  // of 11 N mm
}

TEST_CASE("an open energy account is a warning under the default law") {
  Case c;
  EnergyBalance& e = c.state.samples.back().energy;
  e.elastic += 0.0009 * e.external_work;
  CHECK_FALSE(c.warns("account is open"));
  e.elastic += 0.0002 * e.external_work;
  CHECK(c.warns("account is open by 0.11 %"));
}

TEST_CASE("a peak at the end of the range is a warning") {
  Case c;
  c.model.config.measurement.peak_strain_limit = 0.0049;
  CHECK(c.warns("no peak was passed"));
  c.model.config.measurement.peak_strain_limit = 0.0061;
  CHECK_FALSE(c.warns("no peak was passed"));
}

TEST_CASE("too quick a loading is a warning, what moves after the peak is none") {
  Case c;
  c.state.samples[8].energy.kinetic = 5.0;
  c.state.samples[8].energy.elastic = 4.0;
  CHECK_FALSE(c.warns("load more slowly"));
  c.state.samples[3].energy.kinetic = 0.05 * c.state.samples[3].energy.elastic;
  CHECK(c.warns("load more slowly"));
  CHECK(c.summary().energy["kinetic_over_stored_before_peak"].get<double>() == Approx(0.05).epsilon(1e-14));
}

TEST_CASE("added mass is a warning") {
  Case c;
  c.model.added_mass_fraction = 2.0;  // the default bound itself
  CHECK_FALSE(c.warns("mass scaling"));
  c.model.added_mass_fraction = 2.25;
  CHECK(c.warns("mass scaling added 225 % to the specimen's mass (limit 200 %)"));
}

TEST_CASE("a disc's results are its splitting strength and the load and closure at the peak") {
  const auto results = Case().summary().results;
  CHECK(results["tensile_strength_mpa"] == 4.0);
  CHECK(results["peak_load_n_per_mm"] == 400.0);
  CHECK(results["peak_closure_mm"] == 0.27);
  CHECK(results["first_drop_stress_mpa"] == 4.0);  // 0.8 MPa lower with the first crack
  CHECK(results["centre_tension_at_peak_mpa"] == 0.25);
  CHECK(results["centre_compression_at_peak_mpa"] == 0.75);
  CHECK(results["contact_half_angle_at_peak_deg"] == 7.5);
}

TEST_CASE("a compression test's results are moduli, peak and pressure") {
  Case c(ExperimentType::uniaxial);
  for (const char* key : {"youngs_modulus_gpa", "poissons_ratio", "peak_axial_stress_mpa", "peak_axial_strain",
                          "confining_pressure_mpa"}) {
    CHECK(c.summary().results.contains(key));
  }
  CHECK(c.summary().results["peak_axial_stress_mpa"] == 4.0);
  CHECK(c.summary().results["peak_axial_strain"] == 0.005);
  CHECK(c.summary().results["youngs_modulus_gpa"].is_null());  // one sample lies in the window from 0.8 to 2 MPa
  c.model.config.measurement.modulus_window_low = 0.1;
  c.model.config.measurement.modulus_window_high = 0.9;
  // Slope 800 MPa with nu' = 0.2 in plane strain: nu = 0.2 / 1.2, E = 800 (1 - nu^2).
  CHECK(c.summary().results["poissons_ratio"].get<double>() == Approx(0.2 / 1.2).epsilon(1e-13));
  CHECK(c.summary().results["youngs_modulus_gpa"].get<double>() == Approx(0.8 * (1 - 1.0 / 36)).epsilon(1e-13));
}

TEST_CASE("the closure error is relative to the external work") {
  EnergyBalance e;
  CHECK(relative_closure_error(e) == 0.0);
  e.external_work = 10.0;
  e.elastic = 4.0;
  e.friction = 7.0;
  CHECK(relative_closure_error(e) == Approx(0.1).epsilon(1e-15));
}

TEST_CASE("cracks and fragments stand in the summary") {
  const auto cracks = Case().summary().cracks;
  CHECK(cracks["tension"] == 2);
  CHECK(cracks["shear"] == 0);
  CHECK(cracks["fragments"] == 1);
  CHECK(cracks["largest_fragment_share"] == 1.0);
  CHECK(cracks["fragment_d50_mm"] == cracks["fragment_d80_mm"]);  // there is one fragment
  CHECK(cracks["acoustic_events"] == 0);                          // of the model, which is whole
  for (const char* key : {"tension_order_parameter", "shear_order_parameter", "completeness_magnitude", "b_value"}) {
    CHECK(cracks.at(key).is_null());
  }
}

TEST_CASE("a broken contact has its direction, its event and its fragments in the summary") {
  Case c;
  BondedContacts& contacts = c.model.system.contacts;
  BrokenEdge& broken = contacts.broken_edge(0);
  broken.points = {BreakMode::shear, BreakMode::shear};
  broken.break_time = 0.0;
  std::array<PointState, 2> points = contacts.memory.load(0);
  for (PointState& s : points) s.fracture_energy = 0.5;
  contacts.memory.store(0, points);
  const auto cracks = c.summary().cracks;
  CHECK(cracks["acoustic_events"] == 1);
  CHECK(cracks["events_above_completeness"] == 1);
  CHECK(cracks["completeness_magnitude"].is_number());
  CHECK(cracks["b_value"].is_null());  // of one event
  CHECK(cracks["tension_order_parameter"].is_null());
  const double order = cracks["shear_order_parameter"];
  CHECK(std::abs(order) <= 1.0);
}

TEST_CASE("crack initiation and damage stand in a compression test's results where the specimen dilates") {
  Case c(ExperimentType::uniaxial);
  c.model.config.measurement.modulus_window_low = 0.1;
  c.model.config.measurement.modulus_window_high = 0.7;
  CHECK(c.summary().results.at("crack_damage_stress_mpa").is_null());  // elastic up to its peak
  c.state.samples[4].lateral_strain += 0.002;
  c.state.samples[5].lateral_strain += 0.004;
  CHECK(c.summary().results["crack_damage_stress_mpa"] == c.state.samples[3].stress_mpa);
}

TEST_CASE("the failure mode is told at half the peak and at the end, for discs and compression") {
  Case c;
  const auto disc = c.summary().failure_mode;
  CHECK(disc["at_end"]["verdict"] == "none");
  CHECK(disc["at_end"]["splits"] == false);
  CHECK(disc["at_end"]["split_tension_share"].is_number_float());  // NaN, which the file has as null
  CHECK(disc["at_end"]["largest_fragment_share"] == 1.0);
  CHECK(disc["at_half_peak"]["axial_strain"] == 0.008);  // 1.6 MPa of 4
  for (Sample& s : c.state.samples) s.stress_mpa = std::max(s.stress_mpa, 2.5);
  CHECK(c.summary().failure_mode["at_half_peak"].is_null());
  const auto compression = Case(ExperimentType::uniaxial).summary().failure_mode;
  for (const char* key : {"verdict", "band_angle_deg", "band_concentration", "cluster_angle_deg", "cluster_spans_width",
                          "order_parameter", "tension_share_of_length", "second_fragment_share"}) {
    CHECK(compression["at_end"].contains(key));
  }
}

TEST_CASE("half the peak counts from the confining pressure") {
  std::vector<Sample> samples = good_samples();  // ... 4, 3.2, 2.4, 1.6, 0.8, 0
  const Peak peak = find_peak(samples, 1.0);
  CHECK(half_peak_sample(samples, peak, 0.0) == &samples[8]);
  CHECK(half_peak_sample(samples, peak, 1.0) == &samples[7]);
  samples.resize(7);
  CHECK(half_peak_sample(samples, peak, 0.0) == nullptr);
}

TEST_CASE("every reason to stop has its words") {
  CHECK(describe(StopReason::strain) == "reached the stop strain");
  CHECK(describe(StopReason::fraction_of_peak) == "fell below the stop fraction of the peak");
  CHECK(describe(StopReason::time) == "reached the stop time");
  CHECK(describe(StopReason::shear_displacement) == "reached the stop shear displacement");
  CHECK(describe(StopReason::interrupted) == "interrupted");
}
