#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/contact/joint_strength.hpp"

using namespace asperity;
using namespace asperity::closed_forms;

namespace {

constexpr double kRounding = 1e-12;
constexpr double kThreeDigits = 0.0005;  // half a unit in the third decimal
constexpr double kTwoDigits = 0.005;     // half a unit in the second decimal
constexpr double kFlats = 7.0;           // mm, of both joints of the paper

double tan_deg(double angle) { return std::tan(angle * std::numbers::pi / 180.0); }

ToothedJoint::Tooth pointed(double angle_deg) { return {10.0 / tan_deg(angle_deg), 5.0, angle_deg}; }

ToothedJoint joint_of(const std::vector<double>& angles, double flats = kFlats) {
  ToothedJoint joint{flats, {}, 35.0, 1.75, 40.0};
  for (const double angle : angles) {
    joint.teeth.push_back(pointed(angle));
    joint.length_mm += joint.teeth.back().base_mm;
  }
  return joint;
}

const ToothedJoint kSingle = joint_of({30.0});
const ToothedJoint kDouble = joint_of({15.0, 30.0});

std::vector<double> range(double last, int parts) {
  std::vector<double> values;
  for (int k = 0; k <= parts; ++k) values.push_back(last * k / parts);
  return values;
}

bool rises(const std::vector<double>& column) { return std::is_sorted(column.begin(), column.end()); }

}  // namespace

TEST_CASE("single tooth: the audit's figures") {
  CHECK(kSingle.length_mm == Approx(24.3).margin(0.05));
  CHECK(uniaxial_strength(1.75, 40.0) == Approx(7.51).margin(kTwoDigits));
  const JointStrength low = joint_strength(kSingle, 0.39), high = joint_strength(kSingle, 1.47);
  CHECK(low.stages.front().sliding_mpa == Approx(0.836).margin(kThreeDigits));
  CHECK(high.stages.front().sliding_mpa == Approx(3.15).margin(kTwoDigits));
  CHECK(low.stages.front().base_shear_mpa == Approx(1.57).margin(kTwoDigits));
  CHECK(high.stages.front().base_shear_mpa == Approx(2.48).margin(kTwoDigits));
  CHECK(low.stages.front().transition_mpa == Approx(0.95).margin(kTwoDigits));
  CHECK(high.residual_low_mpa == Approx(1.03).margin(kTwoDigits));
  CHECK(high.residual_high_mpa == Approx(1.23).margin(kTwoDigits));
  CHECK(low.failure == JointFailure::sliding);
  CHECK(low.strength_mpa == low.stages.front().sliding_mpa);
  CHECK(high.failure == JointFailure::shearing);
  CHECK(high.strength_mpa == Approx(high.stages.front().base_shear_mpa).epsilon(kRounding));
  CHECK(low.stages.front().dilation_slope == Approx(tan_deg(30.0)).epsilon(kRounding));
}

TEST_CASE("double tooth: stages in turn, and all together") {
  CHECK(kDouble.length_mm == Approx(61.6).margin(0.05));
  const JointStrength s = joint_strength(kDouble, 1.47);
  REQUIRE(s.stages.size() == 2);
  CHECK(s.stages[0].group.angle_deg == 30.0);
  CHECK(s.stages[0].failure == JointFailure::shearing);
  CHECK(s.stages[0].strength_mpa == Approx(1.725).margin(kThreeDigits));
  CHECK(s.stages[1].failure == JointFailure::sliding);
  CHECK(s.stages[1].strength_mpa == Approx(1.752).margin(kThreeDigits));
  CHECK(s.together_mpa == Approx(2.785).margin(kThreeDigits));
  CHECK(s.strength_mpa == s.stages[0].strength_mpa);
  CHECK(s.staged_peak_mpa == s.stages[1].strength_mpa);
  CHECK(s.stages[0].transition_mpa == Approx(0.377).margin(kThreeDigits));
}

TEST_CASE("double tooth: the figures quoted for it are those of a joint without flat parts") {
  const JointStrength s = joint_strength(joint_of({15.0, 30.0}, 0.0), 1.47);
  CHECK(s.stages[0].strength_mpa == Approx(1.79).margin(kTwoDigits));
  CHECK(s.residual_high_mpa == Approx(1.23).margin(kTwoDigits));
  CHECK(s.stages[1].strength_mpa == Approx(1.75).margin(kTwoDigits));
  CHECK(s.together_mpa == Approx(2.98).margin(kTwoDigits));
}

TEST_CASE("double tooth: a steep group that slides ends the sequence") {
  const JointStrength s = joint_strength(kDouble, 0.3);
  CHECK(s.stages.size() == 1);
  CHECK(s.failure == JointFailure::sliding);
  CHECK(s.staged_peak_mpa == s.strength_mpa);
}

TEST_CASE("teeth of one angle carry together") {
  const JointStrength s = joint_strength(joint_of({30.0, 30.005, 30.0}, 0.0), 1.47);
  REQUIRE(s.stages.size() == 1);
  CHECK(s.stages[0].base_shear_mpa == Approx(1.75 + 1.47 * tan_deg(40.0)).epsilon(kRounding));
  CHECK(s.together_mpa == Approx(s.stages[0].base_shear_mpa).epsilon(kRounding));
}

TEST_CASE("the weakest plane through the teeth is the least of all planes, and never above the base") {
  const double angle = GENERATE(10.0, 20.0, 30.0, 45.0, 60.0);
  const double sigma_n = GENERATE(0.0, 0.1, 0.39, 0.6, 1.47);
  const ToothedJoint joint = joint_of({angle});
  const ToothGroup group = tooth_groups(joint).front();
  const double weakest = plane_shear_strength(joint, group, weakest_plane(joint, group, sigma_n), sigma_n);
  double least = std::numeric_limits<double>::infinity();
  for (const double theta : range(angle, 2000)) {
    least = std::min(least, plane_shear_strength(joint, group, theta, sigma_n));
  }
  CHECK(weakest <= least * (1.0 + kRounding));
  // A step of at most 0.03 degrees beside a minimum: half the curvature times its square, below 1e-6 of the strength.
  CHECK(weakest == Approx(least).epsilon(1e-6));
  CHECK(weakest <= base_shear_strength(joint, group.base_mm, sigma_n) * (1.0 + kRounding));
}

TEST_CASE("a plane through the wedge balances the forces on it") {
  const double theta = GENERATE(0.0, 5.0, 20.0);
  const ToothGroup group = tooth_groups(kSingle).front();
  const double n = 1.47 * kSingle.length_mm;
  const double t = plane_shear_strength(kSingle, group, theta, 1.47) * kSingle.length_mm;
  const double c = std::cos(theta * std::numbers::pi / 180.0), s = std::sin(theta * std::numbers::pi / 180.0);
  // The plane from (0, 0) meets the back flank y = (b - x) tan i at x = b tan i / (tan i + tan theta).
  const double length = group.base_mm * tan_deg(30.0) / (tan_deg(30.0) + tan_deg(theta)) / c;
  CHECK(t * c - n * s == Approx(1.75 * length + (t * s + n * c) * tan_deg(40.0)).epsilon(kRounding));
}

TEST_CASE("no plane leaves through a flat crest") {
  ToothedJoint joint = joint_of({30.0});
  joint.teeth.front() = {30.0, 1.0, 30.0};
  const ToothGroup group = tooth_groups(joint).front();
  const double crest = std::atan(1.0 / (30.0 - 1.0 / tan_deg(30.0))) * 180.0 / std::numbers::pi;
  CHECK(group.crest_deg == Approx(crest).epsilon(kRounding));
  CHECK(weakest_plane(joint, group, 0.0) == Approx(crest).epsilon(kRounding));
  CHECK(tooth_groups(kSingle).front().crest_deg == Approx(30.0).epsilon(kRounding));
}

TEST_CASE("transition: sliding and shearing are equal there, sliding is less below") {
  const double joint_friction = GENERATE(25.0, 35.0, 40.0, 50.0);
  const double angle = GENERATE(20.0, 30.0, 38.0);
  ToothedJoint joint = joint_of({angle});
  joint.joint_friction_deg = joint_friction;
  const ToothGroup group = tooth_groups(joint).front();
  const double sigma_n = transition_stress(joint, group);
  const ToothStage at = joint_strength(joint, sigma_n).stages.front();
  CHECK(at.sliding_mpa == Approx(at.plane_shear_mpa).epsilon(kRounding));
  CHECK(joint_strength(joint, 0.999 * sigma_n).failure == JointFailure::sliding);
  CHECK(joint_strength(joint, 1.001 * sigma_n).failure == JointFailure::shearing);
  const double patton =
      joint.cohesion_mpa * group.base_mm / joint.length_mm / (tan_deg(joint_friction + angle) - tan_deg(40.0));
  if (joint_friction <= 40.0) {
    CHECK(sigma_n == Approx(patton).epsilon(kRounding));
    CHECK(at.plane_deg == Approx(0.0).margin(1e-9));  // at phi_j = phi the limit itself, to rounding
  } else {
    CHECK(sigma_n < patton);
    CHECK(at.plane_deg > 0.0);
  }
}

TEST_CASE("a joint that is no rougher than its rock follows Patton's bilinear envelope") {
  for (const double sigma_n : range(3.0, 300)) {
    const ToothStage s = joint_strength(kSingle, sigma_n).stages.front();
    CHECK(s.strength_mpa == Approx(std::min(s.sliding_mpa, s.base_shear_mpa)).epsilon(kRounding));
  }
}

TEST_CASE("a joint too steep to slide is sheared at any normal stress") {
  for (const double angle : {55.0, 70.0}) {
    const ToothedJoint joint = joint_of({angle});
    const JointStrength s = joint_strength(joint, 0.0);
    CHECK(std::isinf(s.stages.front().sliding_mpa));
    CHECK(s.stages.front().transition_mpa == 0.0);
    CHECK(s.failure == JointFailure::shearing);
    CHECK(s.strength_mpa == Approx(1.75 * joint.teeth.front().base_mm / joint.length_mm).epsilon(kRounding));
    CHECK(std::isinf(s.ladanyi_archambault.shear_mpa));
  }
  CHECK(std::isfinite(sliding_strength(1.0, 35.0, 54.9)));
}

TEST_CASE("a joint that always slides has no transition") {
  const ToothedJoint joint = joint_of({4.0});
  CHECK(std::isinf(transition_stress(joint, tooth_groups(joint).front())));
  CHECK(joint_strength(joint, 1000.0).failure == JointFailure::sliding);
}

TEST_CASE("no normal stress: nothing resists sliding") {
  const JointStrength s = joint_strength(kDouble, 0.0);
  CHECK(s.strength_mpa == 0.0);
  CHECK(s.ladanyi_archambault.shear_mpa == 0.0);
  CHECK(s.ladanyi_archambault.sheared_area == 0.0);
  CHECK(s.residual_high_mpa == 0.0);
  CHECK(s.together_mpa > 0.0);
}

TEST_CASE("a flat joint is Coulomb's") {
  ToothedJoint flat = joint_of({});
  if (GENERATE(false, true)) flat.teeth.push_back({17.0, 0.0, 0.0});
  flat.joint_friction_deg = GENERATE(35.0, 45.0);
  const JointStrength s = joint_strength(flat, 1.47);
  REQUIRE(s.stages.size() == 1);
  CHECK(s.failure == JointFailure::sliding);
  CHECK(s.strength_mpa == Approx(1.47 * tan_deg(flat.joint_friction_deg)).epsilon(kRounding));
  CHECK(s.stages.front().dilation_slope == 0.0);
  CHECK(std::isinf(s.stages.front().base_shear_mpa));
  CHECK(std::isinf(s.stages.front().transition_mpa));
  CHECK(std::isinf(s.together_mpa));
}

TEST_CASE("Ladanyi and Archambault: hand figures") {
  const LadanyiArchambaultStrength s = ladanyi_archambault(kSingle, 1.47);
  CHECK(s.sheared_area == Approx(0.2789).margin(5e-5));    // 1 - 0.80415^1.5
  CHECK(s.dilation_slope == Approx(0.2414).margin(5e-5));  // 0.80415^4 tan 30
  CHECK(s.intact_mpa == Approx(2.983).margin(kThreeDigits));
  CHECK(s.shear_mpa == Approx(2.084).margin(kThreeDigits));
  CHECK(ladanyi_archambault(kSingle, 0.39).shear_mpa == Approx(0.830).margin(kThreeDigits));
}

TEST_CASE("Ladanyi and Archambault: Patton's slope where nothing is sheared, at first a little more") {
  LadanyiArchambaultParameters unsheared;
  unsheared.sheared_exponent = unsheared.dilation_exponent = 0.0;  // a_s = 0, v = tan i below sigma_T
  CHECK(ladanyi_archambault(kSingle, 1.47, unsheared).shear_mpa ==
        Approx(sliding_strength(1.47, 35.0, 30.0)).epsilon(kRounding));
  const double little = 1e-7;  // curvature over slope is of order 1 / MPa
  const LadanyiArchambaultStrength s = ladanyi_archambault(kSingle, little);
  const double factor = 1.0 - tan_deg(30.0) * tan_deg(35.0);
  const double slope = tan_deg(65.0) + 1.5 * 1.75 / (uniaxial_strength(1.75, 40.0) * factor);
  CHECK(s.shear_mpa / little == Approx(slope).epsilon(1e-6));
  ToothedJoint loose = kSingle;
  loose.cohesion_mpa = 0.0;
  LadanyiArchambaultParameters given;
  given.transition_stress_mpa = 7.5;
  CHECK(ladanyi_archambault(loose, little, given).shear_mpa / little == Approx(tan_deg(65.0)).epsilon(1e-6));
}

TEST_CASE("Ladanyi and Archambault: continuous at sigma_T, the intact rock beyond") {
  LadanyiArchambaultParameters parameters;
  parameters.intact = GENERATE(IntactStrength::mohr_coulomb, IntactStrength::fairhurst);
  parameters.tensile_strength_mpa = 1.6;
  parameters.transition_stress_mpa = GENERATE(3.0, 7.5);
  const double sigma_t = *parameters.transition_stress_mpa;
  const LadanyiArchambaultStrength below = ladanyi_archambault(kSingle, sigma_t * (1.0 - 1e-9), parameters);
  const LadanyiArchambaultStrength at = ladanyi_archambault(kSingle, sigma_t, parameters);
  CHECK(below.shear_mpa == Approx(at.shear_mpa).epsilon(1e-8));  // slope of order 1 times 1e-9, and (1e-9)^1.5
  CHECK(at.shear_mpa == at.intact_mpa);
  CHECK(at.sheared_area == 1.0);
  const LadanyiArchambaultStrength beyond = ladanyi_archambault(kSingle, 1.5 * sigma_t, parameters);
  CHECK(beyond.shear_mpa == beyond.intact_mpa);
  CHECK(beyond.dilation_slope == 0.0);
}

TEST_CASE("Fairhurst's parabola touches the circles of uniaxial compression and tension") {
  LadanyiArchambaultParameters parameters;
  parameters.intact = IntactStrength::fairhurst;
  parameters.tensile_strength_mpa = 1.6;
  const double sigma_c = uniaxial_strength(1.75, 40.0);
  double nearest = sigma_c;
  for (const double sigma_n : range(sigma_c, 4000)) {
    const double intact = ladanyi_archambault(kSingle, sigma_n, parameters).intact_mpa;
    nearest = std::min(nearest, std::hypot(sigma_n - 0.5 * sigma_c, intact));
  }
  CHECK(nearest == Approx(0.5 * sigma_c).epsilon(1e-6));  // steps of 1/4000: half their square
  // The vertex, 1e-9 MPa inside of it: the root of that, times the parabola's width of order 1 MPa^0.5.
  CHECK(ladanyi_archambault(kSingle, -1.6 + 1e-9, parameters).intact_mpa == Approx(0.0).margin(1e-4));
}

TEST_CASE("the envelope rises, and holds what the single answers say") {
  const std::vector<double> normal = range(9.0, 450);
  for (const ToothedJoint& joint : {kSingle, kDouble, joint_of({15.0}), joint_of({45.0})}) {
    const StrengthEnvelope table = strength_envelope(joint, normal);
    CHECK(table.normal_stress == normal);
    for (const std::vector<double>* column :
         {&table.sliding, &table.base_shear, &table.plane_shear, &table.strength, &table.staged_peak, &table.together,
          &table.ladanyi_archambault, &table.residual_low, &table.residual_high}) {
      REQUIRE(column->size() == normal.size());
      CHECK(rises(*column));
    }
    const JointStrength s = joint_strength(joint, normal[70]);
    CHECK(table.strength[70] == s.strength_mpa);
    CHECK(table.staged_peak[70] == s.staged_peak_mpa);
    CHECK(table.sliding[70] == s.stages.front().sliding_mpa);
    CHECK(table.base_shear[70] == s.stages.front().base_shear_mpa);
    CHECK(table.plane_shear[70] == s.stages.front().plane_shear_mpa);
    CHECK(table.together[70] == s.together_mpa);
    CHECK(table.ladanyi_archambault[70] == s.ladanyi_archambault.shear_mpa);
    CHECK(table.residual_low[70] == s.residual_low_mpa);
    CHECK(table.residual_high[70] == s.residual_high_mpa);
  }
}
