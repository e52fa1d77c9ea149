#include "core/measurement/features.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

using namespace asperity;

namespace {

constexpr double kExact = 1e-9;  // sums of some hundred terms of order one

/// Load of a straight curve: stiffness 10 up to the peak of 10 at path 1, then a fall of stiffness 20 to 4.
double straight_load(double x) { return x <= 1.0 ? 10.0 * x : std::max(4.0, 10.0 - 20.0 * (x - 1.0)); }

/// Rows of it at every 0.005 up to `end`, the path shifted by an offset.
Curve straight(double end, double offset = 0.0, double base = 0.0) {
  Curve c;
  for (int i = 0; i * 0.005 <= end + 1e-12; ++i) {
    c.path.push_back(offset + 0.005 * i);
    c.load.push_back(base + straight_load(0.005 * i));
  }
  return c;
}

CurveReading reading(ExperimentType type) {
  CurveReading r;
  r.experiment = type;
  if (type == ExperimentType::brazilian) r.diameter_mm = 50.0;
  return r;
}

FeatureValue value(const Curve& curve, const CurveReading& r, std::string_view name) {
  const auto kinds = feature_kinds(r.experiment);
  const std::vector<FeatureValue> all = read_features(curve, r);
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (kinds[k].name == name) return all[k];
  }
  FAIL(name << " is no feature");
  return {};
}

double number(const Curve& curve, const CurveReading& r, std::string_view name) {
  const FeatureValue v = value(curve, r, name);
  CAPTURE(name, v.absent);
  REQUIRE(v.value);
  return *v.value;
}

std::string why_absent(const Curve& curve, const CurveReading& r, std::string_view name) {
  const FeatureValue v = value(curve, r, name);
  CHECK_FALSE(v.value);
  return v.absent;
}

const CurveReading kDisc = reading(ExperimentType::brazilian);
const CurveReading kJoint = reading(ExperimentType::direct_shear);

}  // namespace

TEST_CASE("a straight curve has the numbers it is made of") {
  const Curve c = straight(3.0, 0.2);
  CHECK(number(c, kDisc, "peak_load_n_per_mm") == Approx(10.0).epsilon(kExact));
  CHECK(number(c, kDisc, "tensile_strength_mpa") == Approx(2.0 * 10.0 / (M_PI * 50.0)).epsilon(kExact));
  CHECK(number(c, kDisc, "peak_closure_mm") == Approx(1.2).epsilon(kExact));
  CHECK(number(c, kDisc, "peak_closure_from_toe_mm") == Approx(1.0).epsilon(kExact));
  CHECK(number(c, kDisc, "stiffness_n_per_mm2") == Approx(10.0).epsilon(kExact));
  CHECK(number(c, kDisc, "initial_stiffness_n_per_mm2") == Approx(10.0).epsilon(kExact));
  CHECK(number(c, kDisc, "late_stiffness_ratio") == Approx(1.0).epsilon(kExact));
  CHECK(number(c, kDisc, "toe_offset_mm") == Approx(0.2).epsilon(kExact));
  CHECK(number(c, kDisc, "toe_travel_mm") == Approx(0.0).margin(kExact));
  // From 0.95 at path 1.025 on over 0.2 the load goes on falling by 4 of 10.
  CHECK(number(c, kDisc, "drop_share") == Approx(0.4).epsilon(kExact));
  CHECK(number(c, kDisc, "softening_mm") == Approx(0.2).epsilon(kExact));
  CHECK(number(c, kDisc, "residual_load_n_per_mm") == Approx(4.0).epsilon(kExact));
  CHECK(number(c, kDisc, "first_drop_stress_mpa") == Approx(2.0 * 10.0 / (M_PI * 50.0)).epsilon(kExact));
  CHECK(number(c, kDisc, "loop_count") == 0.0);
}

TEST_CASE("what a curve does not reach is absent, with the reason") {
  CHECK(why_absent(straight(0.9), kDisc, "peak_load_n_per_mm") == "no peak was passed");
  CHECK(why_absent(straight(0.9), kDisc, "stiffness_n_per_mm2") == "no peak was passed");
  CHECK(why_absent(straight(1.1), kDisc, "drop_share") == "the curve ends before the stated path behind the peak");
  CHECK(why_absent(straight(1.02), kDisc, "drop_share") == "the load does not fall to 0.95 of the peak");
  CHECK(why_absent(straight(1.1), kDisc, "residual_load_n_per_mm") ==
        "the curve ends less than a third of the peak's path behind it");
  CHECK(why_absent(straight(0.03), kDisc, "peak_load_n_per_mm") == "the curve has fewer than ten rows");
  CHECK(why_absent({}, kDisc, "peak_load_n_per_mm") == "the curve has fewer than ten rows");
  CHECK(why_absent(straight(3.0), kDisc, "toe_extent_share") ==
        "no toe: it travels less than 0.01 of the way to the peak");
  CHECK(why_absent(straight(3.0), kDisc, "nonlinearity_load_n_per_mm") ==
        "the secant stiffness falls by less than a tenth before the peak");
  CHECK(why_absent(straight(3.0), kDisc, "events_at_peak") == "acoustic_events was not recorded");
  CHECK(why_absent(straight(3.0), kDisc, "unloading_stiffness_n_per_mm2") ==
        "the curve has no unloading with a reload");
  CHECK(why_absent(straight(3.0), kJoint, "peak_dilation_mm") == "dilation_mm was not recorded");
  const CurveReading plain = reading(ExperimentType::uniaxial);
  CHECK(why_absent(straight(3.0), plain, "youngs_modulus_gpa") ==
        "no gauge on the specimen: the strain is the platens'");
  CHECK(why_absent(straight(3.0), plain, "poissons_ratio") == "lateral_strain was not recorded");
}

TEST_CASE("a peak is sought up to the limit of the path") {
  CurveReading r = kDisc;
  r.path_limit = 0.5;
  CHECK(why_absent(straight(3.0), r, "peak_load_n_per_mm") == "no peak was passed");
  r.path_limit = 1.5;
  CHECK(number(straight(3.0), r, "peak_load_n_per_mm") == Approx(10.0));
}

TEST_CASE("a plateau is a peak that was passed") {
  Curve c = straight(1.0);
  for (int i = 1; i <= 40; ++i) {
    c.path.push_back(1.0 + 0.005 * i);
    c.load.push_back(10.0);
  }
  CHECK(number(c, kJoint, "peak_shear_stress_mpa") == Approx(10.0));
}

TEST_CASE("a triaxial curve counts from its confining pressure, and its stresses are total") {
  CurveReading r = reading(ExperimentType::triaxial);
  r.confining_pressure_mpa = 3.0;
  Curve c = straight(3.0, 0.0, 3.0);
  for (double x : c.path) {
    c.gauge_strain.push_back(0.5 * x);
    c.lateral_strain.push_back(0.1 * x);
  }
  CHECK(number(c, r, "peak_axial_stress_mpa") == Approx(13.0).epsilon(kExact));
  CHECK(number(c, r, "residual_axial_stress_mpa") == Approx(7.0).epsilon(kExact));
  CHECK(number(c, r, "toe_offset_strain") == Approx(0.0).margin(kExact));
  CHECK(number(c, r, "axial_modulus_gpa") == Approx(0.010).epsilon(kExact));
  CHECK(number(c, r, "youngs_modulus_gpa") == Approx(0.020).epsilon(kExact));
  CHECK(number(c, r, "poissons_ratio") == Approx(0.2).epsilon(kExact));
  CHECK(number(c, r, "lateral_ratio") == Approx(0.1).epsilon(kExact));
  CHECK(number(c, r, "peak_lateral_strain") == Approx(0.1).epsilon(kExact));
  r.plane = PlaneCondition::strain;  // Eqs M5, M6
  CHECK(number(c, r, "poissons_ratio") == Approx(0.2 / 1.2).epsilon(kExact));
  CHECK(number(c, r, "youngs_modulus_gpa") == Approx(0.020 * (1 - std::pow(0.2 / 1.2, 2))).epsilon(kExact));
}

TEST_CASE("the toe that fades with the load has the extent of its exponential, and the line's end where it bends") {
  constexpr double kTravel = 0.1, kFade = 0.3;
  Curve c;
  for (int i = 0; i <= 2400; ++i) {
    const double q = i <= 2000 ? 0.005 * i : 10.0 - 0.01 * (i - 2000);
    const double bent = q > 6.0 ? 0.05 * (q - 6.0) * (q - 6.0) : 0.0;  // path beyond the line of stiffness 10
    c.load.push_back(q);
    c.path.push_back(i <= 2000 ? 0.1 * q + kTravel * (1.0 - std::exp(-q / kFade)) + bent : c.path.back() + 0.001);
  }
  // What is left of the toe in the modulus window, exp(-7) of it at its beginning, hardly moves the line.
  CHECK(number(c, kJoint, "toe_offset_mm") == Approx(kTravel).epsilon(0.01));
  CHECK(number(c, kJoint, "toe_travel_mm") == Approx(kTravel * std::exp(-0.2 / kFade)).epsilon(0.01));
  CHECK(number(c, kJoint, "toe_extent_share") == Approx(kFade / 10.0).epsilon(0.02));
  // 0.05 (q - 6)^2 = q/90: q = 7.286
  CHECK(number(c, kJoint, "nonlinearity_stress_mpa") == Approx(7.286).epsilon(0.01));
}

TEST_CASE("loops are found, left out of first loading, and read for themselves") {
  Curve c = straight(0.6);
  const auto add = [&](double x, double q) {
    c.path.push_back(x);
    c.load.push_back(q);
  };
  // Unloading from 6 to 0.1 with stiffness 20, reloading with 15 up to the load where it left.
  for (int i = 1; i <= 59; ++i) add(0.6 - 0.1 * i / 20.0, 6.0 - 0.1 * i);
  const double bottom = c.path.back();
  for (int i = 1; i <= 59; ++i) add(bottom + 0.1 * i / 15.0, 0.1 + 0.1 * i);
  const Curve end = straight(3.0);
  for (std::size_t i = 0; i < end.path.size(); ++i) {
    if (end.path[i] > c.path.back() - 1e-9 && end.path[i] > 0.7) add(end.path[i], end.load[i]);
  }
  CHECK(number(c, kJoint, "loop_count") == 1.0);
  CHECK(number(c, kJoint, "unloading_shear_stiffness_mpa_per_mm") == Approx(20.0).epsilon(kExact));
  CHECK(number(c, kJoint, "reloading_shear_stiffness_mpa_per_mm") == Approx(15.0).epsilon(kExact));
  CHECK(number(c, kJoint, "shear_stiffness_mpa_per_mm") == Approx(10.0).epsilon(kExact));
  CHECK(number(c, kJoint, "reload_toe_travel_mm") == Approx(0.0).margin(kExact));
  // At a load of 0.5: first loading at 0.05, the reload at 0.305 + 0.4/15.
  CHECK(number(c, kJoint, "permanent_mm") == Approx(bottom + 0.4 / 15.0 - 0.05).epsilon(1e-6));
}

TEST_CASE("a last unloading is no loop, and noise of the path is none either") {
  Curve c = straight(3.0);
  for (int i = 1; i < 20; ++i) {
    c.path.push_back(3.0 - 0.01 * i);
    c.load.push_back(4.0 - 0.1 * i);
  }
  CHECK(number(c, kJoint, "loop_count") == 0.0);
  CHECK(number(c, kJoint, "residual_shear_stress_mpa") == Approx(4.0));
  Curve noisy = straight(3.0);
  for (std::size_t i = 0; i < noisy.path.size(); i += 2) noisy.path[i] += 0.05;  // 1.7 % of the range
  CHECK(find_loops(noisy, kJoint).empty());
}

TEST_CASE("a joint's dilation, the tilt of its upper half, its drops") {
  Curve c;
  for (int i = 0; i <= 600; ++i) {
    const double x = 0.01 * i, two = std::fmod(x, 2.0);
    c.path.push_back(x);
    c.load.push_back(x < 1.0 ? 10.0 * x : two >= 1.0 ? 10.0 - 5.0 * (two - 1.0) : 5.0 + 3.0 * two);
    c.dilation_mm.push_back(x <= 1.0 ? 0.5 * x : 0.5 + 0.2 * (x - 1.0));
    c.dilation_rear_mm.push_back(0.8 * c.dilation_mm.back());
  }
  CHECK(number(c, kJoint, "peak_dilation_mm") == Approx(0.5).epsilon(kExact));
  CHECK(number(c, kJoint, "end_dilation_mm") == Approx(1.5).epsilon(kExact));
  CHECK(number(c, kJoint, "dilation_rate_before_peak") == Approx(0.5).epsilon(kExact));
  CHECK(number(c, kJoint, "dilation_rate_after_peak") == Approx(0.2).epsilon(kExact));
  CHECK(number(c, kJoint, "dilation_difference_at_peak_mm") == Approx(0.2).epsilon(kExact));
  CHECK(number(c, kJoint, "dilation_difference_rate") == Approx(0.2).epsilon(kExact));
  c.dilation_front_mm = c.dilation_mm;
  CHECK(number(c, kJoint, "dilation_difference_at_peak_mm") == Approx(0.1).epsilon(kExact));
  CHECK(number(c, kJoint, "drop_count") >= 2.0);
  CHECK(number(c, kJoint, "largest_drop_mpa") == Approx(5.0).epsilon(0.02));  // rows 0.01 apart
  CHECK(number(c, kJoint, "rise_after_drop_mpa") == Approx(5.0).epsilon(0.02));
}

TEST_CASE("events are counted up to fractions of the peak") {
  Curve c = straight(3.0);
  for (double x : c.path) c.events.push_back(1000.0 * std::min(x, 1.0));
  CHECK(number(c, kDisc, "events_at_peak") == Approx(1000.0));
  CHECK(number(c, kDisc, "event_share_at_half") == Approx(0.5).epsilon(kExact));
  CHECK(number(c, kDisc, "event_share_at_four_fifths") == Approx(0.8).epsilon(kExact));
  CHECK(number(c, kDisc, "event_onset_share") == Approx(0.1).epsilon(0.01));
}

TEST_CASE("slope by order is free of the flattening by noise, parting rows of a fringe") {
  std::vector<double> x, y;
  for (int i = 0; i < 200; ++i) {
    x.push_back(i + (i % 2 ? 40.0 : -40.0));  // errors of x as large as its spread, in turns
    y.push_back(3.0 * i);
  }
  CHECK(slope_in_order(x, y) == Approx(3.0).epsilon(0.01));
  CHECK(fit_line(x, y).slope < 2.5);
  CHECK(parting_row({false, false, true, false, false, true, true, false, true, true}) == 5);
  CHECK(parting_row({true, true}) == 0);
  CHECK(parting_row({false, false}) == 2);
}

TEST_CASE("each feature has one name, a unit and an equation") {
  using enum ExperimentType;
  for (const ExperimentType type : {uniaxial, triaxial, brazilian, direct_shear}) {
    std::set<std::string_view> names;
    for (const FeatureKind& kind : feature_kinds(type)) {
      CAPTURE(kind.name);
      CHECK(names.insert(kind.name).second);
      CHECK(!kind.unit.empty());
      CHECK(!kind.what.empty());
      CHECK(find_feature_kind(type, kind.name) == &kind);
    }
  }
  CHECK(find_feature_kind(brazilian, "youngs_modulus_gpa") == nullptr);
}
