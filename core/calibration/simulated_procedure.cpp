#include "core/calibration/simulated_procedure.hpp"

#include <algorithm>
#include <cmath>

#include "core/calibration/simulated_parts.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity {
namespace {

constexpr std::uint64_t kSeedsOfRound = 100;  // apart: rows of one design get consecutive meshes

std::vector<double> centre_of(const std::vector<Factor>& factors) {
  std::vector<double> real;
  for (const Factor& factor : factors) real.push_back(factor.centre);
  return real;
}

Responses gather(const std::vector<CaseResult>& results) {
  Responses responses;
  for (const CaseResult& result : results) {
    for (const auto& [name, value] : result.properties) {
      const auto same = [&n = name](const Response& r) { return r.name == n; };
      if (std::none_of(responses.list.begin(), responses.list.end(), same)) responses.list.push_back({name, {}, {}});
    }
    responses.bad_runs.insert(responses.bad_runs.end(), result.bad_runs.begin(), result.bad_runs.end());
  }
  for (Response& response : responses.list) {
    for (const CaseResult& result : results) response.values.push_back(result.property(response.name));
  }
  return responses;
}

/// Rows of earlier designs that lie inside the new one: their runs count again, in the new coding.
void take_over(DesignRound& round, const std::vector<DesignRound>& earlier) {
  for (const DesignRound& old : earlier) {
    for (std::size_t row = 0; row < old.design.coded.size(); ++row) {
      std::vector<double> coded;
      double square = 0.0;
      const std::vector<double> real = decode(old.design.factors, old.design.coded[row]);
      for (std::size_t j = 0; j < real.size(); ++j) {
        coded.push_back(encode(round.design.factors[j], real[j]));
        square += coded.back() * coded.back();
      }
      const auto known = std::find(round.seeds.begin(), round.seeds.end(), old.seeds[row]);
      if (square > round.design.alpha * round.design.alpha || known != round.seeds.end()) continue;
      round.design.coded.push_back(coded);
      round.design.kind.push_back(PointKind::factorial);
      round.seeds.push_back(old.seeds[row]);
      for (Response& response : round.responses.list) {
        const auto same = [&](const Response& r) { return r.name == response.name; };
        const auto from = std::find_if(old.responses.list.begin(), old.responses.list.end(), same);
        response.values.push_back(from == old.responses.list.end() ? NAN : from->values[row]);
      }
    }
  }
}

DesignRound run_design(const SimulatedCalibration& c, const ElasticPart& elastic, std::vector<Factor> factors,
                       const std::vector<DesignRound>& earlier, const Simulator& simulate, SuiteCost& cost) {
  const std::string stage = "design " + std::to_string(earlier.size() + 1);
  DesignRound round;
  round.design = central_composite(std::move(factors), c.star, c.centre_points);
  std::vector<SuiteCase> cases;
  for (std::size_t row = 0; row < round.design.coded.size(); ++row) {
    round.seeds.push_back(c.first_seed + kSeedsOfRound * earlier.size() + row);
    cases.push_back({stage + ", row " + std::to_string(row + 1),
                     parameter_set(elastic, c.factors, decode(round.design.factors, round.design.coded[row])),
                     round.seeds.back()});
  }
  round.responses = gather(run_suite(c.suite, cases, c.name + ": " + stage, simulate, cost));
  take_over(round, earlier);
  round.analysis = analyse(round.design, round.responses, strength_targets(c.targets), c.analysis);
  return round;
}

/// Designs until one holds a solution, none can be moved, or there were enough.
void run_designs(const SimulatedCalibration& c, const Simulator& simulate, SimulatedResult& result) {
  std::vector<Factor> factors = c.factors;
  double moved_by = 0.0;
  while (result.rounds.size() < c.most_rounds) {
    result.rounds.push_back(run_design(c, result.elastic, factors, result.rounds, simulate, result.cost));
    DesignRound& round = result.rounds.back();
    round.moved_by = moved_by;
    if (!round.analysis.solutions.empty() || !round.analysis.move || round.analysis.move->moved_by == 0.0) return;
    factors = round.analysis.move->factors;
    moved_by = round.analysis.move->moved_by;
  }
}

/// Says where the disc's target lies beyond what a brittle Mohr-Coulomb material reaches, Eq. (V4).
void note_disc_bound(const std::vector<Target>& targets, std::vector<std::string>& warnings) {
  const Target *disc = find_target(targets, "tensile_strength_mpa"),
               *strength = find_target(targets, "uniaxial_strength_mpa"),
               *friction = find_target(targets, "friction_angle_deg");
  if (!disc || !strength || !friction) return;
  const double bound = mohr_coulomb_disc_strength(strength->value, friction->value);
  if (disc->value <= bound) return;
  warnings.push_back("the target tensile_strength_mpa = " + number_text(disc->value) +
                     " lies above uniaxial strength / (3 + tan^2(45 deg + phi/2)) = " + number_text(bound) +
                     ", at which the centre of an elastic disc reaches the targets' own Mohr-Coulomb line: only stable "
                     "crack growth beyond that can carry it");
}

void note_warnings(const SimulatedCalibration& c, SimulatedResult& result) {
  const DesignRound& last = result.rounds.back();
  result.warnings = last.analysis.warnings;
  note_disc_bound(c.targets, result.warnings);
  if (!result.elastic.found.reached)
    result.warnings.push_back("the elastic compensation does not reach E and nu within its tolerance: see elastic");
  if (last.analysis.solutions.empty()) {
    result.warnings.push_back("no point of the last of " + std::to_string(result.rounds.size()) +
                              " design(s) meets all strength targets within their tolerances by the fitted models: the "
                              "most desirable compromise was taken");
  }
  for (const Verification& v : result.verified.verification) {
    if (v.within) continue;
    result.warnings.push_back(v.property + " misses its target by " + std::to_string(100.0 * v.bias) +
                              " % in the mean of " + std::to_string(v.values.size()) + " fresh meshes");
  }
  for (const Target& target : c.targets) {
    if (values_of(result.verified.cases, target.property).empty())
      result.warnings.push_back(target.property + " could not be verified: no run gave it");
  }
}

}  // namespace

const Solution& solution_of(const Analysis& analysis) {
  return analysis.solutions.empty() ? analysis.compromise : analysis.solutions.front();
}

SimulatedResult calibrate(const SimulatedCalibration& c, const Simulator& simulate) {
  SimulatedResult result;
  result.elastic = compensate(c, centre_of(c.factors));
  result.alternatives = elastic_alternatives(result.elastic.task);
  run_designs(c, simulate, result);
  refine(c, simulate, result);
  result.elastic = compensate(c, result.chosen);
  verify_chosen(c, simulate, result);
  verify_trade_off(c, simulate, result);
  note_warnings(c, result);
  return result;
}

}  // namespace asperity
