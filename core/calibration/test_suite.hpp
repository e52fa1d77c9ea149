#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/calibration/response_model.hpp"
#include "core/campaign/campaign.hpp"
#include "core/config/run_config.hpp"

/// The laboratory tests that one parameter set is put through, and what they say of it.
namespace asperity {

/// Microparameters by JSON pointer, in the order they are set.
using Settings = std::vector<std::pair<std::string, double>>;

/// One test: a run configuration with what the calibration lays over it.
struct SuiteTest {
  std::filesystem::path path;
  std::string text;                    ///< Of the file.
  std::vector<std::string> overrides;  ///< "/json/pointer=value", of the calibration's "set".
  RunConfig config;                    ///< With the overrides, before any microparameter.
};

/// A disc, a uniaxial test, and triaxial tests at one confining pressure or more.
struct TestSuite {
  std::vector<SuiteTest> tests;
  const SuiteTest& uniaxial() const;
};

/// Microparameters for each plane condition: the closed forms of the contacts' stiffness differ between them.
struct ParameterSet {
  Settings common, stress, strain;
};

/// A test's configuration with a parameter set and a mesh. Throws what parse_run_config throws.
RunConfig configure(const SuiteTest& test, const ParameterSet& parameters, std::uint64_t seed);

/// One parameter set on one mesh.
struct SuiteCase {
  std::string label;
  ParameterSet parameters;
  std::uint64_t seed = 1;
};

/// What a case showed. A property that its runs do not give is missing.
struct CaseResult {
  std::vector<std::pair<std::string, double>> properties;
  std::vector<BadRun> bad_runs;                                       ///< `row` is the case's place in the list.
  std::vector<std::pair<std::string, nlohmann::json>> failure_modes;  ///< By test: what summary.json says of it.
  std::vector<std::filesystem::path> folders;                         ///< Of the runs, in the order of the tests.
  double property(const std::string& name) const;                     ///< NaN where there is none.
};

/// Computes runs; the stage's name is for progress. Any outcome may be `interrupted`.
using Simulator =
    std::function<std::vector<CampaignOutcome>(const std::string& stage, const std::vector<CampaignRun>&)>;

/// Thrown where runs were interrupted: called again, the calibration goes on from what the store has.
struct CalibrationInterrupted {};

/// Runs and wall time that a calibration took.
struct SuiteCost {
  std::size_t runs = 0, reused = 0;
  double compute_s = 0;  ///< Of all runs it stands on, re-used ones included.
};

/// Puts every case through every test in one campaign. A run that failed or passed no peak gives no value and is named.
/// Throws CalibrationInterrupted.
std::vector<CaseResult> run_suite(const TestSuite& suite, const std::vector<SuiteCase>& cases, const std::string& stage,
                                  const Simulator& simulate, SuiteCost& cost);

}  // namespace asperity
