#pragma once
#include <cstddef>
#include <vector>

#include "core/calibration/optimum.hpp"
#include "core/calibration/target.hpp"

/// The second route: a kriging emulator on all runs so far proposes parameters, real runs there correct it.
namespace asperity {

struct RefinementOptions {
  SearchRegion region;    ///< No proposal leaves it.
  double prior_sd = 1.0;  ///< Coded, of every factor about the design's centre before any run.
  std::size_t batch = 3;  ///< Runs (meshes) a proposal.
  std::size_t most_steps = 6;
  double level = 0.95;  ///< The misfit counts as scatter up to this quantile of chi squared.
};

/// Real runs at one parameter set.
struct Batch {
  std::vector<double> x;               ///< Coded.
  std::vector<std::vector<double>> y;  ///< Runs as rows, targets as columns; NaN where the run is bad.
};

/// One batch and what it showed.
struct RefinementStep {
  std::vector<double> x, sd;  ///< Coded, with the posterior standard deviation when it was proposed.
  std::vector<double> mean;   ///< Of the batch, one a target.
  double chi2 = 0;            ///< Misfit of the batch's mean, Eq. (S34).
  bool within_noise = false;
  bool within_tolerance = false;
  std::size_t runs = 0;  ///< Good ones of the batch.
};

/// Everything known so far; a value that each step replaces.
struct Refinement {
  std::vector<Target> targets;
  std::vector<double> noise_sd;        ///< Mesh scatter of one run, one a target.
  std::vector<std::vector<double>> x;  ///< All runs so far, coded.
  std::vector<std::vector<double>> y;  ///< Their responses, runs as rows; NaN where bad.
  std::vector<double> theta;           ///< Most probable parameters, coded.
  std::vector<double> covariance;      ///< Their posterior covariance, k by k.
  std::vector<RefinementStep> steps;
  bool done = false;  ///< A batch met the targets within scatter, or the steps are used up.
};

/// Begins with the design's runs; theta and covariance are already the emulator's. `y` has targets as columns.
Refinement start_refinement(std::vector<Target> targets, std::vector<double> noise_sd,
                            std::vector<std::vector<double>> x, std::vector<std::vector<double>> y,
                            const RefinementOptions& options);

/// The parameters to run next, coded: the mode of Eq. (S33).
std::vector<double> propose(const Refinement& refinement);

/// The batch joins the runs, the emulators are fitted again, and theta moves to the new mode, Eqs. (S33) and (S35).
Refinement update(Refinement refinement, const Batch& batch, const RefinementOptions& options);

/// The batch nearest to the targets (least chi squared); none before the first.
const RefinementStep* best_step(const Refinement& refinement);

}  // namespace asperity
