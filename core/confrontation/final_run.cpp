#include "core/confrontation/final_run.hpp"

#include <algorithm>

#include "core/confrontation/confrontation_task.hpp"

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

bool extends(const Confrontation& c, FinalModel model) {
  return model == FinalModel::extension && !c.conclusion.kept.empty();
}

/// In steps about the reference.
VectorXd final_coded(const Confrontation& c, FinalModel model) {
  return extends(c, model) ? VectorXd(c.centre + c.conclusion.kept.front().coded) : VectorXd(c.centre + c.base.coded);
}

std::vector<MechanismConfig> final_mechanisms(const Confrontation& c, FinalModel model, const MeasuredTest& test,
                                              const RunConfig& run) {
  std::vector<MechanismConfig> mechanisms;
  if (!extends(c, model)) return mechanisms;
  const HypothesisFit& fit = c.conclusion.kept.front();
  for (std::size_t i = 0; i < fit.causes.size(); ++i) {
    const Candidate& candidate = c.evidence.candidates[static_cast<std::size_t>(fit.causes[i])];
    const double amplitude = amplitude_of_run(candidate, fit.amplitude(static_cast<Index>(i)));
    if (amplitude != 0.0 && can_act(run, candidate.id)) mechanisms.push_back({candidate.id, amplitude, {}});
  }
  return acting_in(test.preparation, mechanisms);
}

std::vector<double> within_limits(const ConfrontationConfig& config, std::vector<double> theta) {
  for (std::size_t p = 0; p < theta.size(); ++p) {
    const ConfrontationParameter& parameter = config.parameters[p];
    theta[p] = std::clamp(theta[p], theta_of(parameter.transform, parameter.lower),
                          theta_of(parameter.transform, parameter.upper));
  }
  return theta;
}

}  // namespace

std::vector<double> final_theta(const ConfrontationConfig& config, const Confrontation& confrontation,
                                FinalModel model) {
  return within_limits(config, theta_at(config, final_coded(confrontation, model)));
}

RunConfig final_run(const ConfrontationConfig& config, const Confrontation& confrontation, const MeasuredTest& test,
                    FinalModel model, VirtualOutput output, std::uint64_t seed) {
  const std::vector<double> theta = final_theta(config, confrontation, model);
  const RunConfig run = virtual_test(config, test, output);
  return configured(run, config.parameters, theta, final_mechanisms(confrontation, model, test, run), seed);
}

}  // namespace asperity
