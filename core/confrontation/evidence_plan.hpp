#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/campaign/campaign.hpp"
#include "core/confrontation/evidence.hpp"

namespace asperity {

/// A mechanism and how strong it is.
struct MechanismAmplitude {
  std::string id;
  double amplitude = 0;
};

/// One virtual specimen of a test.
struct VirtualSpecimen {
  std::size_t test = 0;   ///< Of Evidence::tests.
  Eigen::VectorXd coded;  ///< Parameters, in steps from the reference.
  std::vector<MechanismAmplitude> mechanisms;
  std::uint64_t seed = 1;
};

/// Its run; nothing where the parameters and mechanisms together are no legal one.
using ConfigureRun = std::function<std::optional<RunConfig>(const VirtualSpecimen&)>;

/// Features of a run in the order of feature_kinds; empty where it failed.
using RunFeatureValues = std::vector<std::optional<double>>;

/// Computes runs, or looks them up; the stage's name is for progress.
using FeaturesOf =
    std::function<std::vector<RunFeatureValues>(const std::string& stage, const std::vector<CampaignRun>&)>;

/// What acts where, and on how many meshes.
struct EvidencePlan {
  std::size_t noise = 16;                         ///< Meshes of the base in fitted tests.
  std::size_t fresh = 16;                         ///< The same in kept-back tests; 0: they are not run.
  std::size_t apart = 0;                          ///< Further ones before them, those of effects.
  std::size_t parameters = 8;                     ///< Meshes of each side of each parameter.
  std::vector<std::size_t> candidate_meshes;      ///< By candidate; 0: not run.
  bool far = false;                               ///< Whether candidates are run at second amplitudes, too.
  std::vector<std::vector<bool>> parameter_acts;  ///< By test and parameter.
  std::vector<std::vector<bool>> candidate_acts;  ///< By test and candidate.
  std::uint64_t first_seed = 1;                   ///< Of fitted tests.
  std::uint64_t fresh_seed = 500001;              ///< Of kept-back tests.
  bool kept_back_candidates = true;               ///< Whether candidates are run on kept-back tests too.
  bool effects = true;                            ///< False: the base alone.
};

/// Runs what the plan asks at coded parameters `centre` and puts the features, as the slots have them, into the tests.
void simulate_evidence(Evidence& evidence, const EvidencePlan& plan, const Eigen::VectorXd& centre,
                       const std::string& stage, const ConfigureRun& configure, const FeaturesOf& features);

/// Runs of one test: rows of samples in the order of the specimens.
Samples simulate_specimens(const TestEvidence& test, const std::vector<VirtualSpecimen>& specimens,
                           const std::string& stage, const ConfigureRun& configure, const FeaturesOf& features);

/// Mesh number `row` of a test.
std::uint64_t mesh_seed(const EvidencePlan& plan, const TestEvidence& test, std::size_t row);

/// A run's features as a row of the test's slots: logarithms where the slot says so, NaN where there is none.
Eigen::RowVectorXd slot_values(const TestEvidence& test, const RunFeatureValues& features);

}  // namespace asperity
