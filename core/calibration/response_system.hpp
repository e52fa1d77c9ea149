#pragma once
#include <cstdint>
#include <vector>

#include "core/calibration/response_model.hpp"
#include "core/calibration/target.hpp"

/// The models of all targeted responses together: m equations in k coded factors.
namespace asperity {

/// m fitted responses in the order of their targets, and how their scatter hangs together: C and phi of one mesh come
/// from the same line, so their errors are far from independent.
class ResponseSystem {
 public:
  /// `models` and `targets` in the same order; neither empty.
  ResponseSystem(std::vector<ResponseModel> models, std::vector<Target> targets);

  const std::vector<ResponseModel>& models() const { return models_; }
  const std::vector<Target>& targets() const { return targets_; }
  std::size_t factors() const { return factors_; }

  /// m responses at x.
  std::vector<double> values(const std::vector<double>& x) const;

  /// Their derivatives by the factors, m rows of k.
  std::vector<double> jacobian(const std::vector<double>& x) const;

  /// Misses over tolerances, Eq. (S17): every |miss| <= 1 where all targets are met.
  std::vector<double> misses(const std::vector<double>& x) const;

  /// Covariance of the predicted means at x plus that of the targets, m by m, Eq. (S18).
  std::vector<double> covariance(const std::vector<double>& x) const;

  /// Covariance of one run's scatter on the fitted scale, m by m, Eq. (S19).
  const std::vector<double>& scatter() const { return scatter_; }

  /// Fewest residual degrees of freedom of any model.
  int residual_df() const;

  /// The system that the same runs would give with other mesh scatter: every model refitted to its own predictions plus
  /// scatter drawn from a multivariate t (normal scatter of uncertain variance). The targets are drawn too.
  ResponseSystem redrawn(std::uint64_t seed, std::size_t draw) const;

 private:
  void find_scatter();
  void find_cross_products();
  std::vector<ResponseModel> models_;
  std::vector<Target> targets_;
  std::size_t factors_ = 0;
  std::vector<double> scatter_;
  std::vector<std::vector<double>> cross_;  ///< m by m of P_r P_s' over common runs, P the projections.
};

}  // namespace asperity
