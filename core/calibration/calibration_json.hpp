#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/calibration/analysis.hpp"
#include "core/calibration/verification.hpp"

/// The parts of calibration.json that the statistics know. A number that does not exist is null.
namespace asperity {

/// One position of the moving design.
struct Round {
  std::vector<Factor> factors;
  double moved_by = 0;  ///< Coded length from the round before; 0 for the first.
  double best_desirability = 0;
  std::size_t solutions = 0;
};

nlohmann::ordered_json targets_json(const std::vector<Target>& targets);

/// `seeds`: the mesh of each row; empty for data that have none.
nlohmann::ordered_json design_json(const Design& design, const std::vector<std::uint64_t>& seeds);

/// One array a response, one value a design row; null where the run is bad.
nlohmann::ordered_json responses_json(const Responses& responses);
nlohmann::ordered_json bad_runs_json(const std::vector<BadRun>& bad_runs);

/// Every model by its response; arrays over runs have one value a design row, null for a bad one.
nlohmann::ordered_json models_json(const std::vector<ResponseModel>& models, std::size_t rows);
nlohmann::ordered_json round_json(const Round& round);

/// The region's lower and upper bounds hold all parameters at once (Eq. (S26)), those of `interval` one by itself. A
/// bound of a parameter that the runs do not determine is null.
nlohmann::ordered_json solution_json(const Solution& solution, const std::vector<Factor>& factors,
                                     const std::vector<Target>& targets);
nlohmann::ordered_json verification_json(const std::vector<Verification>& verifications);

/// {pointer: value}.
nlohmann::ordered_json parameters_json(const std::vector<Factor>& factors, const std::vector<double>& real);

}  // namespace asperity
