#include "core/confrontation/test_designs.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using Made = const RunConfig&;
using All = const std::vector<RunConfig>&;
using Changed = std::optional<RunConfig>;

constexpr double kSlower = 0.25, kPressure = 2.0, kSize = 0.5;
constexpr double kUnloadAt = 0.3;  // of the closure at which the test ends
constexpr double kUnloadTo = 0.1;  // of the stress there
constexpr double kSameSlenderness = 0.1, kSameRate = 1.1;

bool uniaxial(Made run) { return run.experiment.type == ExperimentType::uniaxial; }

double slenderness(Made run) { return run.experiment.height_mm / run.experiment.width_mm; }

void shorten_gauges(RunConfig& run) {
  run.measurement.axial_gauge_mm = std::min(run.measurement.axial_gauge_mm, run.experiment.height_mm);
  run.measurement.lateral_gauge_mm = std::min(run.measurement.lateral_gauge_mm, run.experiment.height_mm);
}

Changed with_slenderness(Made made, All all, double ratio) {
  if (!uniaxial(made)) return std::nullopt;
  const auto same = [&](Made run) {
    return uniaxial(run) && std::abs(slenderness(run) - ratio) < kSameSlenderness * ratio;
  };
  if (std::any_of(all.begin(), all.end(), same)) return std::nullopt;
  RunConfig run = made;
  run.experiment.height_mm = ratio * run.experiment.width_mm;
  shorten_gauges(run);
  return run;
}

Changed with_loop(Made made, All all) {
  if (made.experiment.type == ExperimentType::direct_shear) return std::nullopt;
  const auto has_loop = [&](Made run) {
    return run.experiment.type == made.experiment.type && !run.experiment.loading.unloading.empty();
  };
  if (std::any_of(all.begin(), all.end(), has_loop)) return std::nullopt;
  RunConfig run = made;
  const double length =
      made.experiment.type == ExperimentType::brazilian ? made.experiment.diameter_mm : made.experiment.height_mm;
  if (made.experiment.loading.rate_control.enabled) return std::nullopt;
  run.experiment.loading.unloading = {{kUnloadAt * made.experiment.stop.axial_strain * length, kUnloadTo}};
  return run;
}

Changed slower(Made made, All all) {
  if (!uniaxial(made)) return std::nullopt;
  const double rate = kSameRate * kSlower * made.experiment.loading.closing_rate_mm_per_s;
  const auto as_slow = [&](Made run) { return uniaxial(run) && run.experiment.loading.closing_rate_mm_per_s <= rate; };
  if (std::any_of(all.begin(), all.end(), as_slow)) return std::nullopt;
  RunConfig run = made;
  run.experiment.loading.closing_rate_mm_per_s *= kSlower;
  return run;
}

Changed at_twice_the_pressure(Made made, All all) {
  if (made.experiment.type != ExperimentType::triaxial) return std::nullopt;
  for (Made run : all) {
    if (run.experiment.confining_pressure_mpa > made.experiment.confining_pressure_mpa) return std::nullopt;
  }
  RunConfig run = made;
  run.experiment.confining_pressure_mpa *= kPressure;
  return run;
}

Changed at_half_size(Made made, All) {
  if (!uniaxial(made)) return std::nullopt;
  RunConfig run = made;
  run.experiment.width_mm *= kSize;
  run.experiment.height_mm *= kSize;
  shorten_gauges(run);
  return run;
}

Changed as_it_was(Made made, All) { return uniaxial(made) ? Changed(made) : std::nullopt; }

Changed under_constant_stiffness(Made made, All) {
  const auto is_spring = [](const MechanismConfig& m) { return m.type == "normal_stiffness"; };
  if (made.experiment.type != ExperimentType::direct_shear ||
      std::any_of(made.mechanisms.begin(), made.mechanisms.end(), is_spring))
    return std::nullopt;
  RunConfig run = made;
  run.mechanisms.push_back({"normal_stiffness", 1.0, {}});
  return run;
}

Changed same_joint(Made made, All) {
  return made.experiment.type == ExperimentType::direct_shear ? Changed(made) : std::nullopt;
}

}  // namespace

const std::vector<TestDesign>& test_designs() {
  static const std::vector<TestDesign> designs{
      {"lubricated_platens",
       "uniaxial compression between lubricated platens",
       as_it_was,
       "platen_friction",
       "",
       {.lubricated_platens = true}},
      {"height_over_width_1", "uniaxial compression of specimens as high as wide",
       [](Made made, All all) { return with_slenderness(made, all, 1.0); }, "", ""},
      {"height_over_width_3", "uniaxial compression of specimens three times as high as wide",
       [](Made made, All all) { return with_slenderness(made, all, 3.0); }, "", ""},
      {"unload_reload",
       "the same test with one unloading to a tenth and a reload",
       with_loop,
       "",
       "",
       {},
       {{"reload_toe_travel_strain", "toe_travel_strain"},
        {"reload_toe_travel_mm", "toe_travel_mm"},
        {"permanent_strain", "toe_travel_strain"}}},
      {"slower_rate", "uniaxial compression at a quarter of the rate", slower, "", ""},
      {"twice_confining_pressure", "triaxial compression at twice the highest confining pressure",
       at_twice_the_pressure, "", ""},
      {"rotated_core",
       "uniaxial compression of cores drilled at a right angle to these",
       as_it_was,
       "weak_plane",
       "",
       {.core_angle_deg = 90.0}},
      {"constant_normal_stiffness", "direct shear under constant normal stiffness", under_constant_stiffness, "",
       "normal_stiffness"},
      {"dilation_gauges",
       "the same joint with gauges of its dilation in front and at the rear",
       same_joint,
       "",
       "",
       {},
       {{"dilation_difference_at_peak_mm", "peak_dilation_mm"}}},
      {"half_size", "uniaxial compression of specimens of half the size", at_half_size, "", ""}};
  return designs;
}

}  // namespace asperity
