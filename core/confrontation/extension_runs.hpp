#pragma once
#include <string>
#include <vector>

#include "core/confrontation/confront.hpp"

namespace asperity {

/// The calibrated base extended by mechanisms: where it is run.
struct ExtensionPoint {
  std::vector<Eigen::Index> causes;  ///< Candidates' numbers.
  Eigen::VectorXd coded, amplitude;  ///< Parameters in steps about the evidence's centre; one amplitude a cause.
};

/// The point within the candidates' and parameters' ranges, its amplitudes such as a run can have.
ExtensionPoint point_of_run(const Evidence& evidence, ExtensionPoint point);

/// An extension's specimens of one test, by its number, on the first `meshes` of the test's.
std::vector<VirtualSpecimen> extension_specimens(const ConfrontationTask& task, const Confrontation& state,
                                                 std::size_t test, const ExtensionPoint& point, Eigen::Index meshes);

/// What an extension's runs change in the compared slots against the base's on the same meshes.
struct RunChange {
  Eigen::VectorXd mean;
  Eigen::MatrixXd rows;  ///< Meshes by slots, less their mean.
  bool told = false;     ///< Whether runs gave any slot: else the mean is `otherwise` alone.
};

/// Over the first `meshes` of each test's; `otherwise` where fewer than two give a value.
RunChange change_by_runs(const ConfrontationTask& task, const Confrontation& state, const Comparison& comparison,
                         const ExtensionPoint& point, std::size_t meshes, const std::string& stage,
                         const Eigen::VectorXd& otherwise);

/// "extension a + b"
std::string extension_stage(const Evidence& evidence, const std::vector<Eigen::Index>& causes);

/// The kept-back slots under an extension by runs, its mean on all of the base's fresh meshes. What is not known of
/// parameters and amplitudes adds the changes that one standard error along each axis of their covariance makes, by
/// runs on common meshes.
FeaturePrediction predict_by_runs(const ConfrontationTask& task, const Confrontation& state, const HypothesisFit& fit);

}  // namespace asperity
