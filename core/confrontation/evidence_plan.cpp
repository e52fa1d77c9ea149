#include "core/confrontation/evidence_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Where a run's features go.
struct Place {
  Samples* samples = nullptr;
  Index row = 0;
  std::size_t test = 0;
};

struct PlannedRuns {
  std::vector<CampaignRun> runs;
  std::vector<Place> places;
};

std::string label_of(const TestEvidence& test, const std::string& what, std::uint64_t seed) {
  return test.id + ", " + what + ", mesh " + std::to_string(seed);
}

Samples no_values(Index rows, const TestEvidence& test) {
  return Samples::Constant(rows, static_cast<Index>(test.slots.size()), std::numeric_limits<double>::quiet_NaN());
}

std::size_t base_meshes(const EvidencePlan& plan, const TestEvidence& test) {
  const bool fitted = test.use == TestUse::fit;
  const std::size_t of_mean = fitted ? plan.noise : plan.fresh;
  const std::size_t of_effects = fitted || plan.kept_back_candidates ? plan.apart : 0;
  return of_mean == 0 ? 0 : of_effects + of_mean;
}

void add_rows(PlannedRuns& planned, Evidence& evidence, const EvidencePlan& plan, VirtualSpecimen specimen,
              std::size_t wanted, const std::string& what, Samples& samples, const ConfigureRun& configure) {
  const TestEvidence& test = evidence.tests[specimen.test];
  const std::size_t rows = std::min(wanted, base_meshes(plan, test));
  samples = no_values(static_cast<Index>(rows), test);
  for (std::size_t row = 0; row < rows; ++row) {
    specimen.seed = mesh_seed(plan, test, row);
    std::optional<RunConfig> run = configure(specimen);
    if (!run) continue;
    planned.runs.push_back({label_of(test, what, specimen.seed), std::move(*run), 0.0});
    planned.places.push_back({&samples, static_cast<Index>(row), specimen.test});
  }
}

/// Whether a step from the centre goes beyond what is believed of the parameter.
bool leaves_range(const CalibratedParameter& parameter, double step) {
  constexpr double kRounding = 1e-9;
  return step < parameter.lower - kRounding || step > parameter.upper + kRounding;
}

/// One step to each side; to one side alone where the other lies outside the range.
void plan_parameters(PlannedRuns& planned, Evidence& evidence, const EvidencePlan& plan, std::size_t t,
                     const VectorXd& centre, const ConfigureRun& configure) {
  TestEvidence& test = evidence.tests[t];
  test.low.assign(evidence.parameters.size(), no_values(0, test));
  test.high.assign(evidence.parameters.size(), no_values(0, test));
  for (std::size_t p = 0; p < evidence.parameters.size(); ++p) {
    if (!plan.parameter_acts[t][p]) continue;
    for (const double side : {-1.0, 1.0}) {
      if (leaves_range(evidence.parameters[p], side) && !leaves_range(evidence.parameters[p], -side)) continue;
      VectorXd coded = centre;
      coded(static_cast<Index>(p)) += side;
      add_rows(planned, evidence, plan, {t, coded, {}, 0}, plan.parameters,
               evidence.parameters[p].name + (side < 0.0 ? " low" : " high"), side < 0.0 ? test.low[p] : test.high[p],
               configure);
    }
  }
}

void plan_candidates(PlannedRuns& planned, Evidence& evidence, const EvidencePlan& plan, std::size_t t,
                     const VectorXd& centre, const ConfigureRun& configure) {
  TestEvidence& test = evidence.tests[t];
  test.mechanism.assign(evidence.candidates.size(), no_values(0, test));
  test.far.assign(evidence.candidates.size(), no_values(0, test));
  if (test.use == TestUse::hold_out && !plan.kept_back_candidates) return;
  for (std::size_t k = 0; k < evidence.candidates.size(); ++k) {
    if (!plan.candidate_acts[t][k] || plan.candidate_meshes[k] == 0) continue;
    const Candidate& c = evidence.candidates[k];
    add_rows(planned, evidence, plan, {t, centre, {{c.id, c.amplitude}}, 0}, plan.candidate_meshes[k], c.id,
             test.mechanism[k], configure);
    if (!plan.far || c.far == 0.0) continue;
    add_rows(planned, evidence, plan, {t, centre, {{c.id, c.far}}, 0}, plan.candidate_meshes[k],
             c.id + (c.far < 0.0 ? ", other way" : ", far"), test.far[k], configure);
  }
}

}  // namespace

std::uint64_t mesh_seed(const EvidencePlan& plan, const TestEvidence& test, std::size_t row) {
  return (test.use == TestUse::fit ? plan.first_seed : plan.fresh_seed) + row;
}

Eigen::RowVectorXd slot_values(const TestEvidence& test, const RunFeatureValues& features) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Constant(static_cast<Index>(test.slots.size()), kNone);
  const std::span<const FeatureKind> kinds = feature_kinds(test.experiment);
  for (std::size_t s = 0; s < test.slots.size(); ++s) {
    const FeatureKind* read = test.slots[s].simulated ? test.slots[s].simulated : test.slots[s].kind;
    const auto k = static_cast<std::size_t>(read - kinds.data());
    if (k >= features.size() || !features[k]) continue;
    const double value = *features[k];
    if (!test.slots[s].logarithmic) row(static_cast<Index>(s)) = value;
    if (test.slots[s].logarithmic && value > 0.0) row(static_cast<Index>(s)) = std::log(value);
  }
  return row;
}

void simulate_evidence(Evidence& evidence, const EvidencePlan& plan, const VectorXd& centre, const std::string& stage,
                       const ConfigureRun& configure, const FeaturesOf& features) {
  PlannedRuns planned;
  for (std::size_t t = 0; t < evidence.tests.size(); ++t) {
    if (base_meshes(plan, evidence.tests[t]) == 0) continue;
    evidence.tests[t].apart = static_cast<Index>(plan.apart);
    add_rows(planned, evidence, plan, {t, centre, {}, 0}, base_meshes(plan, evidence.tests[t]), "base",
             evidence.tests[t].base, configure);
    if (!plan.effects) continue;
    plan_parameters(planned, evidence, plan, t, centre, configure);
    plan_candidates(planned, evidence, plan, t, centre, configure);
  }
  const std::vector<RunFeatureValues> values = features(stage, planned.runs);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Place& place = planned.places[i];
    place.samples->row(place.row) = slot_values(evidence.tests[place.test], values[i]);
  }
}

Samples simulate_specimens(const TestEvidence& test, const std::vector<VirtualSpecimen>& specimens,
                           const std::string& stage, const ConfigureRun& configure, const FeaturesOf& features) {
  std::vector<CampaignRun> runs;
  std::vector<Index> rows;
  for (std::size_t i = 0; i < specimens.size(); ++i) {
    std::optional<RunConfig> run = configure(specimens[i]);
    if (!run) continue;
    runs.push_back({label_of(test, stage, specimens[i].seed), std::move(*run), 0.0});
    rows.push_back(static_cast<Index>(i));
  }
  const std::vector<RunFeatureValues> values = features(stage, runs);
  Samples samples = no_values(static_cast<Index>(specimens.size()), test);
  for (std::size_t i = 0; i < values.size(); ++i) samples.row(rows[i]) = slot_values(test, values[i]);
  return samples;
}

}  // namespace asperity
