#include <algorithm>
#include <cmath>

#include "core/calibration/simulated_parts.hpp"

namespace asperity {
namespace {

std::optional<double> predicted(const SimulatedResult& result, const std::string& property) {
  const DesignRound& round = result.rounds.back();
  std::vector<double> x;
  for (std::size_t j = 0; j < result.chosen.size(); ++j) x.push_back(encode(round.design.factors[j], result.chosen[j]));
  for (const ResponseModel& model : round.analysis.models) {
    if (model.name == property) return predict_value(model, x);
  }
  return std::nullopt;
}

std::vector<Verification> verify_all(const std::vector<Target>& targets, const SimulatedResult* result,
                                     const std::vector<CaseResult>& cases) {
  std::vector<Verification> list;
  for (const Target& target : targets) {
    std::vector<double> values = values_of(cases, target.property);
    if (values.empty()) continue;
    list.push_back(verify(target, std::move(values), result ? predicted(*result, target.property) : std::nullopt));
  }
  return list;
}

std::vector<SuiteCase> fresh_cases(const SimulatedCalibration& c, const std::string& name, const ParameterSet& set,
                                   std::size_t meshes) {
  std::vector<SuiteCase> cases;
  for (std::size_t i = 0; i < meshes; ++i) cases.push_back({name, set, c.verification.first_seed + i});
  return cases;
}

/// The suite with a trade-off set's own values above the calibration's.
TestSuite changed_suite(TestSuite suite, const TradeOffSet& set) {
  for (SuiteTest& test : suite.tests) {
    test.overrides.insert(test.overrides.end(), set.overrides.begin(), set.overrides.end());
    if (test.config.experiment.type != ExperimentType::brazilian) continue;
    test.overrides.insert(test.overrides.end(), set.disc_overrides.begin(), set.disc_overrides.end());
  }
  return suite;
}

void replace(Settings& settings, const Settings& by) {
  for (const auto& [pointer, value] : by) {
    const auto found =
        std::find_if(settings.begin(), settings.end(), [&p = pointer](const auto& s) { return s.first == p; });
    if (found == settings.end()) {
      settings.emplace_back(pointer, value);
    } else {
      found->second = value;
    }
  }
}

}  // namespace

std::vector<double> values_of(const std::vector<CaseResult>& results, const std::string& property) {
  std::vector<double> values;
  for (const CaseResult& result : results) {
    const double value = result.property(property);
    if (std::isfinite(value)) values.push_back(value);
  }
  return values;
}

void verify_chosen(const SimulatedCalibration& c, const Simulator& simulate, SimulatedResult& result) {
  VerifiedSet& set = result.verified;
  set.name = "chosen";
  set.parameters = parameter_set(result.elastic, c.factors, result.chosen);
  const std::vector<SuiteCase> cases = fresh_cases(c, "verification", set.parameters, c.verification.meshes);
  set.cases = run_suite(c.suite, cases, c.name + ": verification", simulate, result.cost);
  set.verification = verify_all(c.targets, &result, set.cases);
}

void verify_trade_off(const SimulatedCalibration& c, const Simulator& simulate, SimulatedResult& result) {
  for (const TradeOffSet& told : c.trade_off) {
    VerifiedSet set{told.name, told.why, result.verified.parameters, {}, {}};
    replace(set.parameters.common, told.parameters);
    const std::vector<SuiteCase> cases = fresh_cases(c, told.name, set.parameters, c.verification.trade_off_meshes);
    set.cases = run_suite(changed_suite(c.suite, told), cases, c.name + ": " + told.name, simulate, result.cost);
    set.verification = verify_all(c.targets, nullptr, set.cases);
    result.trade_off.push_back(std::move(set));
  }
}

}  // namespace asperity
