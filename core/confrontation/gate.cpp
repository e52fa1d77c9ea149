#include "core/confrontation/gate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <openturns/Gamma.hxx>

namespace asperity {
namespace {

constexpr double kNoMisfit = 1e-9;  // what rounding leaves where calibration absorbs everything

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kDetectable = 17.0;  // least Lambda at which a single cause is said to pass the gate
constexpr double kSurely = 1.0;       // standard deviations beyond the gate, for more than an even chance

/// |P L^-1 g|^2 less what its own error adds to it in the mean.
double true_square(const WhitenedFrame& frame, const VectorXd& fingerprint, const MatrixXd& rows) {
  double square = frame.project(fingerprint).squaredNorm();
  const double n = static_cast<double>(rows.rows());
  if (rows.rows() < 2) return square;
  return square - frame.project(rows.transpose()).squaredNorm() / (n * (n - 1.0));
}

double detectable_by(double lambda, double square) {
  return square > 0.0 ? std::sqrt(lambda / square) : std::numeric_limits<double>::infinity();
}

/// Lambda that the draws leave to chance only at the gate's level, and somewhat more.
double detectable_lambda(std::vector<double> explained, double level) {
  std::sort(explained.begin(), explained.end());
  const double place = (1.0 - level) * static_cast<double>(explained.size());
  const std::size_t at = std::min(static_cast<std::size_t>(place), explained.size() - 1);
  return std::max(kDetectable, std::pow(std::sqrt(explained[at]) + kSurely, 2));
}

/// Eq. (N16), by the first runs up to their amplitude, beyond it by the farther ones.
double detectable_amplitude(const Comparison& comparison, const WhitenedFrame& frame, Index k, double lambda) {
  const double near = detectable_by(lambda, true_square(frame, comparison.fingerprint.col(k),
                                                        comparison.fingerprint_rows[static_cast<std::size_t>(k)]));
  if (near <= comparison.knee(k) || comparison.reach(k) < 0.0) return near;
  const double reach = comparison.reach(k);
  const double far =
      detectable_by(lambda, true_square(frame, secant_of(comparison, k), effect_rows(comparison, k, reach) / reach));
  return std::max(comparison.knee(k), far);
}

void describe_candidates(const Comparison& comparison, const WhitenedFrame& frame, double lambda, Gate& gate) {
  const Index count = comparison.fingerprint.cols();
  gate.hidden_share = gate.detectable = VectorXd::Zero(count);
  for (Index k = 0; k < count; ++k) {
    const VectorXd g = comparison.fingerprint.col(k);
    const double whole = frame.whiten(g).squaredNorm();
    gate.hidden_share(k) = whole > 0.0 ? 1.0 - frame.project(g).squaredNorm() / whole : 1.0;
    gate.detectable(k) = detectable_amplitude(comparison, frame, k, lambda);
  }
}

MatrixXd secants(const Comparison& comparison) {
  MatrixXd columns(comparison.fingerprint.rows(), comparison.fingerprint.cols());
  for (Index k = 0; k < columns.cols(); ++k) columns.col(k) = secant_of(comparison, k);
  return columns;
}

/// Whether runs speak for an amplitude of this sign: first ones for their side alone where the second are on the other.
bool speaks(const Candidate& candidate, double reach, bool second, double along) {
  if (reach < 0.0) return second == (along < 0.0);
  return along >= 0.0 || candidate.two_sided;
}

}  // namespace

Pattern pattern_of(const WhitenedFrame& frame, const VectorXd& difference, const Comparison& comparison,
                   const std::vector<Candidate>& candidates) {
  const VectorXd residual = frame.project(difference);
  Pattern pattern{residual.squaredNorm(), VectorXd::Zero(comparison.fingerprint.cols())};
  for (const bool second : {false, true}) {
    const MatrixXd columns = frame.project(second ? secants(comparison) : comparison.fingerprint);
    for (Index k = 0; k < columns.cols(); ++k) {
      const double square = columns.col(k).squaredNorm(), along = columns.col(k).dot(residual);
      if (square <= 0.0 || !speaks(candidates[static_cast<std::size_t>(k)], comparison.reach(k), second, along))
        continue;
      pattern.explained(k) = std::max(pattern.explained(k), along * along / square);
    }
  }
  return pattern;
}

MatrixXd projected_fingerprints(const WhitenedFrame& frame, const VectorXd& difference, const Comparison& comparison) {
  const VectorXd residual = frame.project(difference);
  const MatrixXd below = frame.project(comparison.beyond);
  MatrixXd columns = frame.project(comparison.fingerprint);
  for (Index k = 0; k < columns.cols(); ++k) {
    if (comparison.reach(k) >= 0.0) continue;
    const double up = columns.col(k).normalized().dot(residual), down = -below.col(k).normalized().dot(residual);
    if (down > up) columns.col(k) = below.col(k);
  }
  return columns;
}

VectorXd drawn_parameter_error(const Comparison& comparison, const BaseFit& fit, RandomStream& random) {
  VectorXd error = VectorXd::Zero(comparison.data.size());
  for (std::size_t p = 0; p < comparison.jacobian_rows.size(); ++p)
    error += fit.coded(static_cast<Index>(p)) * drawn_error(comparison, comparison.jacobian_rows[p], random);
  return error;
}

double share_above(const std::vector<double>& draws, double value) {
  const auto above = std::count_if(draws.begin(), draws.end(), [&](double d) { return d >= value; });
  return static_cast<double>(above + 1) / static_cast<double>(draws.size() + 1);
}

double gamma_tail(const std::vector<double>& sample, double value) {
  double mean = 0.0, square = 0.0;
  for (const double s : sample) mean += s / static_cast<double>(sample.size());
  for (const double s : sample) square += (s - mean) * (s - mean) / static_cast<double>(sample.size() - 1);
  if (square <= 0.0) return value > mean ? 0.0 : 1.0;
  return OT::Gamma(mean * mean / square, mean / square).computeComplementaryCDF(value);
}

Gate gate(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit,
          const std::vector<Candidate>& candidates, const GateOptions& options) {
  const WhitenedFrame frame(scatter.covariance, fit.absorbing);
  Gate gate;
  gate.pattern = pattern_of(frame, fit.difference, comparison, candidates);
  RandomStream random(options.seed, "confrontation gate");
  std::vector<double> misfits, least_misfits, explained;
  for (int d = 0; d < options.draws; ++d) {
    options.at_each_draw();
    const Repetition again = repeat(comparison, scatter, options.noise, random);
    const VectorXd difference = again.difference + drawn_parameter_error(comparison, fit, random);
    const WhitenedFrame drawn_frame(again.covariance, fit.absorbing);
    const Pattern drawn = pattern_of(drawn_frame, difference, comparison, candidates);
    least_misfits.push_back(drawn_frame.project(again.least_difference).squaredNorm());
    misfits.push_back(drawn.misfit);
    explained.push_back(drawn.explained.size() > 0 ? drawn.explained.maxCoeff() : 0.0);
  }
  describe_candidates(comparison, frame, detectable_lambda(explained, options.explained_level), gate);
  const double most = gate.pattern.explained.size() > 0 ? gate.pattern.explained.maxCoeff() : 0.0;
  gate.p_explained = share_above(explained, most);
  gate.p_misfit = gamma_tail(misfits, gate.pattern.misfit);
  gate.p_too_good = 1.0 - share_above(least_misfits, std::max(gate.pattern.misfit, kNoMisfit));
  gate.left = comparison.data.size() - frame.absorbed();
  gate.discrepancy = gate.p_explained < options.explained_level || gate.p_misfit < options.misfit_level;
  return gate;
}

}  // namespace asperity
