#include "core/confrontation/confrontation_task.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/config/mechanism_declaration.hpp"
#include "core/confrontation/feature_rules.hpp"
#include "core/confrontation/known_confusions.hpp"
#include "core/confrontation/test_features.hpp"
#include "core/confrontation/virtual_test.hpp"

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kStep = 0.6;            // of the declared strong amplitude: the method's finite difference
constexpr double kWhole = 1.0;           // where a parameter takes whole numbers
constexpr double kMostAmplitude = 3.0;   // times the declared strong one
constexpr double kReferenceReach = 4.0;  // steps about the reference in which effects there still hold
constexpr double kPercent = 0.01;

double transformed(const FeatureSlot& slot, double value) {
  if (!slot.logarithmic) return value;
  return value > 0.0 ? std::log(value) : std::numeric_limits<double>::quiet_NaN();
}

/// Mean over specimens of a standard deviation by instruments, in the slot's unit.
double instrument_error(const FeatureSlot& slot, const TestFeature& feature, const MeasuredTest& test,
                        double SpecimenValue::*deviation) {
  double sum = 0.0;
  for (const SpecimenValue& s : feature.specimens) {
    if (!s.value) continue;
    const bool stress = slot.kind->unit == "MPa" || slot.kind->unit == "N/mm";
    const double sd =
        s.from_results && stress ? kPercent * test.instrument.load_scale_percent * std::abs(*s.value) : s.*deviation;
    sum += slot.logarithmic && *s.value > 0.0 ? sd / *s.value : sd;
  }
  return feature.count > 0 ? sum / feature.count : 0.0;
}

/// Standard deviation that the noise of a specimen's rows makes, Eq. (N24), in the slot's unit.
double noise_error(const FeatureSlot& slot, const TestFeature& feature) {
  double square = 0.0;
  for (const SpecimenValue& s : feature.specimens) {
    if (!s.value) continue;
    square += std::pow(slot.logarithmic && *s.value > 0.0 ? s.noise_sd / *s.value : s.noise_sd, 2);
  }
  return feature.count > 0 ? std::sqrt(square / feature.count) : 0.0;
}

void take_measured(TestEvidence& evidence, const MeasuredTest& test) {
  const std::vector<TestFeature> features = features_of(test);
  const std::span<const FeatureKind> kinds = feature_kinds(test.experiment);
  const auto specimens = static_cast<Index>(features.front().specimens.size());
  evidence.measured.resize(specimens, static_cast<Index>(evidence.slots.size()));
  evidence.instrument_sd.resize(static_cast<Index>(evidence.slots.size()));
  evidence.own_sd.resize(static_cast<Index>(evidence.slots.size()));
  for (std::size_t s = 0; s < evidence.slots.size(); ++s) {
    const FeatureSlot& slot = evidence.slots[s];
    const auto kind = static_cast<std::size_t>(slot.kind - kinds.data());
    const TestFeature& feature = features[kind];
    const auto column = static_cast<Index>(s);
    const double shared = instrument_error(slot, feature, test, &SpecimenValue::scale_sd);
    const double all = instrument_error(slot, feature, test, &SpecimenValue::instrument_sd);
    const double own = std::max(0.0, all * all - shared * shared) + std::pow(noise_error(slot, feature), 2);
    evidence.own_sd(column) = std::sqrt(own);
    evidence.instrument_sd(column) = std::sqrt(shared * shared + own / std::max(1, feature.count));
    for (Index i = 0; i < specimens; ++i) {
      const auto& value = feature.specimens[static_cast<std::size_t>(i)].value;
      evidence.measured(i, column) = value ? transformed(slot, *value) : std::numeric_limits<double>::quiet_NaN();
    }
  }
}

/// A strength without a curve may be that of a specimen that flows, so a run's largest stress is read beside it.
const FeatureKind* flow_strength(const MeasuredTest& test, const std::string& name) {
  if (!test.curves.empty() || name != "peak_axial_stress_mpa") return nullptr;
  return find_feature_kind(test.experiment, "largest_axial_stress_mpa");
}

TestEvidence test_evidence(const ConfrontationConfig& config, const MeasuredTest& test, const RunConfig& run) {
  TestEvidence evidence;
  evidence.id = test.id;
  evidence.experiment = test.experiment;
  evidence.use = test.use.value_or(TestUse::fit);
  evidence.scatter = test.scatter;
  for (const std::string& name : config.features.at(test.experiment)) {
    const FeatureRule& rule = *find_feature_rule(test.experiment, name);
    evidence.slots.push_back(
        {find_feature_kind(test.experiment, name), rule.logarithmic, floor_of(rule, run), flow_strength(test, name)});
  }
  take_measured(evidence, test);
  return evidence;
}

std::vector<CalibratedParameter> calibrated_parameters(const ConfrontationConfig& config) {
  std::vector<CalibratedParameter> parameters;
  for (const ConfrontationParameter& p : config.parameters) {
    if (!p.calibrated) continue;
    const double reference = theta_of(p.transform, p.reference);
    CalibratedParameter c{p.name, (theta_of(p.transform, p.lower) - reference) / p.step,
                          (theta_of(p.transform, p.upper) - reference) / p.step};
    if (config.linearise_at == LineariseAt::reference) {
      c.lower = std::max(c.lower, -kReferenceReach);
      c.upper = std::min(c.upper, kReferenceReach);
    }
    parameters.push_back(std::move(c));
  }
  return parameters;
}

bool within(const MechanismParameter& parameter, double amplitude) {
  if (parameter.reciprocal) return amplitude > 0.0 && parameter.strong / amplitude >= parameter.lowest;
  if (!parameter.neutral) return true;
  const double value = *parameter.neutral + amplitude * (parameter.strong - *parameter.neutral);
  return value >= parameter.lowest && value <= parameter.highest;
}

/// Largest amplitude in steps of 0.05 that all ranges allow.
double most_amplitude(const MechanismDeclaration& declaration, bool two_sided) {
  constexpr double kGrain = 0.05;
  double most = 0.0;
  for (int i = 1; i * kGrain <= kMostAmplitude + 1e-9; ++i) {
    const double a = i * kGrain;
    const auto allowed = [&](const MechanismParameter& p) { return within(p, a) && (!two_sided || within(p, -a)); };
    if (!std::all_of(declaration.parameters.begin(), declaration.parameters.end(), allowed)) break;
    most = a;
  }
  return most;
}

bool takes_whole_numbers(const MechanismDeclaration& declaration) {
  return std::any_of(declaration.parameters.begin(), declaration.parameters.end(),
                     [](const MechanismParameter& p) { return p.whole; });
}

EvidencePlan plan_of(const ConfrontationConfig& config, const Evidence& evidence, const std::vector<RunConfig>& runs) {
  EvidencePlan plan;
  plan.noise = config.meshes.noise;
  plan.fresh = config.meshes.fresh;
  plan.parameters = config.meshes.common;
  plan.first_seed = config.meshes.first_seed;
  plan.fresh_seed = config.meshes.first_seed + 500000;
  plan.candidate_meshes.assign(evidence.candidates.size(), config.meshes.common);
  plan.far = config.linearise_at == LineariseAt::reference;
  plan.apart = config.meshes.common;
  for (std::size_t t = 0; t < evidence.tests.size(); ++t) {
    plan.parameter_acts.emplace_back();
    plan.candidate_acts.emplace_back();
    for (const ConfrontationParameter& p : config.parameters) {
      if (p.calibrated) plan.parameter_acts.back().push_back(acts_in(p, evidence.tests[t].experiment));
    }
    for (const Candidate& c : evidence.candidates)
      plan.candidate_acts.back().push_back(can_act(config.measured.tests[t], runs[t], c.id));
  }
  return plan;
}

/// In alphabetical order, so that a pair is one run however its causes were found.
std::vector<MechanismConfig> entries(const std::vector<MechanismAmplitude>& mechanisms) {
  std::vector<MechanismConfig> list;
  for (const MechanismAmplitude& m : mechanisms) list.push_back({m.id, m.amplitude, {}});
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.type < b.type; });
  return list;
}

/// The smallest amplitude whose reciprocal parameters are still within their ranges.
double least_amplitude(const MechanismDeclaration& declaration) {
  double least = 0.0;
  for (const MechanismParameter& p : declaration.parameters) {
    if (p.reciprocal) least = std::max(least, p.strong / p.highest);
  }
  return least;
}

/// As far to the other side of a setting that may be off either way; else twice the first amplitude where ranges allow
/// that or nearly so.
double far_amplitude(double amplitude, double most, bool two_sided) {
  constexpr double kFar = 2.0, kWorthwhile = 1.5;
  if (two_sided) return -std::min(amplitude, most);
  const double far = std::min(kFar * amplitude, most);
  return far >= kWorthwhile * amplitude ? far : 0.0;
}

}  // namespace

std::vector<Candidate> library_candidates(const std::vector<std::string>& ids) {
  std::vector<Candidate> candidates;
  for (const std::string& id : ids) {
    const MechanismDeclaration& declaration = *find_mechanism(id);
    const bool whole = takes_whole_numbers(declaration);
    const bool two_sided = declaration.suspect && !whole;
    const double most = whole ? kWhole : most_amplitude(declaration, two_sided);
    candidates.push_back({id,
                          whole ? kWhole : kStep,
                          two_sided,
                          declaration.suspect,
                          most,
                          least_amplitude(declaration),
                          whole,
                          whole ? 0.0 : far_amplitude(kStep, most, two_sided),
                          {}});
  }
  return candidates;
}

std::vector<double> theta_at(const ConfrontationConfig& config, const VectorXd& coded) {
  std::vector<double> theta = reference_theta(config.parameters);
  Index c = 0;
  for (std::size_t p = 0; p < theta.size(); ++p) {
    if (config.parameters[p].calibrated) theta[p] += config.parameters[p].step * coded(c++);
  }
  return theta;
}

ConfrontationTask confrontation_task(const ConfrontationConfig& config, FeaturesOf features) {
  ConfrontationTask task;
  const auto runs = std::make_shared<std::vector<RunConfig>>();
  for (const MeasuredTest& test : config.measured.tests) {
    runs->push_back(virtual_test(config, test));
    task.evidence.tests.push_back(test_evidence(config, test, runs->back()));
  }
  task.evidence.parameters = calibrated_parameters(config);
  task.evidence.candidates = library_candidates(config.mechanisms);
  for (Candidate& c : task.evidence.candidates) {
    c.doubles = doubles_of(c.id, config.measured);
    c.tested_doubles = tested_doubles_of(c.id, config.measured);
  }
  task.plan = plan_of(config, task.evidence, *runs);
  task.linearised_at =
      config.linearise_at == LineariseAt::reference ? LinearisedAt::reference : LinearisedAt::calibrated;
  task.common = config.meshes.common;
  task.screen = std::min(config.meshes.screen, config.meshes.common);
  task.options.draws.draws = static_cast<int>(config.draws);
  task.options.draws.explained_level = config.alarm_level;
  task.options.draws.seed = config.seed;
  task.configure = [runs, config](const VirtualSpecimen& specimen) {
    const Preparation& preparation = config.measured.tests[specimen.test].preparation;
    return configured_if_legal((*runs)[specimen.test], config.parameters, theta_at(config, specimen.coded),
                               acting_in(preparation, entries(specimen.mechanisms)), specimen.seed);
  };
  task.features = std::move(features);
  return task;
}

}  // namespace asperity
