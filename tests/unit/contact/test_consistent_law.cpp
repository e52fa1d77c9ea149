#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/random.hpp"
#include "core/contact/closed_forms.hpp"
#include "core/contact/consistent_law.hpp"

using namespace asperity;

namespace {

constexpr double kRounding = 1e-12;
constexpr double kManySteps = 1e-10;  // rounding of some hundred steps added up
const LawParameters kLaw = law_parameters(RunConfig{});

void drive(PointState& s, double normal, double shear, int steps = 200) {
  const double n0 = s.normal, s0 = s.shear;
  for (int i = 1; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    consistent_law::update(s, n0 + part * (normal - n0), s0 + part * (shear - s0), kLaw);
  }
}

PointState at(double normal, double shear) {
  PointState s;
  drive(s, normal, 0.0);
  drive(s, normal, shear);
  return s;
}

double peak_at(double pressure) { return kLaw.c_c + pressure * kLaw.tan_phi; }
double critical_at(double pressure) { return closed_forms::critical_displacement(peak_at(pressure), kLaw.k_s); }

}  // namespace

TEST_CASE("Default law: the virgin tension curve is Eq 3") {
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

TEST_CASE("Default law: tension unloads and reloads along the secant, also before the peak") {
  const double largest = GENERATE(0.5, 1.0, 5.0, 20.0) * kLaw.delta_ct;
  PointState s = at(largest, 0);
  const double secant = s.traction_n / largest;
  for (const double part : {0.7, 0.1, 0.4, 0.999}) {
    drive(s, part * largest, 0);
    CHECK(s.traction_n == Approx(secant * part * largest).epsilon(kManySteps));
  }
}

TEST_CASE("Default law: shear under constant pressure is Eq 6's rise with the Coulomb peak, then friction") {
  const double pressure = GENERATE(0.0, 0.5, 3.0, 20.0);
  const double normal = -pressure / kLaw.k_t, critical = critical_at(pressure);
  for (const double part : {0.2, 0.6, 0.9}) {
    const double d = part * critical;
    CHECK(at(normal, d).traction_s == Approx(kLaw.k_s * d * std::exp(-part)).epsilon(kManySteps));
    CHECK(at(normal, -d).traction_s == Approx(-kLaw.k_s * d * std::exp(-part)).epsilon(kManySteps));
  }
  CHECK(at(normal, (1 - 1e-7) * critical).traction_s == Approx(peak_at(pressure)).epsilon(kManySteps));
  const PointState after = at(normal, 1.001 * critical);
  CHECK(after.broken == BreakMode::shear);
  CHECK(after.traction_s == Approx(pressure * kLaw.tan_phi).epsilon(kManySteps).margin(kManySteps));
}

TEST_CASE("Default law: shear in compression unloads along k_s") {
  const double normal = -2.0 / kLaw.k_t;
  PointState s = at(normal, 0.7 * critical_at(2.0));
  const double stress = s.traction_s, back = 0.8 * stress / kLaw.k_s, slip = s.slip;
  drive(s, normal, s.shear - back);
  CHECK(s.traction_s == Approx(stress - kLaw.k_s * back).epsilon(kManySteps));
  CHECK(s.slip == slip);
}

TEST_CASE("Default law: a contact pulled apart spends G_f") {
  PointState s;
  double work = 0.0;
  const int steps = 5000;
  for (int i = 1; i <= steps; ++i) {
    const PointState before = s;
    consistent_law::update(s, 1.001 * kLaw.delta_ut * i / steps, 0, kLaw);
    work += 0.5 * (before.traction_n + s.traction_n) * (s.normal - before.normal);
  }
  const double g_f = closed_forms::fracture_energy(kLaw.t_c, kLaw.delta_ct, kLaw.delta_ut);
  CHECK(s.fracture_energy == Approx(g_f).epsilon(1e-3));  // the requirement; 200 steps to the peak give (1/200)^2
  CHECK(work == Approx(g_f).epsilon(1e-3));
  CHECK(consistent_law::recoverable_energy(s, kLaw) == 0.0);
}

TEST_CASE("Default law: the stress is continuous where a contact opens") {
  RandomStream random(1, "continuity");
  const double small = 1e-9 * kLaw.delta_ct;
  for (int i = 0; i < 500; ++i) {
    PointState s;
    for (int leg = 0; leg < 3; ++leg)
      drive(s, random.uniform(-4, 4) * kLaw.delta_ct, random.uniform(-2, 2) * kLaw.delta_cs, 50);
    drive(s, -small, random.uniform(-1, 1) * kLaw.delta_cs, 50);
    PointState open = s;
    consistent_law::update(open, small, s.shear, kLaw);
    // Over 2e-9 delta_ct the steepest slope met, k_t (tan(phi) times it in friction), moves the stress by 4e-8 MPa.
    CHECK(std::abs(open.traction_n - s.traction_n) < 1e-7);
    CHECK(std::abs(open.traction_s - s.traction_s) < 1e-7);
  }
}

TEST_CASE("Default law: damage and spent energies never fall, integrity never grows") {
  RandomStream random(2, "monotony");
  for (int i = 0; i < 300; ++i) {
    PointState s;
    for (int leg = 0; leg < 40; ++leg) {
      const PointState before = s;
      drive(s, random.uniform(-2, 3) * kLaw.delta_ct, random.uniform(-1, 1) * kLaw.delta_cs, 10);
      REQUIRE(s.damage >= before.damage);
      REQUIRE(s.integrity_n <= before.integrity_n);
      REQUIRE(s.integrity_s <= before.integrity_s);
      REQUIRE(s.fracture_energy >= before.fracture_energy);
      REQUIRE(s.friction_energy >= before.friction_energy);
      REQUIRE((before.broken == BreakMode::none || s.broken == before.broken));
    }
  }
}

TEST_CASE("Default law: broken in shear has no tension") {
  PointState s = at(-3.0 / kLaw.k_t, 1.5 * critical_at(3.0));
  drive(s, 0.5 * kLaw.delta_ct, s.shear);
  CHECK(s.traction_n == 0.0);
  CHECK(s.traction_s == 0.0);
}

TEST_CASE("Default law: broken in tension has only friction, with slope k_s below it") {
  PointState s = at(1.01 * kLaw.delta_ut, 0);
  const double pressure = 3.0, limit = pressure * kLaw.tan_phi;
  drive(s, -pressure / kLaw.k_t, 0);
  CHECK(s.traction_n == Approx(-pressure).epsilon(kRounding));
  drive(s, s.normal, 0.5 * limit / kLaw.k_s);
  CHECK(s.traction_s == Approx(0.5 * limit).epsilon(kManySteps));
  const double spent = s.friction_energy;
  drive(s, s.normal, 3.0 * limit / kLaw.k_s);
  CHECK(s.traction_s == Approx(limit).epsilon(kRounding));
  CHECK(s.friction_energy - spent ==
        Approx(limit * 2.0 * limit / kLaw.k_s).epsilon(0.01));  // one step of 80 is partly elastic
  drive(s, s.normal, -3.0 * limit / kLaw.k_s);
  CHECK(s.traction_s == Approx(-limit).epsilon(kRounding));
}

TEST_CASE("Default law: with a fracture energy in shear the cohesion goes linearly over one slip and friction stays") {
  RunConfig config;
  config.contacts.shear_fracture_energy_n_per_mm = 0.2;
  const LawParameters law = law_parameters(config);
  const double slip = (law.kappa_us - 1.0) * law.delta_cs;  // Eq. (D9): the same at every pressure
  const double pressure = GENERATE(0.0, 2.0, 10.0);
  const double normal = -pressure / law.k_t, critical = critical_at(pressure);
  const auto traction_at = [&](double beyond) {
    PointState s;
    consistent_law::update(s, normal, 0.0, law);
    constexpr int kSteps = 4000;
    for (int i = 1; i <= kSteps; ++i) consistent_law::update(s, normal, (critical + beyond * slip) * i / kSteps, law);
    return s;
  };
  for (const double part : {0.25, 0.5, 0.9}) {
    const double expected = (1.0 - part) * law.c_c + pressure * law.tan_phi;
    CHECK(traction_at(part).traction_s == Approx(expected).epsilon(1e-3));  // 4000 steps along the slip
    CHECK(traction_at(part).broken == BreakMode::none);
  }
  CHECK(traction_at(1.01).broken == BreakMode::shear);
  CHECK(traction_at(1.01).traction_s == Approx(pressure * law.tan_phi).epsilon(1e-6).margin(1e-9));
}

TEST_CASE("Default law: the energy that parts a contact in shear without pressure is G_II, Eq. (D9)") {
  RunConfig config;
  config.contacts.shear_fracture_energy_n_per_mm = 0.2;
  const LawParameters law = law_parameters(config);
  PointState s;
  double work = 0.0;
  constexpr int kSteps = 20000;
  for (int i = 1; i <= kSteps; ++i) {
    const double before = s.traction_s, from = s.shear;
    consistent_law::update(s, 0.0, 1.01 * law.kappa_us * law.delta_cs * i / kSteps, law);
    work += 0.5 * (before + s.traction_s) * (s.shear - from);
  }
  CHECK(s.broken == BreakMode::shear);
  CHECK(work == Approx(0.2).epsilon(1e-5));  // trapezoids: (1 / 20000 of the slip)^2 and the last step
  CHECK(s.fracture_energy == Approx(0.2).epsilon(1e-5));
}

TEST_CASE("Default law: a fracture energy in shear below what the contact takes to its peak is refused") {
  RunConfig config;
  config.contacts.shear_fracture_energy_n_per_mm = 1e-3;
  CHECK_THROWS_WITH(law_parameters(config),
                    Catch::Contains("/contacts/shear_fracture_energy_n_per_mm") && Catch::Contains("at least"));
}
