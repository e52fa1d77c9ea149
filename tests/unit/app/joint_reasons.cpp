#include "app/report/joint_reasons.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "app/report/joint_words.hpp"

using namespace asperity;
using namespace asperity::app;

namespace {

/// The plaster's joint with one tooth of 30 degrees, sheared off behind the peak under 1.47 MPa; figures of such a run.
JointNumbers sheared_tooth(double normal_mpa = 1.47) {
  JointNumbers n;
  n.joint = {24.32, {{17.32, 5.0, 30.0}}, 35.0, 1.75, 40.0};
  n.normal_mpa = n.normal_at_peak_mpa = normal_mpa;
  n.length_mm = 24.32;
  n.edge_mm = 0.5;
  n.shear_fracture_energy_n_per_mm = 0.15;
  n.peak_mpa = 1.90;
  n.peak_mm = 0.64;
  n.residual_mpa = 1.42;
  n.end_mm = 12.0;
  n.dilation_rate = 0.32;
  n.leading_share_at_peak = 0.98;
  n.softening_at_peak = 400;
  n.at_peak = {3.0, 0.05, 0.0, 0.1};
  n.at_end = {20.0, 0.05, -0.6, 0.2};
  n.last_quarter_slope = -0.02;
  n.last_quarter_cracks = 7;
  n.teeth_failed = "the_only_one";
  n.first = 0;
  n.teeth = {{30.0, 17.32, 0.92, 1.87, 1.88, 0.63, 1.0, 0.0}};
  n.forms = joint_strength(n.joint, n.normal_mpa);
  return n;
}

/// The same joint, unbroken, slid up its flank.
JointNumbers slid_tooth() {
  JointNumbers n = sheared_tooth(0.39);
  n.peak_mpa = 0.39 * std::tan((35.0 + 30.0) * std::acos(-1.0) / 180.0);
  n.dilation_rate = std::tan(30.0 * std::acos(-1.0) / 180.0);
  n.at_peak = n.at_end = {};
  n.softening_at_peak = 0;
  n.teeth_failed = "none";
  n.first.reset();
  n.teeth[0].sheared_off_mm.reset();
  n.teeth[0].attached_at_end = 1;
  return n;
}

/// Teeth of 15 and 30 degrees; the steep one goes at 0.9 mm.
JointNumbers two_teeth(const std::string& verdict, double share) {
  JointNumbers n = sheared_tooth();
  n.joint = {61.64, {{37.32, 5.0, 15.0}, {17.32, 5.0, 30.0}}, 35.0, 1.75, 40.0};
  n.length_mm = 61.64;
  n.teeth = {{15.0, 37.32, 2.5, 0.2, 0.9, 2.0, share, 0.0}, {30.0, 17.32, 0.9, 1.2, 1.25, 0.8, 1.0, 0.0}};
  n.teeth_failed = verdict;
  n.first = 1;
  n.forms = joint_strength(n.joint, n.normal_mpa);
  return n;
}

std::string why(const JointNumbers& n, const std::string& name) {
  for (const FormBeside& form : forms_beside(n))
    if (form.name == name) return form.why;
  FAIL("no closed form " << name);
  return "";
}

/// A curve that rises along a slope in mm per mm, every 0.1 mm up to 3 mm; the flatter tooth bears from 1 mm on.
CsvData rising_curve(double slope) {
  std::string text = "shear_displacement_mm,dilation_mm,dilation_front_mm,dilation_rear_mm,tooth1_leading_y_n_per_mm\n";
  for (int i = 0; i <= 30; ++i) {
    const double u = 0.1 * i, v = slope * u;
    text += std::to_string(u) + "," + std::to_string(v) + "," + std::to_string(v + 0.02) + "," +
            std::to_string(v - 0.02) + "," + (i >= 10 ? "50" : "0") + "\n";
  }
  return parse_csv(text, "curves.csv");
}

std::string whole(const std::vector<std::string>& story) {
  std::string text;
  for (const std::string& sentence : story) text += sentence + "\n";
  return text;
}

}  // namespace

TEST_CASE("A tooth that was sheared off did not slide: when, why, and what its own slope gives") {
  const std::string text = why(sheared_tooth(), "sliding up the flanks");
  CHECK_THAT(text, Catch::Contains("The tooth was sheared off at 0.92 mm"));
  // C62 = 2.48 MPa is less than C61 = 3.15; C65 gives 0.95 MPa.
  CHECK_THAT(text, Catch::Contains("2.48 MPa") && Catch::Contains("above the transition stress, 0.95 MPa"));
  // atan 0.32 = 17.7 degrees; 1.47 tan(52.74 degrees) = 1.93 MPa.
  CHECK_THAT(text, Catch::Contains("17.7°") && Catch::Contains("1.93 MPa, within 3 % of the simulated peak"));
}

TEST_CASE("Shearing through tells the cohesion that was mobilised, what was softening, and where it broke") {
  const std::string text = why(sheared_tooth(), "sheared through at the base");
  // (1.90 - 1.47 tan 40) 24.32 / 17.32 = 0.936 MPa, 53 % of 1.75.
  CHECK_THAT(text, Catch::Contains("0.94 MPa on the base, 53 % of C = 1.75 MPa"));
  CHECK_THAT(text, Catch::Contains("3.00 mm in all had broken (17 % of the base's 17.32 mm) and 400 were softening"));
  CHECK_THAT(text, Catch::Contains("G_II = 0.150 N/mm"));
  CHECK_THAT(text, Catch::Contains("0.60 mm ± 0.20 mm below the base's plane"));
  CHECK_THAT(text, !Catch::Contains("tension") && !Catch::Contains("inertia"));
}

TEST_CASE("A sentence stands only where the run's numbers bear it out") {
  JointNumbers n = sheared_tooth();
  n.softening_at_peak = 0;
  n.at_peak = {};
  n.at_end = {20.0, 0.4, 0.0, 0.1};
  n.normal_at_peak_mpa = 1.6;
  n.leading_share_at_peak = 0.7;
  const std::string text = why(n, "sheared through at the base");
  CHECK_THAT(text, !Catch::Contains("all at once") && !Catch::Contains("G_II") && !Catch::Contains("not on it"));
  CHECK_THAT(text, Catch::Contains("40 % of their length broke in tension") && Catch::Contains("bore 70 %") &&
                       Catch::Contains("1.60 MPa at the peak"));
  n.at_end = {20.0, 0.0, 0.1, 0.9};
  CHECK_THAT(why(n, "sheared through at the base"), Catch::Contains("spread by ± 0.90 mm"));
  n.peak_mpa = 3.0;
  n.at_end = {};
  n.leading_share_at_peak = 1.0;
  n.normal_at_peak_mpa = n.normal_mpa;
  CHECK_THAT(why(n, "sheared through at the base"), Catch::Contains("do not tell"));
}

TEST_CASE("A tooth that slid agrees with sliding, and its base was not asked") {
  const JointNumbers n = slid_tooth();
  CHECK_THAT(why(n, "sliding up the flanks"),
             Catch::Contains("No tooth was sheared off") && Catch::Contains("agree within 3 %"));
  CHECK_THAT(why(n, "sheared through at the base"), Catch::Contains("was not reached"));
  CHECK_THAT(why(n, "transition, normal stress"), Catch::Contains("below it") && Catch::Contains("as predicted"));
  CHECK_THAT(why(n, "residual, joint's friction"), Catch::Contains("The tooth still stands"));
}

TEST_CASE("The transition says whether the tooth did what it predicts") {
  CHECK_THAT(why(sheared_tooth(), "transition, normal stress"),
             Catch::Contains("above it") && Catch::Contains("as predicted"));
  JointNumbers n = sheared_tooth(0.39);
  n.forms = joint_strength(n.joint, 0.39);
  CHECK_THAT(why(n, "transition, normal stress"), Catch::Contains("should slide") && Catch::Contains("against it"));
}

TEST_CASE("Flanks too steep to slide are told as such") {
  JointNumbers n = sheared_tooth();
  n.joint.teeth[0].angle_deg = 60;
  n.forms = joint_strength(n.joint, n.normal_mpa);
  CHECK_THAT(why(n, "sliding up the flanks"), Catch::Contains("95.0° reaches 90°"));
  CHECK(std::isinf(forms_beside(n).front().predicted_mpa));
}

TEST_CASE("The residual tells its friction angle, the slope it moved on, and whether it is one at all") {
  JointNumbers n = sheared_tooth();
  // atan(1.42 / 1.47) = 44.0 degrees; 1.47 tan(35 - 1.15 degrees) = 0.986 MPa.
  CHECK_THAT(why(n, "residual, joint's friction"), Catch::Contains("44.0°") && Catch::Contains("sank by 0.020") &&
                                                       Catch::Contains("0.99 MPa") &&
                                                       Catch::Contains("7 more contacts broke"));
  // 1.47 tan(40 - 1.15 degrees) = 1.18 MPa.
  CHECK_THAT(why(n, "residual, rock's friction"), Catch::Contains("rock's friction makes 1.18 MPa"));
  n.teeth[0].sheared_off_mm = 10.0;
  CHECK_THAT(why(n, "residual, joint's friction"),
             Catch::Contains("10.00 mm only, inside the last quarter (9.00 mm to 12.00 mm)"));
}

TEST_CASE("Forms of several teeth stand only where there are several") {
  CHECK(forms_beside(sheared_tooth()).size() == 6);
  const JointNumbers n = two_teeth("one_after_the_other", 0.12);
  CHECK(forms_beside(n).size() == 8);
  CHECK_THAT(why(n, "all teeth at once"),
             Catch::Contains("when tooth 2 (30°) bore its most, tooth 1 (15°) bore 12 % of its own"));
  CHECK_THAT(why(n, "teeth one after the other"), Catch::Contains("at most 1.25 MPa"));
  CHECK_THAT(why(two_teeth("together", 0.8), "teeth one after the other"), Catch::Contains("did not carry alone"));
}

TEST_CASE(
    "The story of two teeth: the verdict first, each tooth's course, and what keeps the flatter flank closed or open") {
  const std::vector<std::string> story = teeth_story(two_teeth("one_after_the_other", 0.12), rising_curve(0.5));
  CHECK_THAT(story.front(), Catch::Contains("one after the other") && Catch::Contains("12 % of its own"));
  // At 0.8 mm: risen 0.40; rigid 0.8 tan 30 = 0.46; the 15 degree flank parts above 0.8 tan 15 = 0.21, 0.19 open.
  // Slip 0.8 - 0.4/tan 30 = 0.107; closed from 0.8 (1 - tan 15/tan 30) = 0.429 on.
  const std::string text = whole(story);
  CHECK_THAT(text, Catch::Contains("At 0.80 mm the upper half had risen by 0.40 mm") && Catch::Contains("0.46 mm") &&
                       Catch::Contains("more than 0.21 mm") && Catch::Contains("0.11 mm of the displacement") &&
                       Catch::Contains("from 0.43 mm on") && Catch::Contains("stood 0.19 mm open"));
  CHECK_THAT(text, Catch::Contains("first at 1.00 mm, last at 3.00 mm") && Catch::Contains("cannot rotate") &&
                       Catch::Contains("front end stood at 0.42 mm, its rear end at 0.38 mm"));
  CHECK_THAT(whole(teeth_story(two_teeth("together", 0.8), rising_curve(0.1))),
             Catch::Contains("failed together") && Catch::Contains("pressed together by 0.13 mm"));
}

TEST_CASE("Figures in sentences have true minus signs and no minus zero") {
  CHECK(decimals(-0.5, 2) == "−0.50");
  CHECK(decimals(-0.001, 2) == "0.00");
  CHECK(decimals(NAN, 2) == "–");
  CHECK(percent_apart(1.5, 2.0) == "25 % less");
  CHECK(percent_apart(2.05, 2.0) == "2.5 % more");
}
