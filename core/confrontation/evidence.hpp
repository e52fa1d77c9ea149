#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/confrontation/measured_data.hpp"
#include "core/measurement/features.hpp"

/// What a confrontation reasons from: features of measured specimens and of simulated runs, test by test.
namespace asperity {

/// One feature of one test, as it is compared.
struct FeatureSlot {
  const FeatureKind* kind = nullptr;
  bool logarithmic = false;                ///< Samples hold the natural logarithm.
  double floor_sd = 0;                     ///< Least scatter of one specimen that is believed, in the samples' unit.
  const FeatureKind* simulated = nullptr;  ///< What is read of a run, where that is another kind; else `kind`.
};

/// Rows: specimens, or runs; columns: the slots of a test; NaN where there is no value.
using Samples = Eigen::MatrixXd;

/// One test with everything that was measured and simulated of it. Runs "on common meshes" share their rows' meshes
/// with the first rows of `base`; a list's entry with no row says that nothing can change here, exactly.
struct TestEvidence {
  std::string id;
  ExperimentType experiment = ExperimentType::uniaxial;
  TestUse use = TestUse::fit;
  ScatterSource scatter = ScatterSource::pooled;
  std::vector<FeatureSlot> slots;
  Samples measured;
  Eigen::VectorXd instrument_sd;   ///< Of the specimens' mean, slot by slot, in the samples' unit.
  Eigen::VectorXd own_sd;          ///< Of one specimen, by instruments' zeros and rows' noise, each its own; empty: none.
  Samples base;                    ///< The base model at the parameters' reference.
  Eigen::Index apart = 0;          ///< First rows of it that the gate leaves out: those of effects; 0: it takes all.
  std::vector<Samples> low, high;  ///< By parameter, on common meshes, one step below and above.
  std::vector<Samples> mechanism;  ///< By candidate, on common meshes, at the candidate's amplitude.
  std::vector<Samples> far;        ///< By candidate, likewise, at its second amplitude; no row: not run.
};

/// A microparameter that calibration may move, in coded units of its step.
struct CalibratedParameter {
  std::string name;
  double lower = -3.0, upper = 3.0;  ///< What is believed of it, coded.
};

/// A mechanism that may be the cause.
struct Candidate {
  std::string id;
  double amplitude = 0.6;  ///< Of its runs.
  bool two_sided = false;  ///< A setting that may be off either way.
  bool suspect = false;    ///< A setting of the solver, no rock.
  double most = 3.0;       ///< Largest amplitude that its parameters' ranges allow.
  double least = 0.0;      ///< Smallest one other than 0 that they allow: infinite is no value of a reciprocal one.
  bool whole = false;      ///< Takes whole numbers.
  double far = 0.0;        ///< A second amplitude of its runs, beyond the first, or below 0; 0: none.
  std::vector<std::string> doubles = {};         ///< Ids of those that it is known to be taken for, Eq. (N25).
  std::vector<std::string> tested_doubles = {};  ///< The same where the test that tells the two apart was made.
};

/// The amplitude nearest to this one that a run can have: within the candidate's range, a whole number where it takes
/// only such, 0 below its least.
double amplitude_of_run(const Candidate& candidate, double amplitude);

struct Evidence {
  std::vector<CalibratedParameter> parameters;
  std::vector<Candidate> candidates;
  std::vector<TestEvidence> tests;
};

}  // namespace asperity
