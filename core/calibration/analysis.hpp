#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/moves.hpp"
#include "core/calibration/optimum.hpp"
#include "core/calibration/region.hpp"
#include "core/calibration/response_model.hpp"

/// From a design and its responses to parameters with their uncertainty.
namespace asperity {

/// What the user may choose of the analysis.
struct AnalysisOptions {
  ModelOptions model;
  RegionShape region = RegionShape::sphere;
  SearchOptions search;
  double level = 0.95;              ///< Of intervals and regions.
  double most_move = 1.0;           ///< Longest move of the centre, in alpha.
  std::size_t bootstrap_draws = 0;  ///< 0: delta method only.
  std::uint64_t seed = 1;           ///< Of the bootstrap.
};

/// One parameter set: what the models predict there, and how well the runs tell it.
struct Solution {
  Optimum point;
  std::vector<double> real;           ///< Parameters, factor by factor.
  std::vector<Prediction> predicted;  ///< In the order of the targets.
  ConfidenceRegion region;
  std::optional<BootstrapRegion> bootstrap;
};

struct Analysis {
  std::vector<ResponseModel> models;  ///< Of every response that can be fitted, targeted ones first in their order.
  std::vector<Solution> solutions;    ///< All distinct ones inside the design; empty: the targets cannot be met there.
  Solution compromise;                ///< The best point of the design, met or not.
  std::optional<Move> move;           ///< Where the next design should go; only where there is no solution.
  std::vector<std::string> warnings;
};

/// Fits, solves and bounds. A response that is no target and cannot be fitted is left out with a warning. Throws
/// Error(config) for a target that no response has, a target of 0, and what fit_response says of a targeted response.
Analysis analyse(const Design& design, const Responses& responses, const std::vector<Target>& targets,
                 const AnalysisOptions& options);

/// The targeted responses' models as one system; `models` as in Analysis.
ResponseSystem system_of(const std::vector<ResponseModel>& models, const std::vector<Target>& targets);

}  // namespace asperity
