#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>

#include "core/base/random.hpp"
#include "core/contact/closed_forms.hpp"
#include "core/contact/cohesive_frictional_law.hpp"
#include "core/contact/consistent_law.hpp"
#include "core/contact/general_contact.hpp"
#include "core/contact/literal_law.hpp"
#include "core/contact/touch_entry.hpp"

using namespace asperity;

/// What mechanisms change in the law of one contact point: envelope (D10), closure (D11), strength factor (C57).
namespace {

constexpr double kRounding = 1e-12;
constexpr double kManySteps = 1e-10;  // rounding of some hundred steps added up
const LawParameters kLaw = law_parameters(RunConfig{});

/// c_c = 2 MPa, tan(phi_c) = 0.5, exponent 1/2: S(p) = 2 sqrt(1 + p / 2) by hand.
LawParameters square_root_law() {
  LawParameters law = kLaw;
  law.c_c = 2.0;
  law.tan_phi = law.tan_phi_peak = 0.5;
  law.envelope_exponent = 0.5;
  return law;
}

LawParameters curved_law(double exponent = 0.6) {
  LawParameters law = kLaw;
  law.envelope_exponent = exponent;
  return law;
}

LawParameters closing_law(double share = 0.7, double length = 0.002) {
  LawParameters law = kLaw;
  law.closure_share = share;
  law.closure_length = length;
  return law;
}

void drive(PointState& s, double normal, double shear, const LawParameters& law, int steps = 200) {
  const double n0 = s.normal, s0 = s.shear;
  for (int i = 1; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    consistent_law::update(s, n0 + part * (normal - n0), s0 + part * (shear - s0), law);
  }
}

PointState at(double normal, double shear, const LawParameters& law) {
  PointState s;
  drive(s, normal, 0.0, law);
  drive(s, normal, shear, law);
  return s;
}

bool same_bits(const PointState& a, const PointState& b) {
  return std::memcmp(&a, &b, offsetof(PointState, broken)) == 0 && a.broken == b.broken;
}

/// A random walk through opening, closing and shear that breaks about half of the points; sizes over those at the
/// peaks.
struct Walk {
  RandomStream random;
  double normal = 0, shear = 0;
  explicit Walk(std::uint64_t seed) : random(seed, "varied law") {}
  void go_on() {
    normal = kLaw.delta_ct * random.uniform(-1.5, 1.5);
    shear += kLaw.delta_cs * random.uniform(-0.4, 0.5);
  }
};

}  // namespace

TEST_CASE("Eq (D10): strengths by hand, and friction that is the strength without its cohesion") {
  const LawParameters law = square_root_law();
  CHECK(consistent_law::shear_strength(0.0, law) == 2.0);
  CHECK(consistent_law::shear_strength(2.0, law) == Approx(2.0 * std::numbers::sqrt2).epsilon(kRounding));
  CHECK(consistent_law::shear_strength(6.0, law) == Approx(4.0).epsilon(kRounding));
  CHECK(consistent_law::shear_strength(16.0, law) == Approx(6.0).epsilon(kRounding));
  CHECK(consistent_law::friction_limit(1.0, 16.0, law) == Approx(4.0).epsilon(kRounding));
  CHECK(consistent_law::friction_limit(0.25, 6.0, law) == Approx(0.5).epsilon(kRounding));
  CHECK(consistent_law::friction_limit(1.0, 0.0, law) == 0.0);
  LawParameters steep = law;
  steep.tan_phi_peak = 1.0;  // S = 2 sqrt(1 + p)
  steep.friction_share = 0.5;
  CHECK(consistent_law::shear_strength(8.0, steep) == Approx(6.0).epsilon(kRounding));
  CHECK(consistent_law::friction_limit(1.0, 8.0, steep) == Approx(2.0).epsilon(kRounding));
  const double p = 1e-6;
  CHECK((consistent_law::shear_strength(p, law) - 2.0) / p == Approx(0.5).epsilon(1e-5));  // slope tan(phi_c) at p = 0
}

TEST_CASE(
    "Eq (C58): friction of fresh fracture by hand, straight without stress, and as the bonded law's; a joint's is "
    "Coulomb's") {
  const LawParameters law = square_root_law();
  const GeneralContactLaw general = general_contact_law(RunConfig{}, law);
  const SurfaceLaw &outline = general.surfaces[static_cast<int>(SurfaceKind::outline)],
                   &fracture = general.surfaces[static_cast<int>(SurfaceKind::fracture)];
  CHECK(friction_limit(fracture, 3.0, 1.0) == Approx(1.0).epsilon(kRounding));   // 6 MPa: half of 2 sqrt(1 + 3) - 2
  CHECK(friction_limit(fracture, 16.0, 2.0) == Approx(4.0).epsilon(kRounding));  // 16 MPa over 2 mm: half of 2 x 4
  CHECK(friction_limit(fracture, 1e-6, 1.0) == Approx(0.5e-6).epsilon(1e-5));
  CHECK(friction_limit(fracture, 0.0, 1.0) == 0.0);
  for (const double stress : {0.3, 2.0, 30.0})
    CHECK(2.0 * friction_limit(fracture, 0.5 * stress, 1.0) ==
          Approx(consistent_law::friction_limit(1.0, stress, law)).epsilon(1e-9));
  CHECK(friction_limit(outline, 3.0, 1.0) == outline.tan_phi * 3.0);
}

TEST_CASE("Eq (D10): shear peaks at S(p), then falls to friction; a steep straight peak does so too") {
  const double pressure = GENERATE(0.0, 0.5, 3.0, 20.0);
  LawParameters steep = kLaw;
  steep.tan_phi_peak = 1.4;
  for (const LawParameters& law : {curved_law(0.6), curved_law(0.4), steep}) {
    const double normal = -pressure / law.k_t, peak = consistent_law::shear_strength(pressure, law);
    const double critical = std::numbers::e * peak / law.k_s;
    CAPTURE(pressure, law.envelope_exponent, peak);
    CHECK(at(normal, (1 - 1e-7) * critical, law).traction_s == Approx(peak).epsilon(kManySteps));
    for (const double part : {0.2, 0.6}) {
      const double d = part * critical;
      CHECK(at(normal, -d, law).traction_s == Approx(-law.k_s * d * std::exp(-part)).epsilon(kManySteps));
    }
    const PointState after = at(normal, 1.001 * critical, law);
    CHECK(after.broken == BreakMode::shear);
    const double friction = consistent_law::friction_limit(1.0, pressure, law);
    CHECK(after.traction_s == Approx(friction).epsilon(kManySteps).margin(kManySteps));
  }
  CHECK(consistent_law::shear_strength(3.0, steep) == kLaw.c_c + 3.0 * 1.4);
}

TEST_CASE("Eqs (D4), (D10): where shear softens, its slip does not depend on the pressure; the mean is halfway") {
  LawParameters law = curved_law();
  law.kappa_us = 5.0;
  const double slip = (law.kappa_us - 1.0) * law.delta_cs;
  for (const double pressure : {0.0, 1.0, 5.0}) {
    const double normal = -pressure / law.k_t, peak = consistent_law::shear_strength(pressure, law);
    const double critical = std::numbers::e * peak / law.k_s;
    const PointState half = at(normal, critical + 0.5 * slip, law);
    CAPTURE(pressure);
    CHECK(half.damage == Approx(0.5).epsilon(1e-9));
    const double friction = consistent_law::friction_limit(1.0, pressure, law);
    CHECK(half.traction_s == Approx(0.5 * peak + 0.5 * friction).epsilon(1e-4));
    CHECK(at(normal, critical + 0.999 * slip, law).broken == BreakMode::none);
    CHECK(at(normal, critical + 1.001 * slip, law).broken == BreakMode::shear);
  }
}

TEST_CASE("Eq (D11): pressure and energy by hand, the work done, and nothing lost on the way back") {
  const LawParameters law = closing_law();
  const double d = law.closure_length, k = law.k_t;
  CHECK(consistent_law::pressure_at(-d, law) == Approx(0.65 * k * d).epsilon(kRounding));  // u - 0.7 u / 2
  CHECK(consistent_law::pressure_at(-3.0 * d, law) == Approx((3.0 - 0.525) * k * d).epsilon(kRounding));
  CHECK(consistent_law::pressure_at(d, law) == 0.0);
  CHECK(consistent_law::closing_energy(-d, law) ==
        Approx(k * d * d * (0.5 - 0.7 * (1.0 - std::numbers::ln2))).epsilon(kRounding));
  const double u = 1e-7 * d;
  CHECK(consistent_law::pressure_at(-u, law) / u == Approx(0.3 * k).epsilon(1e-6));  // k_0 = (1 - a) k_t
  CHECK((consistent_law::pressure_at(-1e4 * d, law)) / (1e4 * d * k) == Approx(1.0).epsilon(1e-4));

  PointState s;
  double work = 0.0;
  constexpr int kSteps = 4000;
  for (int i = 1; i <= kSteps; ++i) {
    const PointState before = s;
    consistent_law::update(s, -4.0 * d * i / kSteps, 0.0, law);
    work += 0.5 * (before.traction_n + s.traction_n) * (s.normal - before.normal);
  }
  CHECK(s.traction_n == Approx(-k * d * (4.0 - 0.7 * 0.8)).epsilon(kRounding));
  CHECK(consistent_law::recoverable_energy(s, law) == Approx(work).epsilon(1e-6));  // trapezoids: 1 / (12 kSteps^2)
  drive(s, -d, 0.0, law);
  CHECK(s.traction_n == Approx(-0.65 * k * d).epsilon(kRounding));
  CHECK(s.fracture_energy == 0.0);
  CHECK(s.friction_energy == 0.0);
  CHECK(same_bits(at(0.4 * law.delta_ct, 0.0, law), at(0.4 * law.delta_ct, 0.0, kLaw)));  // tension keeps k_t
}

TEST_CASE("exponent 1, closure ratio 1 and factor 1 are the base law bit for bit, along random walks") {
  LawParameters neutral = scaled(kLaw, 1.0);
  neutral.closure_length = 0.002;  // of a closure that misses nothing
  int broken = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Walk walk(seed);
    PointState a, b;
    for (int i = 0; i < 40; ++i) {
      walk.go_on();
      consistent_law::update(a, walk.normal, walk.shear, kLaw);
      consistent_law::update(b, walk.normal, walk.shear, neutral);
      REQUIRE(same_bits(a, b));
    }
    CHECK(consistent_law::recoverable_energy(a, kLaw) == consistent_law::recoverable_energy(b, neutral));
    broken += a.broken != BreakMode::none;
  }
  CHECK(broken > 50);
}

TEST_CASE("Eq (C57): a contact of another strength is similar to the base one under each law") {
  const auto similar = [](auto update, const LawParameters& law, double factor, double tolerance) {
    const LawParameters other = scaled(law, factor);
    CHECK(other.kappa_ut == law.kappa_ut);
    CHECK(other.kappa_us == law.kappa_us);
    CHECK(other.k_t == law.k_t);
    CHECK(other.delta_ut / other.delta_ct == Approx(law.kappa_ut).epsilon(kRounding));
    int broken = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      Walk walk(seed);
      PointState a, b;
      for (int i = 0; i < 40; ++i) {
        walk.go_on();
        update(a, walk.normal, walk.shear, law);
        update(b, factor * walk.normal, factor * walk.shear, other);
        REQUIRE(b.broken == a.broken);
        REQUIRE(b.traction_n == Approx(factor * a.traction_n).epsilon(tolerance).margin(tolerance));
        REQUIRE(b.traction_s == Approx(factor * a.traction_s).epsilon(tolerance).margin(tolerance));
        REQUIRE(b.fracture_energy == Approx(factor * factor * a.fracture_energy).epsilon(tolerance).margin(tolerance));
      }
      broken += a.broken != BreakMode::none;
    }
    CHECK(broken > 20);
  };
  for (const double factor : {2.0, 0.3}) {
    const double tolerance = factor == 2.0 ? 0.0 : 1e-9;  // a factor of 2 rounds nothing
    CAPTURE(factor);
    similar([](auto& s, double n, double t, auto& p) { consistent_law::update(s, n, t, p); }, kLaw, factor, tolerance);
    similar([](auto& s, double n, double t, auto& p) { consistent_law::update(s, n, t, p); }, curved_law(), factor,
            tolerance);
    similar([](auto& s, double n, double t, auto& p) { cohesive_frictional_law::update(s, n, t, p); }, kLaw, factor,
            tolerance);
    similar([](auto& s, double n, double t, auto& p) { literal_law::update(s, n, t, p); }, kLaw, factor, tolerance);
  }
}
