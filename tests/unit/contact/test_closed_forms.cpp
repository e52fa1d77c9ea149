#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/error.hpp"
#include "core/contact/closed_forms.hpp"

using namespace asperity;
using namespace asperity::closed_forms;

namespace {

const MaterialConfig kPlaster;  // Sect. 3.1: E 1.3 GPa, nu 0.2, K_IC 0.9, K_IIC 1.1 MPa m^0.5, sigma_t 1.6 MPa
constexpr double kRounding = 1e-12;

/// The printed Table 7, rows m = 8 ... 12, columns n = 13 ... 18.
constexpr double kTable7[5][6] = {{0.30, 0.29, 0.28, 0.27, 0.26, 0.26},
                                  {0.28, 0.27, 0.26, 0.25, 0.25, 0.24},
                                  {0.26, 0.25, 0.24, 0.24, 0.23, 0.22},
                                  {0.25, 0.24, 0.23, 0.22, 0.22, 0.21},
                                  {0.24, 0.23, 0.22, 0.21, 0.21, 0.20}};

}  // namespace

TEST_CASE("Eqs 12 and 13 give the paper's stiffnesses") {
  // Half a unit in the last of the five digits that the audit's hand calculation has.
  CHECK(tensile_stiffness(kPlaster, PlaneCondition::stress) == Approx(2503.7).margin(0.05));
  CHECK(shear_stiffness(kPlaster, PlaneCondition::stress) == Approx(698.35).margin(0.005));
  CHECK(tensile_stiffness(kPlaster, PlaneCondition::strain) == Approx(2608.0).margin(0.05));
  CHECK(shear_stiffness(kPlaster, PlaneCondition::strain) == Approx(727.44).margin(0.005));
}

TEST_CASE("Eq 14 agrees with Eq 12 when inverted, and not as printed") {
  const double ratio =
      shear_stiffness(kPlaster, PlaneCondition::stress) / tensile_stiffness(kPlaster, PlaneCondition::stress);
  CHECK(stiffness_ratio(kPlaster) == Approx(ratio).epsilon(kRounding));
  CHECK(stiffness_ratio(kPlaster) == Approx(0.279).margin(0.0005));             // three digits in the audit
  CHECK(stiffness_ratio_as_printed(kPlaster) == Approx(0.622).margin(0.0005));  // three digits in the paper
}

TEST_CASE("Critical and ultimate displacements of Table 5") {
  const DerivedParameters d = derive(RunConfig{}, PlaneCondition::stress);
  CHECK(d.g_f == Approx(0.623).margin(0.0005));  // K_IC^2 / E = 810 / 1300, three digits
  CHECK(d.delta_ct == Approx(0.0075).margin(0.00005));
  CHECK(d.delta_ut == Approx(0.178).margin(0.0005));
  CHECK(d.delta_cs == Approx(std::exp(1.0) * 5.02 / d.k_s).epsilon(kRounding));
  CHECK(d.w == Approx(1300.0 / d.k_t).epsilon(kRounding));  // Eq 11: k_t = E / w in plane stress
}

TEST_CASE("Eq 10 and its inverse") {
  for (const double delta_ut : {0.02, 0.178, 3.0}) {
    const double g_f = fracture_energy(6.89, 0.0075, delta_ut);
    CHECK(ultimate_tensile_displacement(6.89, 0.0075, g_f) == Approx(delta_ut).epsilon(kRounding));
  }
  // Its first term is the area under Eq 3's hardening curve: midpoint rule of 2000 intervals, error (1/2000)^2 / 24 k
  // t.
  double area = 0.0;
  for (int i = 0; i < 2000; ++i) area += (i + 0.5) / 2000 * std::exp(1.0 - (i + 0.5) / 2000) / 2000;
  CHECK(fracture_energy(1.0, 1.0, 1.0) == Approx(area).epsilon(1e-6));
}

TEST_CASE("Effective modulus") {
  CHECK(effective_modulus(1300.0, 0.2, PlaneCondition::stress) == 1300.0);
  CHECK(effective_modulus(1300.0, 0.2, PlaneCondition::strain) == Approx(1300.0 / 0.96).epsilon(kRounding));
}

TEST_CASE("Eq 33 and Table 7") {
  double sum = 0.0;
  for (int m = 8; m <= 12; ++m) {
    for (int n = 13; n <= 18; ++n) {
      CHECK(beta(m, n) ==
            Approx(kTable7[m - 8][n - 13]).margin(0.006));  // printed to 0.01, a few of them cut, not rounded
      sum += beta(m, n);
    }
  }
  CHECK(sum / 30 == Approx(0.244).margin(0.0005));
}

TEST_CASE("Lennard-Jones: depth, zero, equilibrium and peak, Eqs 20-25") {
  const int m = GENERATE(6, 8, 12);
  const int n = GENERATE(13, 16, 18);
  const double x0 = equilibrium_separation(m, n), xm = peak_force_separation(m, n), h = 1e-5;
  const auto psi = [&](double x) { return lennard_jones_potential(x, 1.0, 1.0, m, n); };
  const auto force = [&](double x) { return lennard_jones_force(x, 1.0, 1.0, m, n); };
  CHECK(psi(1.0) == Approx(0.0).margin(kRounding));
  CHECK(psi(x0) == Approx(-1.0).epsilon(kRounding));
  CHECK(force(x0) == Approx(0.0).margin(1e-11));  // a difference of two terms of size alpha n < 100
  // Central differences: h^2 n^3 / 6 = 1e-7 of truncation.
  CHECK((psi(x0 * 1.1 + h) - psi(x0 * 1.1 - h)) / (2 * h) == Approx(force(x0 * 1.1)).epsilon(1e-6));
  CHECK((force(xm + h) - force(xm - h)) / (2 * h) == Approx(0.0).margin(1e-6));
  CHECK(force(xm) > force(0.99 * xm));
  CHECK(force(xm) > force(1.01 * xm));
  CHECK(cohesive_force(m, n) == Approx(force(xm)).epsilon(kRounding));
}

TEST_CASE("beta of Eq 33 follows from Eqs 24-32") {
  const int m = GENERATE(8, 10, 12);
  const int n = GENERATE(13, 18);
  // Eqs 27, 30: sigma_t = gamma P_c / x0^2, G_f = 3 gamma w eps / x0^3, so w = (G_f / sigma_t) x0 P_c / (3 eps) and, by
  // Eq 32, beta = eps / (x0 P_c).
  CHECK(beta(m, n) == Approx(1.0 / (equilibrium_separation(m, n) * cohesive_force(m, n))).epsilon(kRounding));
  CHECK(cohesive_zone_thickness(0.6, 1.6, beta(m, n)) == Approx(0.6 / (1.6 * 3.0 * beta(m, n))).epsilon(kRounding));
}

TEST_CASE("A fracture energy without room for softening is the config's fault") {
  RunConfig config;
  config.contacts.fracture_energy_n_per_mm = 0.01;
  CHECK_THROWS_AS(law_parameters(config), Error);
}

TEST_CASE("the chain of Eqs 26 to 32 leads from the potential back to the thickness it started with") {
  using namespace asperity::closed_forms;
  const double gamma = 0.3, w = 0.5, zeta = 2e-7, epsilon = 3e-18;
  for (const auto& [m, n] : {std::pair{6, 12}, {8, 13}, {12, 18}}) {
    const double x_0 = zeta * equilibrium_separation(m, n);
    const double p_c = cohesive_force(m, n) * epsilon / zeta;
    CHECK(bond_energy(epsilon, zeta, m, n) == Approx(epsilon));
    CHECK(bond_density(gamma, x_0) == Approx(3 * gamma / std::pow(x_0, 3)));
    CHECK(bonds_in_zone(gamma, w, 4.0, x_0) == Approx(4.0 * w * bond_density(gamma, x_0)));
    const double g_f = bond_fracture_energy(gamma, w, epsilon, x_0);
    CHECK(bond_fracture_energy_from_force(gamma, w, zeta, p_c, m, n) == Approx(g_f));
    CHECK(cohesive_zone_thickness(g_f, bond_strength(gamma, p_c, x_0), beta(m, n)) == Approx(w));
  }
}
