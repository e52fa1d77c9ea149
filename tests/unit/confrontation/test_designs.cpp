#include "core/confrontation/test_designs.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace asperity;

namespace {

const TestDesign& design(const std::string& id) {
  const auto& all = test_designs();
  return *std::find_if(all.begin(), all.end(), [&](const TestDesign& d) { return d.id == id; });
}

RunConfig compression(ExperimentType type, double height, double pressure = 0.0) {
  RunConfig run;
  run.experiment.type = type;
  run.experiment.width_mm = 50;
  run.experiment.height_mm = height;
  run.experiment.confining_pressure_mpa = pressure;
  run.experiment.stop.axial_strain = 0.02;
  return run;
}

const RunConfig kTall = compression(ExperimentType::uniaxial, 100);

}  // namespace

TEST_CASE("another slenderness is proposed only where it was not made") {
  const auto low = design("height_over_width_1").change(kTall, {kTall});
  REQUIRE(low.has_value());
  CHECK(low->experiment.height_mm == 50);
  CHECK(low->measurement.axial_gauge_mm <= 50);
  CHECK(!design("height_over_width_1").change(kTall, {kTall, *low}));
  CHECK(design("height_over_width_3").change(kTall, {kTall, *low})->experiment.height_mm == 150);
}

TEST_CASE("a loop is proposed where none was made, in the rising part") {
  const auto loop = design("unload_reload").change(kTall, {kTall});
  REQUIRE(loop.has_value());
  REQUIRE(loop->experiment.loading.unloading.size() == 1);
  CHECK(loop->experiment.loading.unloading[0].at_mm == Approx(0.3 * 0.02 * 100));
  CHECK(!design("unload_reload").change(kTall, {kTall, *loop}));
  RunConfig controlled = kTall;
  controlled.experiment.loading.rate_control.enabled = true;
  CHECK(!design("unload_reload").change(controlled, {controlled}));
}

TEST_CASE("twice the confining pressure is that of the highest one") {
  const RunConfig one = compression(ExperimentType::triaxial, 100, 1.0),
                  three = compression(ExperimentType::triaxial, 100, 3.0);
  CHECK(!design("twice_confining_pressure").change(one, {one, three}));
  CHECK(design("twice_confining_pressure").change(three, {one, three})->experiment.confining_pressure_mpa == 6.0);
  CHECK(!design("twice_confining_pressure").change(kTall, {kTall}));
}

TEST_CASE("size, rate and the joint's stiffness") {
  CHECK(design("half_size").change(kTall, {kTall})->experiment.width_mm == 25);
  CHECK(design("slower_rate").change(kTall, {kTall})->experiment.loading.closing_rate_mm_per_s ==
        Approx(0.25 * kTall.experiment.loading.closing_rate_mm_per_s));
  const auto slow = design("slower_rate").change(kTall, {kTall});
  CHECK(!design("slower_rate").change(kTall, {kTall, *slow}));
  RunConfig joint;
  joint.experiment.type = ExperimentType::direct_shear;
  CHECK(design("constant_normal_stiffness").change(joint, {joint})->mechanisms.size() == 1);
  joint.mechanisms = {{"normal_stiffness", 0.5, {}}};
  CHECK(!design("constant_normal_stiffness").change(joint, {joint}));
  CHECK(!design("constant_normal_stiffness").change(kTall, {kTall}));
  CHECK(design("lubricated_platens").preparation == Preparation{0.0, true});
  CHECK(design("rotated_core").preparation == Preparation{90.0, false});
}
