#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/base/random.hpp"
#include "core/contact/cohesive_frictional_law.hpp"
#include "core/contact/consistent_law.hpp"
#include "core/contact/literal_law.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

constexpr int kPaths = 4000;
const LawParameters kLaw = law_parameters(test::plaster());
/// What it takes to bring a virgin contact to both peaks: a path's energies are judged against it, N/mm.
const double kPeakEnergy = kLaw.t_c * kLaw.delta_ct + kLaw.c_c * kLaw.delta_cs;

/// The same with shear that softens over as much energy as the paper's K_IIC gives for it, half of G_f's order.
LawParameters softening_law() {
  LawParameters law = kLaw;
  law.kappa_us = 12.0;
  return law;
}

using Update = void (*)(PointState&, double, double, const LawParameters&);

/// Corners of a random closed path: from rest, to the same place back. Sizes from a hundredth of the peak's
/// displacement to many times it (beyond the ultimate one for some), in closing up to 20 MPa.
std::vector<Vec2> random_path(RandomStream& random) {
  std::vector<Vec2> corners{{0, 0}};
  const double open = kLaw.delta_ct * std::pow(10.0, random.uniform(-2.0, 1.6));
  const double close = 20.0 / kLaw.k_t * std::pow(10.0, random.uniform(-2.0, 0.0));
  const double slide = kLaw.delta_cs * std::pow(10.0, random.uniform(-2.0, 0.5));
  const int legs = 2 + static_cast<int>(random.below(8));
  for (int i = 0; i < legs; ++i) {
    const bool keeps_normal = i > 0 && random.uniform()<0.3, keeps_shear = i> 0 && random.uniform() < 0.3;
    const Vec2 target{random.uniform(-close, open), random.uniform(-slide, slide)};
    corners.push_back({keeps_normal ? corners.back().x : target.x, keeps_shear ? corners.back().y : target.y});
  }
  corners.push_back({0, 0});
  return corners;
}

/// Net work (trapezoids) done on a contact along a path, each leg in so many steps.
double work_along(const std::vector<Vec2>& corners, int steps, Update update, PointState& s,
                  const LawParameters& law = kLaw) {
  double work = 0.0;
  for (std::size_t leg = 1; leg < corners.size(); ++leg) {
    for (int i = 1; i <= steps; ++i) {
      const PointState before = s;
      const Vec2 d = corners[leg - 1] + (static_cast<double>(i) / steps) * (corners[leg] - corners[leg - 1]);
      update(s, d.x, d.y, law);
      work += 0.5 * (before.traction_n + s.traction_n) * (s.normal - before.normal);
      work += 0.5 * (before.traction_s + s.traction_s) * (s.shear - before.shear);
    }
  }
  return work;
}

struct Worst {
  double least_work = std::numeric_limits<double>::infinity(), imbalance = 0, mean_imbalance = 0;
};

Worst worst_of_many(int steps, Update update, const LawParameters& law = kLaw) {
  RandomStream random(11, "closed paths");
  Worst worst;
  for (int i = 0; i < kPaths; ++i) {
    PointState s;
    const double work = work_along(random_path(random), steps, update, s, law);
    const double stored = consistent_law::recoverable_energy(s, law);
    const double imbalance = std::abs(work - stored - s.fracture_energy - s.friction_energy);
    const double scale = kPeakEnergy + std::abs(work);
    worst.least_work = std::min(worst.least_work, work / kPeakEnergy);
    worst.imbalance = std::max(worst.imbalance, imbalance / scale);
    worst.mean_imbalance += imbalance / scale / kPaths;
  }
  return worst;
}

}  // namespace

TEST_CASE("Default law: no closed path from the virgin state returns net work, and the account closes") {
  const Worst coarse = worst_of_many(250, consistent_law::update), fine = worst_of_many(1000, consistent_law::update);
  WARN("closed paths: least work " << fine.least_work << " of the peak energy; imbalance worst " << coarse.imbalance
                                   << " -> " << fine.imbalance << ", mean " << coarse.mean_imbalance << " -> "
                                   << fine.mean_imbalance << " from 250 to 1000 steps a leg");
  // Trapezoids miss the work of smooth legs by (step / delta_c)^2 / 12 of the peak energy: largest legs are 40
  // delta_ct, so (40 / 1000)^2 / 12 = 1.3e-4 of it.
  CHECK(fine.least_work > -1.3e-4);
  CHECK(fine.imbalance < 1.3e-4);
  CHECK(fine.mean_imbalance < 0.1 * coarse.mean_imbalance);  // 1/16 for second order: it is discretisation, not the law
}

TEST_CASE("Default law with softening in shear: no closed path returns net work either, and the account closes") {
  const Worst fine = worst_of_many(1000, consistent_law::update, softening_law());
  WARN("closed paths, shear softens: least work " << fine.least_work << " of the peak energy; imbalance worst "
                                                  << fine.imbalance << ", mean " << fine.mean_imbalance);
  CHECK(fine.least_work > -1.3e-4);  // the discretisation's, as above
  CHECK(fine.imbalance < 1.3e-4);
}

TEST_CASE(
    "Default law with a curved envelope, closing cracks or both: no closed path returns net work, and the account "
    "closes") {
  LawParameters curved = kLaw, closing = kLaw;
  curved.envelope_exponent = 0.6;
  closing.closure_share = 0.7;
  closing.closure_length = 0.002;
  LawParameters both = closing;
  both.envelope_exponent = 0.4;
  both.kappa_us = 12.0;
  LawParameters steep = kLaw;
  steep.tan_phi_peak = 1.4;
  for (const LawParameters& law : {curved, closing, both, steep}) {
    const Worst fine = worst_of_many(1000, consistent_law::update, law);
    CAPTURE(law.envelope_exponent, law.closure_share, law.tan_phi_peak);
    WARN("closed paths, exponent " << law.envelope_exponent << ", closure " << law.closure_share << ", peak slope "
                                   << law.tan_phi_peak << ": least work " << fine.least_work
                                   << " of the peak energy; imbalance worst " << fine.imbalance << ", mean "
                                   << fine.mean_imbalance);
    CHECK(fine.least_work > -1.3e-4);  // the discretisation's, as above
    CHECK(fine.imbalance < 1.3e-4);
  }
}

TEST_CASE("Cohesive-frictional form: no closed path returns net work, with Eq 6's drop or softening in shear") {
  LawParameters law = kLaw;
  law.kappa_us = GENERATE(1.0, 12.0);
  const Worst coarse = worst_of_many(250, cohesive_frictional_law::update, law),
              fine = worst_of_many(1000, cohesive_frictional_law::update, law);
  WARN("closed paths, cohesive-frictional, kappa_us "
       << law.kappa_us << ": least work " << fine.least_work << " of the peak energy; imbalance worst "
       << coarse.imbalance << " -> " << fine.imbalance << ", mean " << coarse.mean_imbalance << " -> "
       << fine.mean_imbalance << " from 250 to 1000 steps a leg");
  CHECK(fine.least_work > -1.3e-4);  // the discretisation's, as above
  CHECK(fine.imbalance < 1.3e-4);
  CHECK(fine.mean_imbalance < 0.1 * coarse.mean_imbalance);
}

TEST_CASE("Literal law: some closed path returns net work, so the test above can fail") {
  RandomStream random(11, "closed paths");
  double least = 0.0;
  for (int i = 0; i < kPaths; ++i) {
    PointState s;
    const double work = work_along(random_path(random), 250, literal_law::update, s);
    least = std::min(least, work / kPeakEnergy);
  }
  WARN("literal law: least work of " << kPaths << " closed paths " << least << " of the peak energy");
  CHECK(least < -0.05);  // (k_t - k_s) delta_ct^2 / 2 is of the order of the peak energy itself
}
