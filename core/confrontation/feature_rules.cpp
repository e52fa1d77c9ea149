#include "core/confrontation/feature_rules.hpp"

#include <algorithm>

namespace asperity {
namespace {

constexpr bool kLog = true, kPlain = false;
constexpr FloorUnit kMm = FloorUnit::length, kStrain = FloorUnit::strain;
constexpr FloorUnit kOwn = FloorUnit::feature;
constexpr double kGauge = 0.005;  ///< mm
constexpr std::string_view kLength = "5 micrometres: what a displacement gauge and its seat repeat";
constexpr std::string_view kCell = "1 %: a load cell's class and the specimen's area";
constexpr std::string_view kSlope = "1 %: a load cell's and a gauge's class in one slope";
constexpr std::string_view kPeakPath =
    "3 %: the curve is flat about its peak, so its place is ten times less sure than it";
constexpr std::string_view kRatio = "0.02: quotient of two slopes of 1 % each, and the windows' rows";
constexpr std::string_view kDrop = "0.05: a drop is as steep as the machine and the reading's interval let it be";
constexpr std::string_view kResidual = "5 %: a mean over a stretch of sliding that a single crack moves";
constexpr std::string_view kEvents = "10 %: the count depends on the threshold of the sensors";
constexpr std::string_view kShare = "0.03: what counting alone does to a half of 300 events, sqrt(0.25 / 300)";
constexpr std::string_view kLateral =
    "0.01, 3 % of a usual one: a lateral gauge reads a fifth of the axial path, and its noise can hide it";
constexpr std::string_view kDilation =
    "0.02: two slopes of gauges on the joint, at teeth that wear from the first contact on";
constexpr std::string_view kBend = "3 %: where a curve leaves its line, by a line of 1 %";
constexpr std::string_view kLateralPath = "5 %: a lateral gauge at the peak, whose place is less sure than it";
constexpr std::string_view kFall = "10 %: a fall is as deep as the machine lets it be";

constexpr FeatureRule kUniaxial[] = {
    {"peak_axial_stress_mpa", kLog, 0.01, kOwn, kCell},
    {"youngs_modulus_gpa", kLog, 0.01, kOwn, kSlope},
    {"axial_modulus_gpa", kLog, 0.01, kOwn, kSlope},
    {"peak_strain_from_toe", kLog, 0.03, kOwn, kPeakPath},
    {"toe_travel_strain", kPlain, kGauge, kStrain, kLength},
    {"late_stiffness_ratio", kPlain, 0.02, kOwn, kRatio},
    {"lateral_ratio", kPlain, 0.01, kOwn, kLateral},
    {"drop_share", kPlain, 0.05, kOwn, kDrop},
    {"events_at_peak", kLog, 0.1, kOwn, kEvents},
    {"event_share_at_half", kPlain, 0.03, kOwn, kShare},
    {"reload_toe_travel_strain", kPlain, kGauge, kStrain, kLength},
    {"permanent_strain", kPlain, kGauge, kStrain, kLength},
    {"nonlinearity_stress_mpa", kLog, 0.03, kOwn, kBend},
    {"peak_lateral_strain", kLog, 0.05, kOwn, kLateralPath},
};

constexpr FeatureRule kTriaxial[] = {
    kUniaxial[0],  kUniaxial[1],  kUniaxial[2],
    kUniaxial[3],  kUniaxial[4],  kUniaxial[5],
    kUniaxial[6],  kUniaxial[7],  {"residual_axial_stress_mpa", kLog, 0.05, kOwn, kResidual},
    kUniaxial[8],  kUniaxial[9],  kUniaxial[10],
    kUniaxial[11], kUniaxial[12], kUniaxial[13],
};

constexpr FeatureRule kDisc[] = {
    {"tensile_strength_mpa", kLog, 0.01, kOwn, kCell},      {"stiffness_n_per_mm2", kLog, 0.01, kOwn, kSlope},
    {"late_stiffness_ratio", kPlain, 0.02, kOwn, kRatio},   {"nonlinearity_load_n_per_mm", kLog, 0.03, kOwn, kBend},
    {"toe_travel_mm", kPlain, kGauge, kMm, kLength},        {"drop_share", kPlain, 0.05, kOwn, kDrop},
    {"events_at_peak", kLog, 0.1, kOwn, kEvents},           {"event_share_at_half", kPlain, 0.03, kOwn, kShare},
    {"reload_toe_travel_mm", kPlain, kGauge, kMm, kLength},
};

constexpr FeatureRule kJoint[] = {
    {"peak_shear_stress_mpa", kLog, 0.01, kOwn, kCell},
    {"peak_displacement_from_toe_mm", kLog, 0.03, kOwn, kPeakPath},
    {"shear_stiffness_mpa_per_mm", kLog, 0.01, kOwn, kSlope},
    {"toe_travel_mm", kPlain, kGauge, kMm, kLength},
    {"residual_shear_stress_mpa", kLog, 0.05, kOwn, kResidual},
    {"drop_share", kPlain, 0.05, kOwn, kDrop},
    {"dilation_rate_before_peak", kPlain, 0.02, kOwn, kDilation},
    {"end_dilation_mm", kPlain, kGauge, kMm, kLength},
    {"dilation_difference_at_peak_mm", kPlain, kGauge, kMm, kLength},
    {"events_at_peak", kLog, 0.1, kOwn, kEvents},
    {"nonlinearity_stress_mpa", kLog, 0.03, kOwn, kBend},
    {"largest_drop_mpa", kLog, 0.1, kOwn, kFall},
    {"peak_dilation_mm", kPlain, kGauge, kMm, kLength},
};

}  // namespace

std::span<const FeatureRule> feature_rules(ExperimentType experiment) {
  switch (experiment) {
    case ExperimentType::brazilian:
      return kDisc;
    case ExperimentType::direct_shear:
      return kJoint;
    case ExperimentType::triaxial:
      return kTriaxial;
    case ExperimentType::uniaxial:
      break;
  }
  return kUniaxial;
}

const FeatureRule* find_feature_rule(ExperimentType experiment, std::string_view name) {
  const std::span<const FeatureRule> rules = feature_rules(experiment);
  const auto found = std::find_if(rules.begin(), rules.end(), [&](const FeatureRule& r) { return r.name == name; });
  return found == rules.end() ? nullptr : &*found;
}

double floor_of(const FeatureRule& rule, const RunConfig& test) {
  return rule.unit == FloorUnit::strain ? rule.floor / test.experiment.height_mm : rule.floor;
}

}  // namespace asperity
