#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/units.hpp"
#include "core/contact/closed_forms.hpp"
#include "core/contact/consistent_law.hpp"
#include "core/contact/general_contact.hpp"
#include "core/mechanism/mechanism.hpp"

using namespace asperity;

/// What mechanisms set of the contact law and the surfaces: X2 to X8.
namespace {

using Values = std::map<std::string, double>;

RunConfig with(const std::string& type, const Values& values = {}, RunConfig config = {}) {
  config.mechanisms = {{type, std::nullopt, values}};
  return with_mechanisms(config);
}

LawParameters law_with(const std::string& type, const Values& values = {}) {
  return law_parameters(with(type, values));
}

const LawParameters kBase = law_parameters(RunConfig{});

}  // namespace

TEST_CASE("coulomb_peak: a peak at a right angle is refused with its name") {
  RunConfig steep;
  steep.contacts.friction_angle_deg = 60.0;
  CHECK_NOTHROW(law_parameters(with("coulomb_peak", {{"excess_deg", 29.0}}, steep)));
  try {
    law_parameters(with("coulomb_peak", {{"excess_deg", 30.0}}, steep));
    FAIL("accepted");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::config);
    CHECK(std::string(error.what()).find("coulomb_peak") != std::string::npos);
  }
}

TEST_CASE(
    "curved_envelope: the exponent of the contact's strength and of the friction that is left; 1 is the base law") {
  const LawParameters law = law_with("curved_envelope");
  const double p = 5.0, y = 1.0 + p * kBase.tan_phi / (0.6 * kBase.c_c);
  CHECK(law.tan_phi == kBase.tan_phi);
  CHECK(law.tan_phi_peak == kBase.tan_phi);
  CHECK(consistent_law::shear_strength(p, law) == Approx(kBase.c_c * std::pow(y, 0.6)).epsilon(1e-14));
  CHECK(consistent_law::friction_limit(1.0, p, law) == Approx(kBase.c_c * (std::pow(y, 0.6) - 1.0)).epsilon(1e-13));
  CHECK(consistent_law::shear_strength(p, law) < consistent_law::shear_strength(p, kBase));
  const LawParameters off = law_with("curved_envelope", {{"exponent", 1.0}});
  CHECK(off.envelope_exponent == 1.0);
  CHECK(consistent_law::shear_strength(p, off) == consistent_law::shear_strength(p, kBase));
  CHECK(consistent_law::friction_limit(0.3, p, off) == consistent_law::friction_limit(0.3, p, kBase));
}

TEST_CASE("crack_closure: first stiffness and length of closing; a ratio of 1 is the base law") {
  const LawParameters law = law_with("crack_closure", {{"stiffness_ratio", 0.25}, {"closure_length_mm", 0.01}});
  CHECK(law.closure_share == 0.75);
  CHECK(law.closure_length == 0.01);
  CHECK(law_with("crack_closure", {{"stiffness_ratio", 1.0}}).closure_share == 0.0);
}

TEST_CASE("coulomb_peak: the intact contact's friction angle alone, and Eq 6's peak in the literal law") {
  const LawParameters law = law_with("coulomb_peak", {{"excess_deg", 10.0}});
  const double phi = RunConfig{}.contacts.friction_angle_deg;
  CHECK(law.tan_phi_peak == Approx(std::tan((phi + 10.0) * units::kRadPerDeg)));
  CHECK(law.tan_phi == kBase.tan_phi);
  CHECK(consistent_law::shear_strength(4.0, law) == law.c_c + 4.0 * law.tan_phi_peak);
  RunConfig literal;
  literal.contacts.law.reading = LawReading::literal;
  CHECK(law_parameters(literal).coulomb == 0.0);
  CHECK(law_parameters(with("coulomb_peak", {}, literal)).coulomb ==
        Approx(std::tan((phi + 15.0) * units::kRadPerDeg)));
  CHECK(law_with("coulomb_peak", {{"excess_deg", 0.0}}).tan_phi_peak == kBase.tan_phi);
}

TEST_CASE("shear_softening: what goes behind the peak is the ratio times G_I; a ratio of 0 drops") {
  const double g_f = derive(RunConfig{}, RunConfig{}.experiment.plane).g_f;
  for (const double ratio : {0.5, 1.0, 10.0}) {
    const LawParameters law = law_with("shear_softening", {{"energy_ratio", ratio}});
    const double behind = 0.5 * law.c_c * law.delta_cs * (law.kappa_us - 1.0);
    CHECK(behind == Approx(ratio * g_f).epsilon(1e-9));
  }
  CHECK(law_with("shear_softening", {{"energy_ratio", 0.0}}).kappa_us == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("shear_softening: a point sheared under no pressure spends the energy it says") {
  const LawParameters law = law_with("shear_softening");
  PointState s;
  double work = 0.0;
  const double last = 1.001 * law.kappa_us * law.delta_cs;
  constexpr int kSteps = 20000;
  for (int i = 1; i <= kSteps; ++i) {
    const double before = s.traction_s, at = s.shear;
    consistent_law::update(s, 0.0, last * i / kSteps, law);
    work += 0.5 * (before + s.traction_s) * (s.shear - at);
  }
  const double rise = law.c_c * law.delta_cs * (std::numbers::e - 2.0);
  CHECK(s.broken == BreakMode::shear);
  CHECK(work == Approx(rise + derive(RunConfig{}, RunConfig{}.experiment.plane).g_f).epsilon(1e-5));
}

TEST_CASE("rate_strengthening: a decade of rate is one share of the strength, energies its square") {
  RunConfig config;
  config.experiment.loading.closing_rate_mm_per_s = 100.0;
  const LawParameters law =
      law_parameters(with("rate_strengthening", {{"per_decade", 0.05}, {"reference_rate_mm_per_s", 10.0}}, config));
  CHECK(law.t_c == Approx(1.05 * kBase.t_c));
  CHECK(law.c_c == Approx(1.05 * kBase.c_c));
  CHECK(law.k_t == kBase.k_t);
  CHECK(law.kappa_ut == Approx(kBase.kappa_ut));
  config.experiment.loading.closing_rate_mm_per_s = 10.0;
  CHECK(law_parameters(with("rate_strengthening", {{"reference_rate_mm_per_s", 10.0}}, config)).t_c == kBase.t_c);
}

TEST_CASE("slip_weakening wears fractures, joint_wear the joint's surfaces under pressure; neither the other") {
  const RunConfig fresh = with("slip_weakening");
  const GeneralContactLaw weak = general_contact_law(fresh, law_parameters(fresh));
  CHECK(weak.surfaces[static_cast<int>(SurfaceKind::fracture)].wear == FrictionWear{0.6, 0.1, 0.0});
  CHECK(weak.surfaces[static_cast<int>(SurfaceKind::outline)].wear == FrictionWear{});
  RunConfig joint;
  joint.experiment.type = ExperimentType::direct_shear;
  joint.experiment.normal_stress_mpa = 1.0;
  joint = with("joint_wear", {{"slip_mm", 3.0}}, joint);
  const GeneralContactLaw worn = general_contact_law(joint, law_parameters(joint));
  CHECK(worn.surfaces[static_cast<int>(SurfaceKind::outline)].wear == FrictionWear{0.8, 3.0, 1.0});
  CHECK(worn.surfaces[static_cast<int>(SurfaceKind::fracture)].wear == FrictionWear{});
}
