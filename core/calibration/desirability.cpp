#include "core/calibration/desirability.hpp"

#include <cmath>

namespace asperity {
namespace {

/// Miss over the half range, with its sign.
double relative_miss(double value, const Target& target, const DesirabilityOptions& options) {
  return (value - target.value) / (options.half_range * std::abs(target.value));
}

double total_weight(const std::vector<Target>& targets) {
  double sum = 0.0;
  for (const Target& target : targets) sum += target.weight;
  return sum;
}

double misfit(const std::vector<double>& values, const std::vector<Target>& targets,
              const DesirabilityOptions& options) {
  double sum = 0.0;
  for (std::size_t r = 0; r < values.size(); ++r) {
    const double miss = relative_miss(values[r], targets[r], options);
    sum += targets[r].weight * miss * miss;
  }
  return sum;
}

}  // namespace

double desirability(double value, const Target& target, const DesirabilityOptions& options) {
  const double miss = std::abs(relative_miss(value, target, options));
  return miss < 1.0 ? std::pow(1.0 - miss, options.exponent) : 0.0;
}

double overall_desirability(const std::vector<double>& values, const std::vector<Target>& targets,
                            const DesirabilityOptions& options) {
  double product = 1.0;
  const double weights = total_weight(targets);
  for (std::size_t r = 0; r < values.size(); ++r) {
    product *= std::pow(desirability(values[r], targets[r], options), targets[r].weight / weights);
  }
  return product;
}

double merit(const ResponseSystem& system, const std::vector<double>& x, const DesirabilityOptions& options) {
  const std::vector<double> values = system.values(x);
  const double desirable = overall_desirability(values, system.targets(), options);
  return desirable > 0.0 ? desirable : -misfit(values, system.targets(), options);
}

std::vector<double> merit_gradient(const ResponseSystem& system, const std::vector<double>& x,
                                   const DesirabilityOptions& options) {
  const std::vector<double> values = system.values(x), jacobian = system.jacobian(x);
  const std::vector<Target>& targets = system.targets();
  const bool desirable = overall_desirability(values, targets, options) > 0.0;
  std::vector<double> gradient(x.size(), 0.0);
  for (std::size_t r = 0; r < values.size(); ++r) {
    const double miss = relative_miss(values[r], targets[r], options);
    const double by_miss = desirable ? -options.exponent * targets[r].weight / total_weight(targets) *
                                           (miss > 0.0 ? 1.0 : -1.0) / (1.0 - std::abs(miss))
                                     : -2.0 * targets[r].weight * miss;
    const double by_value = by_miss / (options.half_range * std::abs(targets[r].value));
    for (std::size_t j = 0; j < x.size(); ++j) gradient[j] += by_value * jacobian[r * x.size() + j];
  }
  return gradient;
}

}  // namespace asperity
