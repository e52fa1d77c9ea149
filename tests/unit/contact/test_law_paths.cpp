#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/contact/closed_forms.hpp"
#include "core/contact/law_paths.hpp"

using namespace asperity;

/// What is read off driven paths against the closed forms, which the driving does not know.
namespace {

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;
constexpr double kBisected = 1e-9;  // onset and break are bisected to rounding; the tractions there are smooth
const RunConfig kConfig;

DrivenLaw literal() {
  LawConfig law;
  law.reading = LawReading::literal;
  return driven_law(kConfig, law);
}

DrivenLaw cohesive_frictional() {
  LawConfig law;
  law.form = LawForm::cohesive_frictional;
  return driven_law(kConfig, law);
}

DrivenLaw softening() {
  RunConfig config;
  config.contacts.shear_fracture_energy_n_per_mm = 0.3;
  return driven_law(config);
}

double largest_tension(const LawPath& path) {
  double largest = 0.0;
  for (const PathPoint& p : path) largest = std::max(largest, p.normal_traction);
  return largest;
}

}  // namespace

TEST_CASE("Pure opening peaks at t_c, ends at delta_ut and takes G_f") {
  for (const DrivenLaw& law : {driven_law(kConfig), literal()}) {
    const LawParameters& p = law.parameters;
    const LawPath path = opening_path(law, 1.05 * p.delta_ut, {}, {p.delta_ct});
    CHECK(largest_tension(path) == Approx(p.t_c).epsilon(1e-12));
    CHECK(path.back().normal_traction == 0.0);
    CHECK(path.back().broken);
    // Trapezoids of delta_ut / 1430 on a curve of length delta_ct = delta_ut / 24: some 0.02 % of the hardening's area.
    CHECK(loading_work(path) == Approx(derive(kConfig, kConfig.experiment.plane).g_f).epsilon(2e-4));
    const LawLimits limits = limits_in_opening(law, 0.0);
    CHECK(limits.first_damage.opening == Approx(p.delta_ct).epsilon(kBisected));
    CHECK(limits.strongest.normal_traction == Approx(p.t_c).epsilon(kBisected));
    CHECK(limits.last_bonded.opening == Approx(p.delta_ut).epsilon(kBisected));
  }
}

TEST_CASE("Unloading in opening leads to the origin and reloading leads back; the literal law's hardening is elastic") {
  const LawParameters p = driven_law(kConfig).parameters;
  const double in_hardening = 0.5 * p.delta_ct, in_softening = 0.5 * p.delta_ut;
  for (const DrivenLaw& law : {driven_law(kConfig), literal()}) {
    const LawPath once = opening_path(law, p.delta_ut),
                  looped = opening_path(law, p.delta_ut, {in_hardening, in_softening});
    CHECK(looped.back().normal_traction == Approx(once.back().normal_traction).margin(1e-9));
    double curved = 0.0;  // off the straight line to the origin, while unloading for the first time
    PathPoint turn;
    for (const PathPoint& q : looped) {
      if (q.leg == PathLeg::loading) turn = q;
      if (q.leg == PathLeg::unloading && turn.opening < p.delta_ct)
        curved = std::max(curved, std::abs(q.normal_traction - turn.normal_traction * q.opening / turn.opening));
    }
    CHECK((curved > 0.05 * p.t_c) == (law.reading == LawReading::literal));
  }
}

TEST_CASE("Under pressure the default law peaks at c_c + p tan(phi_c), the literal one at c_c; friction stays") {
  for (const double pressure : {0.0, 2.0, 10.0}) {
    const DrivenLaw law = driven_law(kConfig);
    const LawParameters& p = law.parameters;
    const LawLimits limits = limits_under_pressure(law, pressure);
    CHECK(-limits.strongest.normal_traction == Approx(pressure).margin(1e-9));
    CHECK(limits.strongest.shear_traction == Approx(p.c_c + pressure * p.tan_phi).epsilon(kBisected));
    CHECK(limits.friction == Approx(pressure * p.tan_phi).margin(1e-9));
    CHECK(limits_under_pressure(literal(), pressure).strongest.shear_traction == Approx(p.c_c).epsilon(kBisected));
    CHECK(limits_under_pressure(literal(), pressure).friction == Approx(pressure * p.tan_phi).margin(1e-9));
  }
}

TEST_CASE("The cohesive-frictional form peaks at c_c + (1 - 1/e) p tan(phi_c), as A8 says") {
  const DrivenLaw law = cohesive_frictional();
  const LawParameters& p = law.parameters;
  const double friction = 2.0 * p.tan_phi;
  CHECK(limits_under_pressure(law, 2.0).strongest.shear_traction ==
        Approx(p.c_c + (1.0 - std::exp(-1.0)) * friction).epsilon(kBisected));
}

TEST_CASE("Eq 6's drop takes no slip, and softening takes G_II without pressure") {
  const LawLimits drop = limits_under_pressure(driven_law(kConfig), 2.0);
  CHECK(drop.last_bonded.slip == Approx(drop.first_damage.slip).epsilon(kBisected));
  const LawLimits soft = limits_under_pressure(softening(), 0.0);
  CHECK(soft.last_bonded.slip > 3.0 * soft.first_damage.slip);
  // As for G_f: the step over the hardening's length.
  CHECK(loading_work(shear_path(softening(), 0.0, soft.last_bonded.slip)) == Approx(0.3).epsilon(1e-3));
}

TEST_CASE("Shear unloads with the slope k_s and comes back to where it left") {
  const DrivenLaw law = driven_law(kConfig);
  const double slip = 0.5 * limits_under_pressure(law, 5.0).strongest.slip;
  const LawPath path = shear_path(law, 5.0, 2.0 * slip, {slip});
  const auto unloading =
      std::find_if(path.begin(), path.end(), [](const PathPoint& q) { return q.leg == PathLeg::unloading; });
  const PathPoint turn = *(unloading - 1), next = *unloading;
  CHECK((turn.shear_traction - next.shear_traction) / (turn.slip - next.slip) ==
        Approx(law.parameters.k_s).epsilon(1e-6));
  const auto back =
      std::find_if(path.rbegin(), path.rend(), [](const PathPoint& q) { return q.leg == PathLeg::reloading; });
  CHECK(back->slip == slip);
  CHECK(back->shear_traction == Approx(turn.shear_traction).epsilon(1e-9));
}

TEST_CASE(
    "In mixed opening the default law's strength is an ellipse, the literal law's a circle that leaps in closing") {
  const DrivenLaw law = driven_law(kConfig), printed = literal();
  const LawParameters& p = law.parameters;
  for (const double angle : {0.2, 0.7, 1.2, kQuarterTurn}) {
    const PathPoint at = limits_in_opening(law, angle).strongest;
    const double ellipse = std::pow(at.normal_traction / p.t_c, 2) + std::pow(at.shear_traction / p.c_c, 2);
    CHECK(ellipse == Approx(1.0).epsilon(1e-6));
    const PathPoint round = limits_in_opening(printed, angle).strongest;
    CHECK(std::hypot(round.normal_traction, round.shear_traction) == Approx(p.t_c).epsilon(1e-6));
  }
  CHECK(limits_in_opening(law, kQuarterTurn).strongest.shear_traction ==
        Approx(limits_under_pressure(law, 0.0).strongest.shear_traction).epsilon(1e-6));
  CHECK(limits_in_opening(printed, kQuarterTurn).strongest.shear_traction >
        1.3 * limits_under_pressure(printed, 0.0).strongest.shear_traction);
}

TEST_CASE("The closed separation bears its pressure also where fine cracks close") {
  DrivenLaw law = driven_law(kConfig);
  law.parameters.closure_share = 0.7;
  law.parameters.closure_length = 0.002;
  const LawPath path = closing_path(law, 4.0);
  CHECK(-path.back().normal_traction == Approx(4.0).epsilon(1e-12));
  CHECK(path.back().opening < closed_separation(driven_law(kConfig), 4.0));
}
