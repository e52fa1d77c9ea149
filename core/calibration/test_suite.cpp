#include "core/calibration/test_suite.hpp"

#include <cmath>

#include "core/base/error.hpp"
#include "core/config/read_config.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/measurement/results.hpp"
#include "core/output/summary.hpp"

namespace asperity {
namespace {

using nlohmann::json;

constexpr const char* kLeftOut = "left out of the models of what it would have given";

void lay_over(std::vector<std::string>& overrides, const Settings& settings) {
  for (const auto& [pointer, value] : settings) overrides.push_back(pointer + "=" + number_text(value));
}

/// Cost of a test for the time left: a triaxial one goes on longer past its peak, and a disc has fewer particles.
double expected_cost(ExperimentType type) {
  constexpr double kDisc = 1.0, kUniaxial = 2.0, kTriaxial = 4.0;
  if (type == ExperimentType::brazilian) return kDisc;
  return type == ExperimentType::uniaxial ? kUniaxial : kTriaxial;
}

std::vector<CampaignRun> list_runs(const TestSuite& suite, const std::vector<SuiteCase>& cases) {
  std::vector<CampaignRun> runs;
  for (const SuiteCase& c : cases) {
    for (const SuiteTest& test : suite.tests) {
      runs.push_back({c.label + ", " + test.config.name + ", mesh " + std::to_string(c.seed),
                      configure(test, c.parameters, c.seed), expected_cost(test.config.experiment.type)});
    }
  }
  return runs;
}

/// Peaks of compression by confining pressure, as a case gathers them.
struct Peaks {
  std::vector<double> confining, stress;
};

void take(CaseResult& result, const std::string& property, const json& results, const char* key) {
  if (results.contains(key) && results[key].is_number())
    result.properties.emplace_back(property, results[key].get<double>());
}

/// What one finished run adds to its case.
void take_run(CaseResult& result, Peaks& peaks, const SuiteTest& test, const Summary& summary) {
  const json results = summary.results;
  const ExperimentConfig& e = test.config.experiment;
  if (!summary.failure_mode.empty()) result.failure_modes.emplace_back(test.config.name, summary.failure_mode);
  if (e.type == ExperimentType::brazilian) {
    take(result, "tensile_strength_mpa", results, "tensile_strength_mpa");
    const double tension = summary.cracks["tension"], shear = summary.cracks["shear"];
    if (tension + shear > 0.0) result.properties.emplace_back("disc_tension_crack_share", tension / (tension + shear));
    return;
  }
  peaks.confining.push_back(e.confining_pressure_mpa);
  peaks.stress.push_back(results.at("peak_axial_stress_mpa").get<double>());
  if (e.type != ExperimentType::uniaxial) return;
  take(result, "youngs_modulus_gpa", results, "youngs_modulus_gpa");
  take(result, "poissons_ratio", results, "poissons_ratio");
  take(result, "uniaxial_strength_mpa", results, "peak_axial_stress_mpa");
}

/// Why a run gives no value; empty where it does.
std::string fault_of(const CampaignOutcome& outcome, const Summary* summary) {
  if (outcome.status != RunStatus::finished) return outcome.reason;
  const bool passed = summary->results.value("peak_passed", true);
  return passed ? "" : "no peak was passed: the strength is a lower bound";
}

/// C and phi where every compression test gave its peak.
void fit_strength_line(CaseResult& result, const Peaks& peaks, std::size_t compressions, std::size_t row) try {
  if (compressions < 2 || peaks.stress.size() != compressions) return;
  const MohrCoulomb line = fit_mohr_coulomb(peaks.confining, peaks.stress);
  result.properties.emplace_back("cohesion_mpa", line.cohesion_mpa);
  result.properties.emplace_back("friction_angle_deg", line.friction_angle_deg);
  result.properties.emplace_back("mohr_coulomb_residual_mpa", line.residual_mpa);
} catch (const Error& error) {
  result.bad_runs.push_back({row, "Mohr-Coulomb line", error.what(), kLeftOut});
}

CaseResult read_case(const TestSuite& suite, const CampaignOutcome* outcomes, std::size_t row) {
  CaseResult result;
  Peaks peaks;
  std::size_t compressions = 0;
  for (std::size_t t = 0; t < suite.tests.size(); ++t) {
    const SuiteTest& test = suite.tests[t];
    const CampaignOutcome& outcome = outcomes[t];
    compressions += test.config.experiment.type != ExperimentType::brazilian;
    result.folders.push_back(outcome.folder);
    Summary summary;
    if (outcome.status == RunStatus::finished) summary = read_summary(outcome.folder / "summary.json");
    const std::string fault = fault_of(outcome, &summary);
    if (fault.empty()) {
      take_run(result, peaks, test, summary);
    } else {
      result.bad_runs.push_back({row, test.config.name, fault, kLeftOut});
    }
  }
  fit_strength_line(result, peaks, compressions, row);
  return result;
}

}  // namespace

const SuiteTest& TestSuite::uniaxial() const {
  for (const SuiteTest& test : tests) {
    if (test.config.experiment.type == ExperimentType::uniaxial) return test;
  }
  throw Error(ErrorKind::config, {{"/tests", "has no uniaxial test", "", "one uniaxial test", ""}});
}

RunConfig configure(const SuiteTest& test, const ParameterSet& parameters, std::uint64_t seed) {
  std::vector<std::string> overrides = test.overrides;
  lay_over(overrides, parameters.common);
  lay_over(overrides, test.config.experiment.plane == PlaneCondition::stress ? parameters.stress : parameters.strain);
  overrides.push_back("/particles/seed=" + std::to_string(seed));
  return parse_run_config(test.text, test.path.string(), overrides);
}

double CaseResult::property(const std::string& name) const {
  for (const auto& [property, value] : properties) {
    if (property == name) return value;
  }
  return NAN;
}

std::vector<CaseResult> run_suite(const TestSuite& suite, const std::vector<SuiteCase>& cases, const std::string& stage,
                                  const Simulator& simulate, SuiteCost& cost) {
  const std::vector<CampaignOutcome> outcomes = simulate(stage, list_runs(suite, cases));
  for (const CampaignOutcome& outcome : outcomes) {
    if (outcome.status == RunStatus::interrupted) throw CalibrationInterrupted{};
    ++cost.runs;
    cost.reused += outcome.reused;
    cost.compute_s += outcome.compute_s;
  }
  std::vector<CaseResult> results;
  for (std::size_t i = 0; i < cases.size(); ++i)
    results.push_back(read_case(suite, &outcomes[i * suite.tests.size()], i));
  return results;
}

}  // namespace asperity
