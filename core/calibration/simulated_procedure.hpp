#pragma once
#include <filesystem>
#include <optional>

#include "core/calibration/calibration_json.hpp"
#include "core/calibration/elastic_alternatives.hpp"
#include "core/calibration/simulated_config.hpp"

/// The calibration that simulates: elastic compensation, designs, models, refinement, verification, trade-off.
namespace asperity {

/// Particles and contacts that give the assembly its elasticity, as parameters of runs.
struct ElasticPart {
  ElasticTask task;
  ElasticCompensation found;
};

/// One design with its runs and what follows from them.
struct DesignRound {
  Design design;  ///< Its own rows first, then rows of earlier designs that lie inside.
  std::vector<std::uint64_t> seeds;
  Responses responses;
  Analysis analysis;
  double moved_by = 0;
};

/// A way to parameters, with real runs at its end.
struct Route {
  std::vector<double> real, sd;  ///< Factor by factor.
  std::size_t runs = 0;          ///< Tests simulated for it, the design's included.
  double misfit = 0;             ///< Eq. (V2) of the real runs' means.
};

/// A parameter set on fresh meshes.
struct VerifiedSet {
  std::string name, why;
  ParameterSet parameters;
  std::vector<Verification> verification;
  std::vector<CaseResult> cases;
};

struct SimulatedResult {
  ElasticPart elastic;  ///< At the chosen strengths.
  std::vector<ElasticAlternative> alternatives;
  std::vector<DesignRound> rounds;
  Route quadratic, kriging;
  Refinement refinement;
  std::string chosen_route;
  std::vector<double> chosen;  ///< Real values, factor by factor.
  VerifiedSet verified;
  std::vector<VerifiedSet> trade_off;
  SuiteCost cost;
  std::vector<std::string> warnings;
};

/// Carries a calibration through. Throws CalibrationInterrupted, and Error as its parts do.
SimulatedResult calibrate(const SimulatedCalibration& calibration, const Simulator& simulate);

/// calibration.json; `configs` are the paths written by write_calibrated_configs().
nlohmann::ordered_json calibration_json(const SimulatedCalibration& calibration, const SimulatedResult& result,
                                        const std::vector<std::string>& configs, double wall_s);

/// Writes one ready run configuration a test with the chosen parameters into `folder`/configs and returns their paths
/// relative to `folder`. Throws Error(output).
std::vector<std::string> write_calibrated_configs(const SimulatedCalibration& calibration,
                                                  const SimulatedResult& result, const std::filesystem::path& folder);

/// Root mean square of misses over tolerances, weighted, Eq. (V2); NaN counts as a miss of 10 tolerances.
double misfit(const std::vector<double>& means, const std::vector<Target>& targets);

}  // namespace asperity
