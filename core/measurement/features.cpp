#include "core/measurement/features.hpp"

#include <algorithm>

#include "core/base/units.hpp"

namespace asperity {
namespace {

/// A stiffness in MPa as GPa.
template <FeatureValue (*read)(const CurveShape&)>
FeatureValue in_gpa(const CurveShape& shape) {
  FeatureValue value = read(shape);
  if (value.value) *value.value /= units::kMpaPerGpa;
  return value;
}

constexpr FeatureKind kCompression[] = {
    {"peak_axial_stress_mpa", "MPa", "(F4)", "largest axial stress, total", peak_load},
    {"peak_axial_strain", "1", "(F4)", "axial strain there, as recorded", peak_path},
    {"peak_strain_from_toe", "1", "(F6)", "axial strain there, from the start of the modulus line", peak_path_from_toe},
    {"youngs_modulus_gpa", "GPa", "(M4)", "modulus by a gauge on the specimen", gauge_modulus},
    {"poissons_ratio", "1", "(M4)", "lateral over axial strain by gauges on the specimen", gauge_ratio},
    {"axial_modulus_gpa", "GPa", "(F5)", "modulus by the axial strain as recorded, the platens' if there is no gauge",
     in_gpa<window_stiffness>},
    {"initial_modulus_gpa", "GPa", "(F7)", "stiffness between 0.05 and 0.2 of the peak", in_gpa<initial_stiffness>},
    {"late_stiffness_ratio", "1", "(F10)",
     "stiffness between 0.55 and 0.85 of the peak over that in the modulus window", late_stiffness_ratio},
    {"toe_offset_strain", "1", "(F6)", "path at which the modulus line starts", toe_offset},
    {"toe_travel_strain", "1", "(F8)", "path by which the toe is longer than the modulus line", toe_travel},
    {"toe_extent_share", "1", "(F9)", "share of the peak load over which the toe reaches, area over travel",
     toe_extent},
    {"nonlinearity_stress_mpa", "MPa", "(F11)", "load at which the secant stiffness from the toe has fallen by a tenth",
     nonlinearity_load},
    {"lateral_ratio", "1", "(F12)", "lateral over axial strain as recorded, in the modulus window", lateral_ratio},
    {"late_lateral_ratio", "1", "(F12)", "the same between 0.55 and 0.85 of the peak", late_lateral_ratio},
    {"lateral_nonlinearity_stress_mpa", "MPa", "(F13)", "stress at which the lateral strain is a ninth above its line",
     lateral_nonlinearity_load},
    {"peak_lateral_strain", "1", "(F14)", "lateral strain at the peak", peak_lateral_strain},
    {"drop_share", "1", "(F15)", "share of the peak lost over a fifth of the strain to it, from 0.95 of it on",
     drop_share},
    {"softening_strain", "1", "(F16)", "strain over which the stress falls from 0.9 to 0.5 of the peak",
     softening_path},
    {"residual_axial_stress_mpa", "MPa", "(F17)", "mean over the last quarter of the strain, total", residual_load},
    {"events_at_peak", "1", "(F22)", "acoustic events up to the peak", events_at_peak},
    {"event_share_at_half", "1", "(F22)", "share of them before half the peak load", event_share_at_half},
    {"event_share_at_four_fifths", "1", "(F22)", "share of them before 0.8 of the peak load",
     event_share_at_four_fifths},
    {"event_onset_share", "1", "(F22)", "share of the peak load at which a tenth of them has come", event_onset},
    {"loop_count", "1", "(F1)", "unloadings with a reload", loop_count},
    {"unloading_modulus_gpa", "GPa", "(F23)", "stiffness on unloading", in_gpa<unloading_stiffness>},
    {"reloading_modulus_gpa", "GPa", "(F23)", "stiffness on reloading", in_gpa<reloading_stiffness>},
    {"reload_toe_travel_strain", "1", "(F24)", "toe of the reload", reload_toe_travel},
    {"permanent_strain", "1", "(F25)", "path that a loop leaves behind at small load", permanent_path},
    {"largest_axial_stress_mpa", "MPa", "(F28)", "largest axial stress up to the limit, total, peak or not",
     largest_load},
};

constexpr FeatureKind kDisc[] = {
    {"tensile_strength_mpa", "MPa", "(M7)", "splitting stress at the largest load", splitting_strength},
    {"peak_load_n_per_mm", "N/mm", "(F4)", "largest load a thickness", peak_load},
    {"peak_closure_mm", "mm", "(F4)", "platen displacement there, as recorded", peak_path},
    {"peak_closure_from_toe_mm", "mm", "(F6)", "platen displacement there, from the start of the stiffness line",
     peak_path_from_toe},
    {"first_drop_stress_mpa", "MPa", "(M28)", "splitting stress from which the load first falls by a tenth",
     first_drop_stress},
    {"stiffness_n_per_mm2", "N/mm2", "(F5)", "load a thickness over platen displacement, in the modulus window",
     window_stiffness},
    {"initial_stiffness_n_per_mm2", "N/mm2", "(F7)", "stiffness between 0.05 and 0.2 of the peak", initial_stiffness},
    {"late_stiffness_ratio", "1", "(F10)",
     "stiffness between 0.55 and 0.85 of the peak over that in the modulus window", late_stiffness_ratio},
    {"toe_offset_mm", "mm", "(F6)", "path at which the modulus line starts", toe_offset},
    {"toe_travel_mm", "mm", "(F8)", "path by which the toe is longer than the modulus line", toe_travel},
    {"toe_extent_share", "1", "(F9)", "share of the peak load over which the toe reaches, area over travel",
     toe_extent},
    {"nonlinearity_load_n_per_mm", "N/mm", "(F11)",
     "load at which the secant stiffness from the toe has fallen by a tenth", nonlinearity_load},
    {"drop_share", "1", "(F15)", "share of the peak lost over a fifth of the displacement to it, from 0.95 of it on",
     drop_share},
    {"softening_mm", "mm", "(F16)", "displacement over which the load falls from 0.9 to 0.5 of the peak",
     softening_path},
    {"residual_load_n_per_mm", "N/mm", "(F17)", "mean over the last quarter of the displacement", residual_load},
    {"events_at_peak", "1", "(F22)", "acoustic events up to the peak", events_at_peak},
    {"event_share_at_half", "1", "(F22)", "share of them before half the peak load", event_share_at_half},
    {"event_share_at_four_fifths", "1", "(F22)", "share of them before 0.8 of the peak load",
     event_share_at_four_fifths},
    {"event_onset_share", "1", "(F22)", "share of the peak load at which a tenth of them has come", event_onset},
    {"loop_count", "1", "(F1)", "unloadings with a reload", loop_count},
    {"unloading_stiffness_n_per_mm2", "N/mm2", "(F23)", "stiffness on unloading", unloading_stiffness},
    {"reloading_stiffness_n_per_mm2", "N/mm2", "(F23)", "stiffness on reloading", reloading_stiffness},
    {"reload_toe_travel_mm", "mm", "(F24)", "toe of the reload", reload_toe_travel},
    {"permanent_mm", "mm", "(F25)", "path that a loop leaves behind at small load", permanent_path},
};

constexpr FeatureKind kJoint[] = {
    {"peak_shear_stress_mpa", "MPa", "(F4)", "largest shear stress", peak_load},
    {"peak_shear_displacement_mm", "mm", "(F4)", "shear displacement there, as recorded", peak_path},
    {"peak_displacement_from_toe_mm", "mm", "(F6)", "shear displacement there, from the start of the stiffness line",
     peak_path_from_toe},
    {"shear_stiffness_mpa_per_mm", "MPa/mm", "(F5)", "shear stress over displacement, in the modulus window",
     window_stiffness},
    {"initial_shear_stiffness_mpa_per_mm", "MPa/mm", "(F7)", "stiffness between 0.05 and 0.2 of the peak",
     initial_stiffness},
    {"late_stiffness_ratio", "1", "(F10)",
     "stiffness between 0.55 and 0.85 of the peak over that in the modulus window", late_stiffness_ratio},
    {"toe_offset_mm", "mm", "(F6)", "path at which the modulus line starts", toe_offset},
    {"toe_travel_mm", "mm", "(F8)", "path by which the toe is longer than the modulus line", toe_travel},
    {"toe_extent_share", "1", "(F9)", "share of the peak load over which the toe reaches, area over travel",
     toe_extent},
    {"nonlinearity_stress_mpa", "MPa", "(F11)", "load at which the secant stiffness from the toe has fallen by a tenth",
     nonlinearity_load},
    {"drop_share", "1", "(F15)", "share of the peak lost over a fifth of the displacement to it, from 0.95 of it on",
     drop_share},
    {"softening_mm", "mm", "(F16)", "displacement over which the stress falls from 0.9 to 0.5 of the peak",
     softening_path},
    {"residual_shear_stress_mpa", "MPa", "(F17)", "mean over the last quarter of the displacement", residual_load},
    {"drop_count", "1", "(F18)", "falls by a tenth of the peak or more", drop_count},
    {"largest_drop_mpa", "MPa", "(F18)", "the largest of them", largest_drop},
    {"rise_after_drop_mpa", "MPa", "(F18)", "rise from the first one's end to the largest stress after it",
     rise_after_drop},
    {"peak_dilation_mm", "mm", "(F19)", "dilation at the peak", peak_dilation},
    {"end_dilation_mm", "mm", "(F19)", "dilation at the end", end_dilation},
    {"dilation_rate_before_peak", "1", "(F20)", "dilation over displacement, from 0.3 of the peak's displacement to it",
     dilation_rate_before_peak},
    {"dilation_rate_after_peak", "1", "(F20)", "the same from the peak's displacement to twice it",
     dilation_rate_after_peak},
    {"dilation_difference_at_peak_mm", "mm", "(F21)", "front less rear dilation at the peak",
     dilation_difference_at_peak},
    {"dilation_difference_rate", "1", "(F21)", "its slope over displacement before the peak", dilation_difference_rate},
    {"events_at_peak", "1", "(F22)", "acoustic events up to the peak", events_at_peak},
    {"event_share_at_half", "1", "(F22)", "share of them before half the peak load", event_share_at_half},
    {"event_share_at_four_fifths", "1", "(F22)", "share of them before 0.8 of the peak load",
     event_share_at_four_fifths},
    {"event_onset_share", "1", "(F22)", "share of the peak load at which a tenth of them has come", event_onset},
    {"loop_count", "1", "(F1)", "unloadings with a reload", loop_count},
    {"unloading_shear_stiffness_mpa_per_mm", "MPa/mm", "(F23)", "stiffness on unloading", unloading_stiffness},
    {"reloading_shear_stiffness_mpa_per_mm", "MPa/mm", "(F23)", "stiffness on reloading", reloading_stiffness},
    {"reload_toe_travel_mm", "mm", "(F24)", "toe of the reload", reload_toe_travel},
    {"permanent_mm", "mm", "(F25)", "path that a loop leaves behind at small load", permanent_path},
};

}  // namespace

std::span<const FeatureKind> feature_kinds(ExperimentType experiment) {
  switch (experiment) {
    case ExperimentType::brazilian:
      return kDisc;
    case ExperimentType::direct_shear:
      return kJoint;
    case ExperimentType::uniaxial:
    case ExperimentType::triaxial:
      break;
  }
  return kCompression;
}

const FeatureKind* find_feature_kind(ExperimentType experiment, std::string_view name) {
  const std::span<const FeatureKind> kinds = feature_kinds(experiment);
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const FeatureKind& k) { return k.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

std::vector<FeatureValue> read_features(const Curve& curve, const CurveReading& reading) {
  const CurveShape shape = shape_of(curve, reading);
  std::vector<FeatureValue> values;
  for (const FeatureKind& kind : feature_kinds(reading.experiment)) values.push_back(kind.value(shape));
  return values;
}

}  // namespace asperity
