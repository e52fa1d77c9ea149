#include "core/measurement/crack_stresses.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace asperity;

namespace {

/// A specimen of E' = 2 GPa and nu' = 0.25 that dilates from a deviator on: lateral strain grows by k (q - q_i)^2 above
/// what is elastic.
struct Specimen {
  std::vector<double> path, stress, axial, lateral;
  CompressionColumns columns() const { return {path, {stress, axial, lateral}}; }
};

constexpr double kModulus = 2000.0, kRatio = 0.25, kOnset = 8.0, kGrowth = 1e-5;  // MPa, -, MPa, 1/MPa2

void add_row(Specimen& s, double deviator, double confining) {
  const double beyond = std::max(0.0, deviator - kOnset);
  s.axial.push_back(deviator / kModulus);
  s.path.push_back(1.1 * s.axial.back());
  s.stress.push_back(confining + deviator);
  s.lateral.push_back(kRatio * deviator / kModulus + kGrowth * beyond * beyond);
}

Specimen loaded_to(double deviator, double confining) {
  Specimen s;
  for (double q = 0.0; q <= deviator + 1e-9; q += 0.01) add_row(s, q, confining);
  return s;
}

}  // namespace

TEST_CASE("Crack initiation and damage of a specimen that dilates by a known law") {
  for (const double confining : {0.0, 3.0}) {
    const Specimen s = loaded_to(32.0, confining);
    const auto found = crack_stresses(s.columns(), s.stress.size() - 1, {confining + 2.0, confining + 6.0}, confining);
    REQUIRE(found);
    // d/dq of 0.75 q / 2000 - k (q - 8)^2 is 0 at q = 8 + 0.75 / 2000 / (2 k) = 26.75 MPa.
    const double damage = kOnset + 0.75 / kModulus / (2.0 * kGrowth);
    REQUIRE(found->damage_mpa);
    CHECK(*found->damage_mpa == Approx(confining + damage).margin(0.011));
    // The largest contraction c = 0.75 * 26.75 / 2000 - k 18.75^2; k (q - 8)^2 reaches 2 % of it at q_i.
    const double contraction = 0.75 * damage / kModulus - kGrowth * std::pow(damage - kOnset, 2);
    REQUIRE(found->initiation_mpa);
    CHECK(*found->initiation_mpa ==
          Approx(confining + kOnset + std::sqrt(kDilationOnset * contraction / kGrowth)).margin(0.011));
    CHECK(found->crack_volumetric[500] == Approx(0.0).margin(1e-12));  // q = 5 MPa: elastic
  }
}

TEST_CASE("A specimen that has not turned before its peak has no crack damage stress, one that is elastic neither") {
  const Specimen early = loaded_to(20.0, 0.0);
  const auto found = crack_stresses(early.columns(), early.stress.size() - 1, {2.0, 6.0}, 0.0);
  REQUIRE(found);
  CHECK_FALSE(found->damage_mpa);
  CHECK(found->initiation_mpa);
  const Specimen elastic = loaded_to(7.0, 0.0);
  const auto none = crack_stresses(elastic.columns(), elastic.stress.size() - 1, {2.0, 6.0}, 0.0);
  REQUIRE(none);
  CHECK_FALSE(none->damage_mpa);
  CHECK_FALSE(none->initiation_mpa);
}

TEST_CASE("Rows on a way back are left out, and too few rows give nothing") {
  Specimen s = loaded_to(12.0, 0.0);
  for (double q = 12.0; q > 2.0; q -= 0.01) {  // a way back with a lateral strain that stays: it contracts less
    add_row(s, q, 0.0);
    s.lateral.back() = 0.1;
  }
  const Specimen on = loaded_to(32.0, 0.0);
  for (std::size_t i = 1201; i < on.stress.size(); ++i) {
    s.path.push_back(on.path[i]);
    s.stress.push_back(on.stress[i]);
    s.axial.push_back(on.axial[i]);
    s.lateral.push_back(on.lateral[i]);
  }
  const auto looped = crack_stresses(s.columns(), s.stress.size() - 1, {2.0, 6.0}, 0.0);
  const auto plain = crack_stresses(on.columns(), on.stress.size() - 1, {2.0, 6.0}, 0.0);
  REQUIRE(looped);
  CHECK(*looped->damage_mpa == *plain->damage_mpa);
  CHECK(*looped->initiation_mpa == Approx(*plain->initiation_mpa).margin(0.011));
  CHECK_FALSE(crack_stresses(on.columns(), on.stress.size() - 1, {40.0, 50.0}, 0.0));
}
