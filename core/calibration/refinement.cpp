#include "core/calibration/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <openturns/ChiSquare.hxx>

#include "core/base/error.hpp"
#include "core/calibration/posterior.hpp"

namespace asperity {
namespace {

/// Emulators of all targets on the good runs so far.
std::vector<Emulator> emulators_of(const Refinement& refinement) {
  std::vector<Emulator> emulators;
  for (std::size_t r = 0; r < refinement.targets.size(); ++r) {
    std::vector<std::vector<double>> x;
    std::vector<double> y;
    for (std::size_t i = 0; i < refinement.x.size(); ++i) {
      if (!std::isfinite(refinement.y[i][r])) continue;
      x.push_back(refinement.x[i]);
      y.push_back(refinement.y[i][r]);
    }
    // A linear trend and one length scale a factor: as many runs again as the trend has terms, at the least.
    const std::size_t least = 2 * (refinement.x.front().size() + 1);
    if (y.size() < least) {
      throw Error(ErrorKind::config,
                  {{"/responses/" + refinement.targets[r].property, "has too few good runs for an emulator",
                    std::to_string(y.size()), std::to_string(least) + " or more", ""}});
    }
    emulators.emplace_back(x, y, refinement.noise_sd[r]);
  }
  return emulators;
}

void settle(Refinement& refinement, const RefinementOptions& options) {
  std::vector<double> noise;  // of a batch's mean, and of the target
  for (std::size_t r = 0; r < refinement.targets.size(); ++r) {
    const double error = refinement.targets[r].standard_error;
    noise.push_back(refinement.noise_sd[r] * refinement.noise_sd[r] / static_cast<double>(options.batch) +
                    error * error);
  }
  const PosteriorProblem problem{emulators_of(refinement), refinement.targets, noise, options.prior_sd, options.region};
  Posterior posterior = find_mode(problem, refinement.theta);
  refinement.theta = std::move(posterior.theta);
  refinement.covariance = std::move(posterior.covariance);
}

/// Mean of the good runs and how many there are.
std::pair<double, std::size_t> mean_of(const Batch& batch, std::size_t target) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const std::vector<double>& run : batch.y) {
    if (!std::isfinite(run[target])) continue;
    sum += run[target];
    ++count;
  }
  return {sum / static_cast<double>(count), count};
}

/// Eq. (S34). A batch with no good run for a target is never within anything.
RefinementStep judge(const Refinement& refinement, const Batch& batch, double level) {
  RefinementStep step;
  step.x = batch.x;
  step.within_tolerance = true;
  step.runs = batch.y.size();
  for (std::size_t r = 0; r < refinement.targets.size(); ++r) {
    const Target& target = refinement.targets[r];
    const auto [mean, count] = mean_of(batch, r);
    const double scatter = refinement.noise_sd[r] * refinement.noise_sd[r] / static_cast<double>(count);
    const double miss = mean - target.value;
    step.mean.push_back(mean);
    step.runs = std::min(step.runs, count);
    step.chi2 += miss * miss / (scatter + target.standard_error * target.standard_error);
    step.within_tolerance = step.within_tolerance && std::abs(miss) <= target.tolerance * std::abs(target.value);
  }
  const OT::ChiSquare chi2(static_cast<double>(refinement.targets.size()));
  step.within_noise = step.chi2 <= chi2.computeQuantile(level)[0];
  return step;
}

}  // namespace

Refinement start_refinement(std::vector<Target> targets, std::vector<double> noise_sd,
                            std::vector<std::vector<double>> x, std::vector<std::vector<double>> y,
                            const RefinementOptions& options) {
  Refinement refinement;
  refinement.targets = std::move(targets);
  refinement.noise_sd = std::move(noise_sd);
  refinement.x = std::move(x);
  refinement.y = std::move(y);
  refinement.theta.assign(refinement.x.front().size(), 0.0);
  settle(refinement, options);
  return refinement;
}

std::vector<double> propose(const Refinement& refinement) { return refinement.theta; }

Refinement update(Refinement refinement, const Batch& batch, const RefinementOptions& options) {
  RefinementStep step = judge(refinement, batch, options.level);
  const std::size_t k = batch.x.size();
  for (std::size_t j = 0; j < k; ++j) step.sd.push_back(std::sqrt(refinement.covariance[j * k + j]));
  for (const std::vector<double>& run : batch.y) {
    refinement.x.push_back(batch.x);
    refinement.y.push_back(run);
  }
  refinement.steps.push_back(step);
  refinement.done = step.within_noise || refinement.steps.size() >= options.most_steps;
  settle(refinement, options);
  return refinement;
}

const RefinementStep* best_step(const Refinement& refinement) {
  const RefinementStep* best = nullptr;
  for (const RefinementStep& step : refinement.steps) {
    if (std::isfinite(step.chi2) && (!best || step.chi2 < best->chi2)) best = &step;
  }
  return best;
}

}  // namespace asperity
