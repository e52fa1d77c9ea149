#include <catch2/catch.hpp>
#include <cmath>

#include "core/contact/closed_forms.hpp"
#include "core/contact/literal_law.hpp"

using namespace asperity;

namespace {

constexpr double kRounding = 1e-12;
const LawParameters kLaw = law_parameters(RunConfig{});

void drive(PointState& s, double normal, double shear, const LawParameters& law = kLaw, int steps = 200) {
  const double n0 = s.normal, s0 = s.shear;
  for (int i = 1; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    literal_law::update(s, n0 + part * (normal - n0), s0 + part * (shear - s0), law);
  }
}

PointState at(double normal, double shear, const LawParameters& law = kLaw) {
  PointState s;
  drive(s, normal, 0.0, law);
  drive(s, normal, shear, law);
  return s;
}

}  // namespace

TEST_CASE("Literal law: Eq 3's virgin curve") {
  for (const double part : {0.1, 0.5, 0.9, 1.0}) {
    const double d = part * kLaw.delta_ct;
    CHECK(at(d, 0).traction_n == Approx(kLaw.k_t * d * std::exp(-part)).epsilon(kRounding));
  }
  CHECK(at(kLaw.delta_ct, 0).traction_n == Approx(kLaw.t_c).epsilon(kRounding));
  for (const double damage : {0.25, 0.5, 0.9}) {
    const PointState s = at(kLaw.delta_ct + damage * (kLaw.delta_ut - kLaw.delta_ct), 0);
    CHECK(s.traction_n == Approx(kLaw.t_c * (1 - damage)).epsilon(kRounding));
    CHECK(s.damage == Approx(damage).epsilon(kRounding));
  }
  const PointState gone = at(1.01 * kLaw.delta_ut, 0);
  CHECK(gone.traction_n == 0.0);
  CHECK(gone.broken == BreakMode::tension);
}

TEST_CASE("Literal law: Eq 2's effective displacement and Eq 9's components") {
  const double d = 0.5 * kLaw.delta_ct;
  const PointState s = at(0.6 * d, 0.8 * d);
  const double stress = kLaw.k_t * d * std::exp(-0.5);
  CHECK(s.traction_n == Approx(0.6 * stress).epsilon(kRounding));
  CHECK(s.traction_s == Approx(0.8 * stress).epsilon(kRounding));
}

TEST_CASE("Literal law: Fig. 3a, hardening is elastic and softening unloads along the secant") {
  PointState s = at(0.9 * kLaw.delta_ct, 0);
  drive(s, 0.4 * kLaw.delta_ct, 0);
  CHECK(s.traction_n == Approx(0.4 * kLaw.k_t * kLaw.delta_ct * std::exp(-0.4)).epsilon(kRounding));
  const double largest = 0.5 * (kLaw.delta_ct + kLaw.delta_ut), secant = 0.5 * kLaw.t_c / largest;
  s = at(largest, 0);
  for (const double part : {0.7, 0.2, 0.5, 0.99}) {
    drive(s, part * largest, 0);
    CHECK(s.traction_n == Approx(secant * part * largest).epsilon(kRounding));
  }
  drive(s, kLaw.delta_ct + 0.75 * (kLaw.delta_ut - kLaw.delta_ct), 0);
  CHECK(s.traction_n == Approx(0.25 * kLaw.t_c).epsilon(kRounding));
}

TEST_CASE("Literal law: pulling apart spends G_f") {
  // Steps of delta_ut / 5000: the energies are exact on straight pieces, the step that passes delta_ct costs (1/200)^2.
  PointState s;
  drive(s, 1.001 * kLaw.delta_ut, 0, kLaw, 5000);
  CHECK(s.fracture_energy ==
        Approx(closed_forms::fracture_energy(kLaw.t_c, kLaw.delta_ct, kLaw.delta_ut)).epsilon(1e-3));
}

TEST_CASE("Literal law: Eq 6 peaks at c_c whatever the pressure and drops or jumps to friction") {
  const double pressure = GENERATE(0.5, 3.0, 20.0);
  const double normal = -pressure / kLaw.k_t;
  CHECK(at(normal, 0.5 * kLaw.delta_cs).traction_s ==
        Approx(0.5 * kLaw.k_s * kLaw.delta_cs * std::exp(-0.5)).epsilon(kRounding));
  // A millionth short of the peak: flat there, so 1e-12 off.
  CHECK(at(normal, (1 - 1e-6) * kLaw.delta_cs).traction_s == Approx(kLaw.c_c).epsilon(1e-11));
  const PointState after = at(normal, 1.01 * kLaw.delta_cs);
  CHECK(after.traction_s == Approx(pressure * kLaw.tan_phi).epsilon(kRounding));
  CHECK(after.broken == BreakMode::shear);
  CHECK((after.traction_s > kLaw.c_c) == (pressure == 20.0));  // 14.8 MPa: the stress jumps upwards
}

TEST_CASE("Literal law: Eq 8 unloads along k_s after the drop and slides back at friction") {
  const double pressure = 3.0, limit = pressure * kLaw.tan_phi;
  PointState s = at(-pressure / kLaw.k_t, 1.5 * kLaw.delta_cs);
  const double back = 0.5 * limit / kLaw.k_s, start = s.shear;
  drive(s, s.normal, start - back);
  CHECK(s.traction_s == Approx(limit - kLaw.k_s * back).epsilon(1e-10));  // 200 steps of rounding
  drive(s, s.normal, start - 5.0 * limit / kLaw.k_s);
  CHECK(s.traction_s == Approx(-limit).epsilon(kRounding));
}

TEST_CASE("Literal law: opening and closing with sliding creates (k_t - k_s) delta_s^2 / 2") {
  const double slide = 1e-4 * kLaw.delta_ct, gain = 0.5 * (kLaw.k_t - kLaw.k_s) * slide * slide;
  PointState s = at(-1e-9 * kLaw.delta_ct, slide);
  drive(s, 0.0, slide);
  CHECK(s.created_energy == Approx(gain).epsilon(1e-3));  // linear limit: exp(-1e-4) differs from 1 by 1e-4
  drive(s, 0.0, 0.0);
  drive(s, -1e-9 * kLaw.delta_ct, 0.0);
  CHECK(s.created_energy == Approx(gain).epsilon(1e-3));  // going back elsewhere does not lose it
  PointState there_and_back = at(-1e-9 * kLaw.delta_ct, slide);
  drive(there_and_back, 0.0, slide);
  drive(there_and_back, -1e-9 * kLaw.delta_ct, slide);
  CHECK(std::abs(there_and_back.created_energy) < 1e-3 * gain);  // at the same slip it does
}

TEST_CASE("Literal law: the departure `opening shear k_s` has no such gain") {
  LawParameters law = kLaw;
  law.opening_shear = law.k_s / law.k_t;
  const double slide = 1e-4 * law.delta_ct;
  PointState s = at(-1e-9 * law.delta_ct, slide, law);
  drive(s, 0.0, slide, law);
  CHECK(std::abs(s.created_energy) < 1e-3 * 0.5 * law.k_t * slide * slide);  // the exponentials differ by 1e-4
  CHECK(s.traction_s == Approx(law.k_s * slide * std::exp(-1e-4)).epsilon(kRounding));
}

TEST_CASE("Literal law: the departure `Coulomb peak` adds sigma_n tan(phi_c)") {
  LawParameters law = kLaw;
  law.coulomb = law.tan_phi;
  const double pressure = 3.0, peak = law.c_c + pressure * law.tan_phi;
  const double critical = closed_forms::critical_displacement(peak, law.k_s);
  CHECK(at(-pressure / law.k_t, (1 - 1e-6) * critical, law).traction_s == Approx(peak).epsilon(1e-11));
  CHECK(at(-pressure / law.k_t, 1.01 * critical, law).traction_s == Approx(pressure * law.tan_phi).epsilon(kRounding));
}
