#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/random.hpp"
#include "core/contact/closed_forms.hpp"
#include "core/contact/cohesive_frictional_law.hpp"

using namespace asperity;

namespace {

constexpr double kE = consistent_law::kE;
constexpr double kRounding = 1e-12;
constexpr double kManySteps = 1e-10;  // rounding of some hundred steps added up
const LawParameters kLaw = law_parameters(RunConfig{});

LawParameters softening_law() {
  RunConfig config;
  config.contacts.shear_fracture_energy_n_per_mm = 0.2;
  return law_parameters(config);
}

/// Drives a point along a straight leg; returns the work done on it by trapezoids, N/mm.
double drive(PointState& s, double normal, double shear, int steps = 200, const LawParameters& law = kLaw) {
  const double n0 = s.normal, s0 = s.shear;
  double work = 0.0;
  for (int i = 1; i <= steps; ++i) {
    const PointState before = s;
    const double part = static_cast<double>(i) / steps;
    cohesive_frictional_law::update(s, n0 + part * (normal - n0), s0 + part * (shear - s0), law);
    work += 0.5 * (before.traction_n + s.traction_n) * (s.normal - before.normal);
    work += 0.5 * (before.traction_s + s.traction_s) * (s.shear - before.shear);
  }
  return work;
}

PointState at(double normal, double shear, int steps = 200, const LawParameters& law = kLaw) {
  PointState s;
  drive(s, normal, 0.0, steps, law);
  drive(s, normal, shear, steps, law);
  return s;
}

}  // namespace

TEST_CASE("Cohesive-frictional form: the virgin tension curve is Eq 3") {
  for (const double part : {0.1, 0.5, 1.0}) {
    const double d = part * kLaw.delta_ct;
    CHECK(at(d, 0).traction_n == Approx(kLaw.k_t * d * std::exp(-part)).epsilon(kRounding));
  }
  for (const double damage : {0.25, 0.5, 0.9}) {
    const PointState s = at(kLaw.delta_ct + damage * (kLaw.delta_ut - kLaw.delta_ct), 0);
    CHECK(s.traction_n == Approx(kLaw.t_c * (1 - damage)).epsilon(kManySteps));
    CHECK(s.damage == Approx(damage).epsilon(kManySteps));
  }
  CHECK(at(1.01 * kLaw.delta_ut, 0).traction_n == 0.0);
  CHECK(at(1.01 * kLaw.delta_ut, 0).broken == BreakMode::tension);
}

TEST_CASE("Cohesive-frictional form: shear without pressure is Eq 6's rise, then the drop") {
  for (const double part : {0.1, 0.6, 0.999}) {
    const double d = part * kLaw.delta_cs;
    CHECK(at(0, d).traction_s == Approx(kLaw.k_s * d * std::exp(-part)).epsilon(kRounding));
    CHECK(at(0, -d).traction_s == Approx(-kLaw.k_s * d * std::exp(-part)).epsilon(kRounding));
    CHECK(at(0, d).broken == BreakMode::none);
  }
  CHECK(at(0, 1.001 * kLaw.delta_cs).broken == BreakMode::shear);
  CHECK(at(0, 1.001 * kLaw.delta_cs).traction_s == 0.0);
}

TEST_CASE("Cohesive-frictional form: both modes unload along the secant of their common g") {
  PointState s = at(0.6 * kLaw.delta_ct, 0.7 * kLaw.delta_cs);
  const double g = std::exp(-std::hypot(0.6, 0.7));
  CHECK(s.integrity_n == s.integrity_s);
  CHECK(s.integrity_s == Approx(g).epsilon(kRounding));
  drive(s, 0.3 * kLaw.delta_ct, -0.2 * kLaw.delta_cs);
  CHECK(s.traction_n == Approx(g * kLaw.k_t * 0.3 * kLaw.delta_ct).epsilon(kRounding));
  CHECK(s.traction_s == Approx(-g * kLaw.k_s * 0.2 * kLaw.delta_cs).epsilon(kRounding));
}

TEST_CASE("Cohesive-frictional form: shear under pressure sticks, then mobilises friction with the damage, Eq. (A8)") {
  const double pressure = GENERATE(0.5, 3.0, 10.0);
  const double normal = -pressure / kLaw.k_t, friction = pressure * kLaw.tan_phi;
  for (const double kappa : {0.02, 0.3, 0.7, 0.999}) {
    const double elastic = kLaw.k_s * kappa * kLaw.delta_cs, g = std::exp(-kappa);
    const double expected = g * elastic + (1.0 - g) * std::min(elastic, friction);
    CHECK(at(normal, kappa * kLaw.delta_cs).traction_s == Approx(expected).epsilon(kManySteps));
  }
  const double peak = kLaw.c_c + (1.0 - 1.0 / kE) * std::min(friction, kE * kLaw.c_c);
  CHECK(at(normal, (1 - 1e-9) * kLaw.delta_cs).traction_s == Approx(peak).epsilon(1e-8));  // 1e-9 before it
  const PointState after = at(normal, 1.001 * kLaw.delta_cs);
  CHECK(after.broken == BreakMode::shear);
  CHECK(after.traction_s == Approx(friction).epsilon(kManySteps));
}

TEST_CASE("Cohesive-frictional form: under pressure a reversal has the slope k_s until friction slides back") {
  const double pressure = 2.0, friction = pressure * kLaw.tan_phi;
  PointState s = at(-pressure / kLaw.k_t, 0.8 * kLaw.delta_cs);
  REQUIRE(kLaw.k_s * s.shear > friction);  // it has slid
  const double stress = s.traction_s, back = 1.9 * friction / kLaw.k_s;
  drive(s, s.normal, s.shear - back);
  CHECK(s.traction_s == Approx(stress - kLaw.k_s * back).epsilon(kManySteps));
  drive(s, s.normal, s.shear - back);
  CHECK(s.friction == Approx(-(1.0 - s.integrity_s) * friction).epsilon(kManySteps));
}

TEST_CASE("Cohesive-frictional form: pieces broken at different times share their mean elastic slip") {
  const double high = -5.0 / kLaw.k_t, low = -1.0 / kLaw.k_t;
  const double limit = 1.0 * kLaw.tan_phi;
  PointState s = at(low, 0.5 * kLaw.delta_cs);
  const double first = 1.0 - s.integrity_s;
  CHECK(s.friction == Approx(first * limit).epsilon(kManySteps));
  drive(s, high, s.shear);  // no more damage, no slip: what friction carries stays
  CHECK(s.friction == Approx(first * limit).epsilon(kManySteps));
  const double elastic = kLaw.k_s * 0.51 * kLaw.delta_cs;
  cohesive_frictional_law::update(s, high, 0.51 * kLaw.delta_cs, kLaw);
  const double second = 1.0 - s.integrity_s - first;
  const double carried = first * (limit + kLaw.k_s * 0.01 * kLaw.delta_cs);
  const double kept = std::min(elastic, 5.0 * kLaw.tan_phi);
  CHECK(s.friction == Approx(carried + second * kept).epsilon(kManySteps));
}

TEST_CASE("Cohesive-frictional form: a contact that opens forgets its friction, and the stress is continuous there") {
  RandomStream random(1, "continuity");
  const double small = 1e-9 * kLaw.delta_ct;
  for (int i = 0; i < 500; ++i) {
    PointState s;
    for (int leg = 0; leg < 3; ++leg)
      drive(s, random.uniform(-4, 4) * kLaw.delta_ct, random.uniform(-2, 2) * kLaw.delta_cs, 50);
    drive(s, -small, random.uniform(-1, 1) * kLaw.delta_cs, 50);
    PointState open = s;
    cohesive_frictional_law::update(open, small, s.shear, kLaw);
    // Over 2e-9 delta_ct the steepest slope met, k_t (tan(phi) times it in friction), moves the stress by 4e-8 MPa.
    CHECK(std::abs(open.traction_n - s.traction_n) < 1e-7);
    CHECK(std::abs(open.traction_s - s.traction_s) < 1e-7);
    CHECK(open.friction == 0.0);
  }
}

TEST_CASE("Cohesive-frictional form: damage and spent energies never fall, integrity never grows") {
  const LawParameters law = GENERATE(false, true) ? softening_law() : kLaw;
  RandomStream random(2, "monotony");
  int broken = 0;
  for (int i = 0; i < 300; ++i) {
    PointState s;
    for (int leg = 0; leg < 40; ++leg) {
      const PointState before = s;
      drive(s, random.uniform(-2, 3) * law.delta_ct, random.uniform(-6, 6) * law.delta_cs, 10, law);
      REQUIRE(s.damage >= before.damage);
      REQUIRE(s.hardening >= before.hardening);
      REQUIRE(s.integrity_s <= before.integrity_s);
      REQUIRE(s.integrity_n == s.integrity_s);
      REQUIRE(s.fracture_energy >= before.fracture_energy);
      REQUIRE(s.friction_energy >= before.friction_energy);
      REQUIRE((before.broken == BreakMode::none || s.broken == before.broken));
    }
    broken += s.broken != BreakMode::none;
  }
  CHECK(broken > 50);
}

TEST_CASE("Cohesive-frictional form: a contact pulled apart spends G_f, one sheared without pressure G_II") {
  const LawParameters law = softening_law();
  PointState opened, sheared;
  const double open_work = drive(opened, 1.001 * law.delta_ut, 0.0, 5000, law);
  const double shear_work = drive(sheared, 0.0, 1.001 * law.kappa_us * law.delta_cs, 20000, law);
  const double g_f = closed_forms::fracture_energy(law.t_c, law.delta_ct, law.delta_ut);
  CHECK(opened.broken == BreakMode::tension);
  CHECK(opened.fracture_energy == Approx(g_f).epsilon(1e-3));  // 200 steps to the peak give (1/200)^2
  CHECK(open_work == Approx(g_f).epsilon(1e-3));
  CHECK(sheared.broken == BreakMode::shear);
  CHECK(sheared.fracture_energy == Approx(0.2).epsilon(1e-5));  // (1 / 20000 of the slip)^2 and the last step
  CHECK(shear_work == Approx(0.2).epsilon(1e-5));
  CHECK(opened.friction_energy + sheared.friction_energy == 0.0);
}

TEST_CASE("Cohesive-frictional form: with a fracture energy in shear the cohesion goes over one slip at any pressure") {
  const LawParameters law = softening_law();
  const double pressure = GENERATE(0.0, 2.0, 10.0), friction = pressure * law.tan_phi;
  const double slip = (law.kappa_us - 1.0) * law.delta_cs;
  for (const double part : {0.25, 0.5, 0.9}) {
    const double d = law.delta_cs + part * slip;
    const PointState s = at(-pressure / law.k_t, d, 400, law);
    const double g = (1.0 - part) * law.c_c / (law.k_s * d);
    CHECK(s.broken == BreakMode::none);
    CHECK(s.traction_s == Approx((1.0 - part) * law.c_c + (1.0 - g) * friction).epsilon(kManySteps));
  }
  const PointState after = at(-pressure / law.k_t, law.delta_cs + 1.01 * slip, 400, law);
  CHECK(after.broken == BreakMode::shear);
  CHECK(after.traction_s == Approx(friction).epsilon(kManySteps).margin(kRounding));
}

TEST_CASE("Cohesive-frictional form: each energy of a sheared contact has its closed form") {
  // Sheared to d under pressure p the first time, with f = p tan(phi_c): a piece that breaks at u loses
  // k_s u^2 / 2 - f^2 / (2 k_s) where u > f / k_s, nothing before; the damaged share then slides at f.
  const double pressure = 3.0, f = pressure * kLaw.tan_phi, stick = f / kLaw.k_s;
  const double d = 0.9 * kLaw.delta_cs;
  REQUIRE(stick < d);
  double fracture = 0.0, friction = 0.0;
  constexpr int kSlices = 20000;
  for (int i = 0; i < kSlices; ++i) {
    const double width = (d - stick) / kSlices, u = stick + (i + 0.5) * width;
    const double g = std::exp(-u / kLaw.delta_cs);
    fracture += width * g / kLaw.delta_cs * 0.5 * (kLaw.k_s * u * u - f * f / kLaw.k_s);
    friction += width * (1.0 - g) * f;
  }
  PointState s;
  drive(s, -pressure / kLaw.k_t, 0.0);
  const double work = drive(s, s.normal, d, 20000);
  CHECK(s.fracture_energy == Approx(fracture).epsilon(1e-4));  // one step of 20,000 is partly stuck
  CHECK(s.friction_energy == Approx(friction).epsilon(1e-4));
  const double pressed = 0.5 * pressure * pressure / kLaw.k_t;
  CHECK(consistent_law::recoverable_energy(s, kLaw) - pressed + s.fracture_energy + s.friction_energy ==
        Approx(work).epsilon(1e-6));
}

TEST_CASE("Cohesive-frictional form: broken, it has only friction, as the first form has") {
  PointState sheared = at(-3.0 / kLaw.k_t, 1.5 * kLaw.delta_cs);
  REQUIRE(sheared.broken == BreakMode::shear);
  PointState other = sheared;
  RandomStream random(4, "after breakage");
  for (int i = 0; i < 200; ++i) {
    const double normal = random.uniform(-2, 1) * kLaw.delta_ct, shear = random.uniform(-2, 2) * kLaw.delta_cs;
    cohesive_frictional_law::update(sheared, normal, shear, kLaw);
    consistent_law::update(other, normal, shear, kLaw);
    REQUIRE(sheared.traction_n == other.traction_n);
    REQUIRE(sheared.traction_s == other.traction_s);
    REQUIRE(sheared.friction_energy == other.friction_energy);
    REQUIRE((normal < 0.0 || (sheared.traction_n == 0.0 && sheared.traction_s == 0.0)));
  }
}

TEST_CASE("Cohesive-frictional form: it breaks in the mode that has the larger part") {
  const LawParameters law = softening_law();
  PointState pulled, slid;
  const double enough = 2.0 * law.kappa_ut;  // more than any mixture of the modes needs
  drive(pulled, enough * law.delta_ct, 0.9 * enough * law.delta_cs, 2000, law);
  drive(slid, 0.9 * enough * law.delta_ct, enough * law.delta_cs, 2000, law);
  CHECK(pulled.broken == BreakMode::tension);
  CHECK(slid.broken == BreakMode::shear);
}
