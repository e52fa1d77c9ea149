#include "core/confrontation/next_tests.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/config/cross_checks.hpp"
#include "core/confrontation/known_confusions.hpp"
#include "core/confrontation/test_designs.hpp"
#include "core/confrontation/virtual_test.hpp"

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kMeshes = 4, kMostCauses = 3;
constexpr double kSpecimens = 5;  // that a laboratory would make of one kind

/// A design applied to one test, with what each cause predicts for it.
struct SimulatedDesign {
  const TestDesign* design = nullptr;
  std::size_t parent = 0;            ///< Of Evidence::tests.
  std::vector<Samples> predictions;  ///< By cause: meshes by slots.
};

/// How the specimens of the design are prepared where those of the test it changes were prepared so.
Preparation preparation_of(const TestDesign& design, const MeasuredTest& parent) {
  return both(parent.preparation, design.preparation);
}

/// The mechanisms of a cause in that test.
std::vector<MechanismConfig> mechanisms_in(const TestDesign& design, const MeasuredTest& parent, const RunConfig& run,
                                           const Candidate& candidate, double amplitude) {
  if (amplitude == 0.0 || candidate.id == design.switches_off || !can_act(run, candidate.id)) return {};
  return acting_in(preparation_of(design, parent), std::vector<MechanismConfig>{{candidate.id, amplitude, {}}});
}

/// Whether the laboratory has such specimens already, and does not keep their test back.
bool has_such_specimens(const MeasuredData& data, const TestDesign& design, const MeasuredTest& parent) {
  if (is_made(design.id, data)) return true;
  if (design.preparation == Preparation{}) return false;
  return std::any_of(data.tests.begin(), data.tests.end(), [&](const MeasuredTest& made) {
    return made.use != TestUse::hold_out && made.experiment == parent.experiment &&
           made.preparation == preparation_of(design, parent);
  });
}

Samples simulate(const ConfrontationConfig& config, const ConfrontationTask& task, const Confrontation& c,
                 const TestDesign& design, const RunConfig& run, std::size_t parent, const HypothesisFit& fit) {
  const Candidate& candidate = c.evidence.candidates[static_cast<std::size_t>(fit.causes.front())];
  const double amplitude = amplitude_of_run(candidate, fit.amplitude(0));
  const std::vector<double> theta = theta_at(config, c.centre + fit.coded);
  const TestEvidence& test = c.evidence.tests[parent];
  const MeasuredTest& measured = config.measured.tests[parent];
  Samples samples = Samples::Constant(static_cast<Index>(kMeshes), static_cast<Index>(test.slots.size()),
                                      std::numeric_limits<double>::quiet_NaN());
  std::vector<CampaignRun> runs;
  for (std::size_t mesh = 0; mesh < kMeshes; ++mesh) {
    const std::uint64_t seed = task.plan.fresh_seed + mesh;
    std::optional<RunConfig> legal = configured_if_legal(
        run, config.parameters, theta, mechanisms_in(design, measured, run, candidate, amplitude), seed);
    if (!legal) return samples;
    runs.push_back({design.id + " under " + candidate.id + ", mesh " + std::to_string(seed), std::move(*legal), 0.0});
  }
  const std::vector<RunFeatureValues> values = task.features("next tests: " + design.id, runs);
  for (std::size_t i = 0; i < kMeshes; ++i) samples.row(static_cast<Index>(i)) = slot_values(test, values[i]);
  return samples;
}

bool is_measured(const TestEvidence& test, Index slot) { return test.measured.col(slot).array().isFinite().any(); }

std::string_view name_of(const TestEvidence& test, Index slot) {
  return test.slots[static_cast<std::size_t>(slot)].kind->name;
}

/// What the design says of a feature that it adds; null of others.
const AddedFeature* added(const TestDesign& design, const TestEvidence& test, Index slot) {
  const auto found = std::find_if(design.records.begin(), design.records.end(),
                                  [&](const AddedFeature& f) { return f.name == name_of(test, slot); });
  return found == design.records.end() ? nullptr : &*found;
}

/// Slots that this laboratory would have of the test, and that every run of both causes gives.
std::vector<Index> common_slots(const TestDesign& design, const TestEvidence& parent, const Samples& a,
                                const Samples& b) {
  std::vector<Index> slots;
  for (Index s = 0; s < a.cols(); ++s) {
    const bool recorded = is_measured(parent, s) || added(design, parent, s);
    if (recorded && a.col(s).allFinite() && b.col(s).allFinite()) slots.push_back(s);
  }
  return slots;
}

/// Whether the test as it was made gives all that the design would add.
bool has_all(const TestDesign& design, const TestEvidence& made) {
  if (design.records.empty()) return false;
  for (Index s = 0; s < made.measured.cols(); ++s) {
    if (added(design, made, s) && !is_measured(made, s)) return false;
  }
  return true;
}

/// The rows of the fitted comparison in which the parent's slots stand; -1 of those that were not fitted.
std::vector<Index> fitted_rows(const Confrontation& c, const TestEvidence& parent, const std::vector<Index>& slots) {
  std::vector<Index> rows(slots.size(), -1);
  for (const ComparedTest& part : c.fitted.tests) {
    if (part.test != &parent) continue;
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const auto found = std::find(part.columns.begin(), part.columns.end(), slots[i]);
      if (found != part.columns.end()) rows[i] = part.first + (found - part.columns.begin());
    }
  }
  return rows;
}

/// Effects of the parameters on the parent's slots; zero where they were not fitted.
MatrixXd parent_effects(const Confrontation& c, const std::vector<Index>& rows) {
  MatrixXd effects = MatrixXd::Zero(static_cast<Index>(rows.size()), c.fitted.jacobian.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] >= 0) effects.row(static_cast<Index>(i)) = c.fitted.jacobian.row(rows[i]);
  }
  return effects;
}

/// Variance of one specimen: what the runs scatter about their own cause's mean, not below the floors.
VectorXd variances(const TestEvidence& test, const Samples& a, const Samples& b, const std::vector<Index>& slots) {
  VectorXd v(static_cast<Index>(slots.size()));
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Index s = slots[i];
    const double squares =
        (a.col(s).array() - a.col(s).mean()).square().sum() + (b.col(s).array() - b.col(s).mean()).square().sum();
    const double floor = test.slots[static_cast<std::size_t>(s)].floor_sd;
    v(static_cast<Index>(i)) = std::max(squares / (2.0 * (kMeshes - 1)), floor * floor);
  }
  return v;
}

/// Whether the test tells the two apart: of doubles, which a better fit does not, only the one made for it, Eq. (N25).
bool counts(const TestDesign& design, const Candidate& one, const Candidate& other) {
  const auto& doubles = one.doubles;
  const bool doubled = std::find(doubles.begin(), doubles.end(), other.id) != doubles.end();
  return !doubled || decides(design.id, one.id, other.id);
}

/// Variance of what was measured of the feature that is read like an added one; 0 where that was not fitted.
double variance_of_like(const Confrontation& c, const TestDesign& design, const TestEvidence& parent, Index slot) {
  const AddedFeature* feature = added(design, parent, slot);
  for (Index s = 0; feature && s < static_cast<Index>(parent.slots.size()); ++s) {
    const Index row = name_of(parent, s) == feature->like ? fitted_rows(c, parent, {s}).front() : -1;
    if (row >= 0) return c.scatter.covariance(row, row);
  }
  return 0.0;
}

/// Sigma of Eq. (N18): of what was fitted as it was measured there, correlations and instruments included, else of so
/// many specimens, each by itself, no better than what is read like it; and of the meshes that were run.
MatrixXd further_scatter(const Confrontation& c, const TestDesign& design, const TestEvidence& parent,
                         const VectorXd& variance, const std::vector<Index>& slots, const std::vector<Index>& rows) {
  MatrixXd covariance = variance.asDiagonal();
  covariance /= kSpecimens;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto at = static_cast<Index>(i);
    if (rows[i] < 0) covariance(at, at) = std::max(covariance(at, at), variance_of_like(c, design, parent, slots[i]));
    for (std::size_t j = 0; j < rows.size(); ++j) {
      if (rows[i] >= 0 && rows[j] >= 0) covariance(at, static_cast<Index>(j)) = c.scatter.covariance(rows[i], rows[j]);
    }
  }
  covariance.diagonal() += variance / static_cast<double>(kMeshes);
  return covariance;
}

/// D of Eq. (N18).
double distance(const Confrontation& c, const SimulatedDesign& design, std::size_t k, std::size_t l) {
  const TestEvidence& parent = c.evidence.tests[design.parent];
  const Samples &a = design.predictions[k], &b = design.predictions[l];
  const std::vector<Index> slots = common_slots(*design.design, parent, a, b);
  if (slots.empty()) return 0.0;
  VectorXd difference(static_cast<Index>(slots.size()));
  for (std::size_t i = 0; i < slots.size(); ++i)
    difference(static_cast<Index>(i)) = a.col(slots[i]).mean() - b.col(slots[i]).mean();
  const std::vector<Index> rows = fitted_rows(c, parent, slots);
  const MatrixXd effects = parent_effects(c, rows);
  const Index parameters = effects.cols();
  MatrixXd covariance = further_scatter(c, *design.design, parent, variances(parent, a, b, slots), slots, rows);
  for (const std::size_t cause : {k, l}) {
    const MatrixXd known = c.conclusion.kept[cause].covariance.topLeftCorner(parameters, parameters);
    covariance += effects * known * effects.transpose();
  }
  return std::sqrt(difference.dot(covariance.llt().solve(difference)));
}

const Candidate& candidate_of(const Confrontation& c, std::size_t kept) {
  return c.evidence.candidates[static_cast<std::size_t>(c.conclusion.kept[kept].causes.front())];
}

bool counts_for_any(const TestDesign& design, const Confrontation& c, std::size_t causes) {
  for (std::size_t k = 0; k < causes; ++k) {
    for (std::size_t l = k + 1; l < causes; ++l) {
      if (counts(design, candidate_of(c, k), candidate_of(c, l))) return true;
    }
  }
  return false;
}

std::vector<SimulatedDesign> simulate_designs(const ConfrontationConfig& config, const ConfrontationTask& task,
                                              const Confrontation& c, std::size_t causes) {
  std::vector<RunConfig> made;
  for (const MeasuredTest& test : config.measured.tests) made.push_back(virtual_test(config, test));
  const auto concerns = [&](const std::string& id) {
    return id.empty() || std::any_of(c.conclusion.kept.begin(), c.conclusion.kept.end(), [&](const HypothesisFit& f) {
             return c.evidence.candidates[static_cast<std::size_t>(f.causes.front())].id == id;
           });
  };
  std::vector<SimulatedDesign> simulated;
  for (const TestDesign& design : test_designs()) {
    if (!concerns(design.concerns) || !counts_for_any(design, c, causes)) continue;
    for (std::size_t t = 0; t < made.size(); ++t) {
      std::optional<RunConfig> run = design.change(made[t], made);
      if (!run || !cross_check(*run).empty() || has_all(design, c.evidence.tests[t])) continue;
      if (has_such_specimens(config.measured, design, config.measured.tests[t])) break;
      run->mechanisms = acting_in(design.preparation, run->mechanisms);
      SimulatedDesign s{&design, t, {}};
      for (std::size_t k = 0; k < causes; ++k)
        s.predictions.push_back(simulate(config, task, c, design, *run, t, c.conclusion.kept[k]));
      simulated.push_back(std::move(s));
      break;
    }
  }
  return simulated;
}

}  // namespace

std::vector<NextTest> next_tests(const ConfrontationConfig& config, const ConfrontationTask& task,
                                 const Confrontation& c) {
  std::vector<NextTest> tests;
  if (c.conclusion.status != VerdictStatus::indistinguishable) return tests;
  const std::size_t causes = std::min(c.conclusion.kept.size(), kMostCauses);
  const std::vector<SimulatedDesign> designs = simulate_designs(config, task, c, causes);
  for (std::size_t k = 0; k < causes; ++k) {
    for (std::size_t l = k + 1; l < causes; ++l) {
      for (const SimulatedDesign& design : designs) {
        if (!counts(*design.design, candidate_of(c, k), candidate_of(c, l))) continue;
        const double d = distance(c, design, k, l);
        const double probability = 0.5 * std::erfc(-0.5 * d / std::numbers::sqrt2);
        tests.push_back({design.design->id,
                         design.design->description,
                         config.measured.tests[design.parent].id,
                         {causes_text(c, c.conclusion.kept[k].causes), causes_text(c, c.conclusion.kept[l].causes)},
                         d,
                         probability});
      }
    }
  }
  std::stable_sort(tests.begin(), tests.end(),
                   [](const NextTest& a, const NextTest& b) { return a.distance > b.distance; });
  return tests;
}

}  // namespace asperity
