#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/confrontation/conclusion.hpp"
#include "core/confrontation/evidence_plan.hpp"
#include "core/confrontation/gain.hpp"
#include "core/confrontation/residuals.hpp"

/// The method from measured features to the gain: docs/confrontation.md.
namespace asperity {

/// Where the base's and the mechanisms' effects are taken.
enum class LinearisedAt {
  calibrated,  ///< At the calibrated parameters, by runs of their own.
  reference    ///< At the configuration's parameters, about which calibration is quadratic.
};

/// A feature that the base's runs of a test give and an extension's do not: most often they end before their peak, so
/// that what they bear until then, or the base's effects alone, stand in its place.
struct ShortRuns {
  std::vector<Eigen::Index> causes;  ///< Candidates' numbers.
  std::string test, feature;
  Eigen::Index base = 0, extension = 0;  ///< Runs that give it ...
  Eigen::Index meshes = 0;               ///< ... of so many, on the same meshes.
};

/// What is confronted: evidence with its slots and measured samples, and how its runs are made.
struct ConfrontationTask {
  Evidence evidence;
  EvidencePlan plan;
  LinearisedAt linearised_at = LinearisedAt::calibrated;
  std::size_t common = 8;  ///< Meshes of effects.
  std::size_t screen = 3;  ///< Meshes of a mechanism before it is worth more; calibrated only.
  int most_steps = 2;      ///< Of calibration by runs.
  NamingOptions options;
  ConfigureRun configure;
  FeaturesOf features;
};

/// An extension beside the base, and how it does on tests that were kept back.
struct ExtensionGain {
  HypothesisFit fit;
  std::optional<Gain> gain;  ///< Unset without kept-back features.
};

struct Confrontation {
  Evidence evidence;       ///< With the runs' features.
  Eigen::VectorXd centre;  ///< Coded parameters at which the evidence was simulated.
  Comparison fitted, kept_back;
  Scatter scatter, kept_back_scatter;
  BaseFit base;
  Gate gate;
  Conclusion conclusion;
  std::vector<FeatureResidual> residuals;
  std::vector<ExtensionGain> extensions;  ///< Of what is kept, the best first.
  std::vector<ExtensionGain> decoys;      ///< The best that are not kept, two at most.
  std::vector<ShortRuns> short_runs;      ///< Of what is kept.
};

/// Carries a confrontation through, steps 1 to 9. Throws what the runs throw.
Confrontation confront(ConfrontationTask task);

}  // namespace asperity
