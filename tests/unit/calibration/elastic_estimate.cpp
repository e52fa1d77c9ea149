#include "core/calibration/elastic_estimate.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/units.hpp"
#include "core/calibration/assembly_elasticity.hpp"
#include "core/calibration/contact_stiffness.hpp"
#include "core/calibration/elastic_compensation.hpp"
#include "core/contact/consistent_law.hpp"
#include "tests/unit/calibration/lattice.hpp"
#include "tests/unit/calibration/plaster.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

constexpr double kRounding = 1e-12;
const PlaneCondition kPlanes[] = {PlaneCondition::stress, PlaneCondition::strain};

/// E and nu between triangles of the lattice one period apart.
Elasticity lattice_elasticity(const Elasticity& particle, const ContactStiffness& contacts, PlaneCondition plane) {
  constexpr double kStress = 1e-3;  // MPa: strains of 1e-6
  const Lattice lattice(8, 10, 2.0);
  ParticleConfig config;
  config.youngs_modulus_gpa = 1e-3 * particle.youngs_modulus;
  config.poissons_ratio = particle.poissons_ratio;
  LawParameters law;
  law.k_t = contacts.k_t;
  law.k_s = contacts.k_s();
  const System system = compressed(lattice, config, plane, law, kStress);
  const auto moved = [&](int row, int i) { return displacement(system, lattice.upright(row, i)); };
  const double axial = (moved(2, 3).y - moved(6, 3).y) / (4 * lattice.row_height());
  const double lateral = (moved(4, 5).x - moved(4, 2).x) / (3 * 2.0);
  return material_elasticity({kStress / axial, lateral / axial}, plane);
}

}  // namespace

TEST_CASE("plane and material elasticity are each other's inverse, with the textbook's plane-strain values") {
  const Elasticity strain = plane_elasticity({1300, 0.2}, PlaneCondition::strain);
  CHECK(strain.youngs_modulus == Approx(1300 / 0.96));
  CHECK(strain.poissons_ratio == Approx(0.25));
  for (double nu : {-0.3, 0.0, 0.2, 0.45}) {
    const Elasticity back =
        material_elasticity(plane_elasticity({1300, nu}, PlaneCondition::strain), PlaneCondition::strain);
    CHECK(back.youngs_modulus == Approx(1300).epsilon(kRounding));
    CHECK(back.poissons_ratio == Approx(nu).margin(kRounding));
  }
}

TEST_CASE("the closed form is the elastic solution of equilateral triangles") {
  constexpr double kHold = 1e-4;  // rigid motion is held with 1e-7 of a node's stiffness, felt over ten rows
  for (PlaneCondition plane : kPlanes) {
    for (double k_t : {500.0, 2600.0, 13000.0}) {
      for (double ratio : {0.15, 0.28, 1.0}) {
        CAPTURE(k_t, ratio, static_cast<int>(plane));
        const Elasticity particle{2000, 0.13};
        const Elasticity told = estimate_assembly(particle, {k_t, ratio}, 2.0, plane);
        const Elasticity solved = lattice_elasticity(particle, {k_t, ratio}, plane);
        CHECK(solved.youngs_modulus == Approx(told.youngs_modulus).epsilon(kHold));
        CHECK(solved.poissons_ratio == Approx(told.poissons_ratio).margin(kHold));
      }
    }
  }
}

TEST_CASE("particles found by the closed form make the target") {
  for (PlaneCondition plane : kPlanes) {
    const ContactStiffness contacts{6500, 0.28};
    const Elasticity particle = estimate_particle({1300, 0.2}, contacts, 2.0, plane);
    const Elasticity assembly = estimate_assembly(particle, contacts, 2.0, plane);
    CHECK(assembly.youngs_modulus == Approx(1300).epsilon(kRounding));
    CHECK(assembly.poissons_ratio == Approx(0.2).epsilon(kRounding));
  }
}

TEST_CASE("with the ratio found, particles of the given Poisson's ratio make the target") {
  for (PlaneCondition plane : kPlanes) {
    for (double nu : {0.0, 0.1, 0.35}) {
      const double ratio = estimate_stiffness_ratio({1300, 0.2}, nu, 5200, 2.0, plane);
      const Elasticity particle = estimate_particle({1300, 0.2}, {5200, ratio}, 2.0, plane);
      CHECK(particle.poissons_ratio == Approx(nu).margin(kRounding));
    }
  }
}

TEST_CASE("the audit's two cases: Eq 13 at 2 mm needs a negative nu_p, at 1 mm no E_p is enough") {
  const ContactStiffness eq13{2608, 0.279};
  CHECK(estimate_particle({1300, 0.2}, eq13, 2.0, PlaneCondition::strain).poissons_ratio < -0.15);
  CHECK(estimate_particle({1300, 0.2}, eq13, 1.0, PlaneCondition::strain).youngs_modulus < 0.0);
  // sqrt(3) E' / (1 - nu') over the edge: 3127 N/mm2 by hand
  CHECK(least_stiffness({1300, 0.2}, 2.0, PlaneCondition::strain) == Approx(3127.3 / 2).epsilon(1e-4));
  CHECK(least_stiffness({1300, 0.2}, 1.0, PlaneCondition::strain) > eq13.k_t);
}

TEST_CASE(
    "below the least stiffness rigid particles with any ratio stay too compliant, above it one reaches the target") {
  for (PlaneCondition plane : kPlanes) {
    const double least = least_stiffness({1300, 0.2}, 2.0, plane);
    for (double nu : {0.0, 0.2, 0.35}) {
      const auto modulus = [&](double k_t) {
        const double ratio = estimate_stiffness_ratio({1300, 0.2}, nu, k_t, 2.0, plane);
        return estimate_particle({1300, 0.2}, {k_t, ratio}, 2.0, plane).youngs_modulus;
      };
      CHECK(modulus(1.01 * least) > 0.0);
      CHECK(modulus(0.99 * least) < 0.0);
    }
  }
}

TEST_CASE("hardening is none at no stress or endless cohesion, and grows with the stress") {
  CHECK(shear_hardening({0, 0}, 1.7, 0.8) == 1.0);
  CHECK(shear_hardening({1.5, 3.75}, 1e6, 0.8) == Approx(1.0).epsilon(1e-5));
  // To first order x = y + y^2, so that the mean of s c (y + y^2) e c_c over directions is h / 8 + h^2 <s^3 c^3> / (e
  // c_c) with <s^3 c^3> = 1 / (6 pi).
  const double first_order = 8.0 / (6.0 * std::numbers::pi) * 0.02 / std::numbers::e;
  CHECK(shear_hardening({0.0, 0.02}, 1.0, 0.0) - 1.0 == Approx(first_order).epsilon(0.02));
  CHECK(shear_hardening({1.5, 3.75}, 1.7, 0.78) > shear_hardening({1.0, 2.5}, 1.7, 0.78));
  CHECK(shear_hardening({1.5, 3.75}, 1.7, 0.0) > shear_hardening({1.5, 3.75}, 1.7, 0.78));
}

TEST_CASE("hardening with friction is that of the law's own contact points over all directions") {
  constexpr int kDirections = 40, kSteps = 2000;
  LawParameters law;
  law.k_t = law.k_s = 1e3;
  law.c_c = 1.7;
  law.tan_phi = law.tan_phi_peak = 0.78;
  law.kappa_ut = 10;
  law.inverse_delta_ct = 1e-3;
  const StressWindow window{1.5, 3.75};
  double mean = 0.0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 0.5 * std::numbers::pi * (i + 0.5) / kDirections;
    const double s = std::sin(angle), c = std::cos(angle);
    PointState point;
    double low = 0.0;
    for (int k = 1; k <= kSteps; ++k) {
      const double stress = window.high * k / kSteps;
      // The shear displacement that carries the stress's share, by the secant from the elastic guess.
      double shear = point.shear + (stress * s * c - point.traction_s) / law.k_s;
      PointState next;
      for (int n = 0; n < 30; ++n) {
        next = point;
        consistent_law::update(next, -stress * c * c / law.k_t, shear, law);
        shear += (stress * s * c - next.traction_s) / law.k_s;
      }
      point = next;
      if (stress <= window.low) low = point.shear;
    }
    mean += law.k_s * (point.shear - low) * s * c / kDirections;
  }
  const double told = shear_hardening(window, law.c_c, law.tan_phi);
  CHECK(told == Approx(8.0 * mean / (window.high - window.low)).epsilon(2e-3));  // steps of 0.05 % along the law
}

TEST_CASE("irregular specimens are within 2 % of the closed form in E, and in nu the nearer the finer they are") {
  // The regular lattice is exact; what is left is the scatter of lengths and directions, and the outline: the flanks'
  // gauges span the width, whose outermost edges are no contacts.
  for (PlaneCondition plane : kPlanes) {
    for (double multiple : {3.0, 10.0, 40.0}) {
      ElasticTask task = coarse_task(plane);
      task.reading = ElasticReading::initial;
      const auto miss = [&](double edge) {
        task.config.particles.edge_mm = edge;
        const ContactStiffness contacts{multiple * 1300 / edge, 0.279};
        const Elasticity told = estimate_assembly({2000, 0.15}, contacts, edge, plane);
        const Elasticity read = mean_elasticity(read_specimens(task, {2000, 0.15}, contacts));
        CAPTURE(multiple, edge, static_cast<int>(plane), told.poissons_ratio, read.poissons_ratio);
        CHECK(read.youngs_modulus == Approx(told.youngs_modulus).epsilon(0.02));
        return std::abs(read.poissons_ratio - told.poissons_ratio);
      };
      CHECK(miss(6.0) < 0.02);
      CHECK(miss(3.0) < 0.01);
    }
  }
}

TEST_CASE("with hardening the closed form tells the window's E within 2 % and nu as near as without") {
  for (double cohesion : {1.2, 1.7, 3.0}) {
    ElasticTask task = coarse_task(PlaneCondition::strain);
    task.config.contacts.cohesion_mpa = cohesion;
    const double edge = task.config.particles.edge_mm;
    const double m = shear_hardening(modulus_window(task.config, 7.5), cohesion, std::tan(38 * units::kRadPerDeg));
    const ContactStiffness contacts{10 * 1300 / edge, 0.279};
    const Elasticity told =
        estimate_assembly({2000, 0.15}, {contacts.k_t, contacts.ratio / m}, edge, PlaneCondition::strain);
    const Elasticity read = mean_elasticity(read_specimens(task, {2000, 0.15}, contacts));
    CAPTURE(cohesion, m);
    CHECK(read.youngs_modulus == Approx(told.youngs_modulus).epsilon(0.02));
    CHECK(read.poissons_ratio == Approx(told.poissons_ratio).margin(0.015));
  }
}
