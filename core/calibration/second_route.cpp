#include <algorithm>
#include <cmath>

#include "core/calibration/simulated_parts.hpp"

namespace asperity {
namespace {

/// Targets as the second route takes them: a weight below 1 is a standard error, Eq. (V3).
std::vector<Target> widened_targets(std::vector<Target> targets) {
  for (Target& t : targets) {
    const double more = t.value * t.tolerance * (1.0 / t.weight - 1.0);
    t.standard_error = std::hypot(t.standard_error, more);
  }
  return targets;
}

double residual_sd(const ResponseModel& model) { return model.reduced.residual_sd; }

Refinement begin_refinement(const SimulatedCalibration& c, const DesignRound& round, RefinementOptions& options) {
  const std::vector<Target> targets = widened_targets(strength_targets(c.targets));
  options.region = {c.analysis.region, round.design.alpha};
  options.level = c.analysis.level;
  options.prior_sd = round.design.alpha;
  std::vector<double> noise;
  std::vector<std::vector<double>> y(round.design.coded.size());
  for (const Target& target : targets) {
    const auto model = std::find_if(round.analysis.models.begin(), round.analysis.models.end(),
                                    [&](const ResponseModel& m) { return m.name == target.property; });
    noise.push_back(residual_sd(*model));
    const auto response = std::find_if(round.responses.list.begin(), round.responses.list.end(),
                                       [&](const Response& r) { return r.name == target.property; });
    for (std::size_t row = 0; row < y.size(); ++row) y[row].push_back(response->values[row]);
  }
  return start_refinement(targets, noise, round.design.coded, y, options);
}

/// Real runs at a point of the last design.
Batch run_batch(const SimulatedCalibration& c, const SimulatedResult& result, const Refinement& refinement,
                const std::vector<double>& x, const Simulator& simulate, SuiteCost& cost) {
  const std::size_t number = refinement.steps.size() + 1;
  const std::vector<double> real = decode(result.rounds.back().design.factors, x);
  std::vector<SuiteCase> cases;
  for (std::size_t i = 0; i < c.refinement.batch; ++i) {
    cases.push_back({"refinement " + std::to_string(number), parameter_set(result.elastic, c.factors, real),
                     c.first_seed + kRefinementSeeds + (number - 1) * c.refinement.batch + i});
  }
  Batch batch{x, {}};
  const std::string stage = c.name + ": refinement " + std::to_string(number);
  for (const CaseResult& found : run_suite(c.suite, cases, stage, simulate, cost)) {
    std::vector<double> row;
    for (const Target& target : refinement.targets) row.push_back(found.property(target.property));
    batch.y.push_back(std::move(row));
  }
  return batch;
}

std::size_t runs_of_designs(const SimulatedCalibration& c, const SimulatedResult& result) {
  std::size_t rows = 0;
  for (const DesignRound& round : result.rounds) rows += round.design.coded.size();
  return rows * c.suite.tests.size();
}

}  // namespace

void refine(const SimulatedCalibration& c, const Simulator& simulate, SimulatedResult& result) {
  const DesignRound& round = result.rounds.back();
  const std::vector<Factor>& factors = round.design.factors;
  RefinementOptions options = c.refinement;
  Refinement refinement = begin_refinement(c, round, options);
  const std::vector<double> first = solution_of(round.analysis).point.x;
  const auto step = [&](const std::vector<double>& x) {
    refinement = update(refinement, run_batch(c, result, refinement, x, simulate, result.cost), options);
    return misfit(refinement.steps.back().mean, strength_targets(c.targets));
  };
  const std::size_t designed = runs_of_designs(c, result), batch = c.refinement.batch * c.suite.tests.size();
  result.quadratic = {decode(factors, first), {}, designed + batch, step(first)};
  result.kriging = result.quadratic;
  while (!refinement.done && refinement.steps.size() < c.refinement.most_steps) {
    const std::vector<double> x = propose(refinement);
    const double miss = step(x);
    if (miss < result.kriging.misfit || result.kriging.sd.empty()) {
      result.kriging = {decode(factors, x), {}, 0, miss};
      for (double sd : refinement.steps.back().sd) result.kriging.sd.push_back(sd);
    }
  }
  for (std::size_t j = 0; j < result.kriging.sd.size(); ++j) {
    const double high = decode(factors[j], encode(factors[j], result.kriging.real[j]) + result.kriging.sd[j]);
    result.kriging.sd[j] = high - result.kriging.real[j];
  }
  result.kriging.runs = designed + refinement.steps.size() * batch;
  result.refinement = std::move(refinement);
  const bool second = result.kriging.misfit < result.quadratic.misfit;
  result.chosen_route = second ? "kriging" : "quadratic";
  result.chosen = second ? result.kriging.real : result.quadratic.real;
}

double misfit(const std::vector<double>& means, const std::vector<Target>& targets) {
  constexpr double kLost = 10.0;
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Target& t = targets[i];
    const double miss = std::isfinite(means[i]) ? (means[i] - t.value) / (t.tolerance * t.value) : kLost;
    sum += t.weight * miss * miss;
    weights += t.weight;
  }
  return std::sqrt(sum / weights);
}

}  // namespace asperity
