#include "core/calibration/moves.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr double kStride = 0.05;          // coded: short beside the curvature of a quadratic over the design
constexpr double kShortestStride = 1e-4;  // coded: a ridge is reached

double norm(const std::vector<double>& x) {
  double sum = 0.0;
  for (double v : x) sum += v * v;
  return std::sqrt(sum);
}

std::vector<double> forward(const std::vector<double>& x, const std::vector<double>& direction, double length) {
  std::vector<double> moved = x;
  for (std::size_t j = 0; j < x.size(); ++j) moved[j] += length * direction[j];
  return moved;
}

std::vector<double> unit(std::vector<double> vector) {
  const double length = norm(vector);
  for (double& v : vector) v /= length;
  return vector;
}

/// Strides along the gradient, Eq. (S28), halved where one would lead down.
std::vector<double> ascend(const ResponseSystem& system, double reach, const DesirabilityOptions& options) {
  std::vector<double> x(system.factors(), 0.0);
  double stride = kStride, height = merit(system, x, options);
  for (std::vector<double> gradient = merit_gradient(system, x, options);
       norm(gradient) > 0.0 && stride > kShortestStride;) {
    const std::vector<double> next = forward(x, unit(gradient), stride);
    const double next_height = merit(system, next, options);
    if (norm(next) > reach || !(next_height > height)) {
      stride *= 0.5;
      continue;
    }
    x = next;
    height = next_height;
    gradient = merit_gradient(system, x, options);
  }
  return x;
}

/// A limit's place on the axis where steps are equal: the real value, or its logarithm.
double on_axis(const Factor& factor, double real) {
  return factor.scale == FactorScale::logarithmic ? std::log(real) : real;
}
double off_axis(const Factor& factor, double place) {
  return factor.scale == FactorScale::logarithmic ? std::exp(place) : place;
}

/// Centre moved to the coded place, and held within the limits with its star points. Whether a limit had a say.
bool move_factor(Factor& factor, double coded, double alpha) {
  const double wanted = on_axis(factor, decode(factor, coded));
  double step = on_axis(factor, factor.step);
  double place = wanted;
  const double width = factor.lower && factor.upper ? on_axis(factor, *factor.upper) - on_axis(factor, *factor.lower)
                                                    : 2.0 * alpha * step;
  const bool shrunk = width < 2.0 * alpha * step * (1.0 - 1e-12);
  if (shrunk) step = width / (2.0 * alpha);
  if (factor.upper) place = std::min(place, on_axis(factor, *factor.upper) - alpha * step);
  if (factor.lower) place = std::max(place, on_axis(factor, *factor.lower) + alpha * step);
  factor.centre = off_axis(factor, place);
  factor.step = off_axis(factor, step);
  return shrunk || place != wanted;
}

}  // namespace

Move next_centre(const Design& design, const ResponseSystem& system, const MoveOptions& options) {
  const std::vector<double> top = ascend(system, options.most * design.alpha, options.desirability);
  Move move;
  move.factors = design.factors;
  for (std::size_t j = 0; j < top.size(); ++j) {
    move.limited.push_back(move_factor(move.factors[j], top[j], design.alpha));
    move.coded.push_back(move.limited[j] ? encode(design.factors[j], move.factors[j].centre) : top[j]);
  }
  move.moved_by = norm(move.coded);
  move.merit_before = merit(system, std::vector<double>(top.size(), 0.0), options.desirability);
  move.merit_after = merit(system, move.coded, options.desirability);
  return move;
}

}  // namespace asperity
