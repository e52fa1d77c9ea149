#pragma once
#include <memory>
#include <vector>

namespace asperity {

/// Kriging of one response over the coded factors: a linear trend plus a Gaussian process with a Matern 5/2 covariance
/// and a nugget, the mesh scatter's variance, so that it smooths repeated runs instead of passing through each.
/// Eqs. (S31) and (S32).
class Emulator {
 public:
  /// n points of k coded levels, n values, and the standard deviation of one run's mesh scatter (at least 1e-3 of
  /// half the values' range is assumed). Throws
  /// Error(numerical) where the covariance cannot be fitted.
  Emulator(const std::vector<std::vector<double>>& x, const std::vector<double>& y, double noise_sd);
  ~Emulator();
  Emulator(Emulator&&) noexcept;
  Emulator& operator=(Emulator&&) noexcept;

  double mean(const std::vector<double>& x) const;

  /// Of the mean over meshes: what the emulator does not know of it. The scatter of a run comes on top.
  double variance(const std::vector<double>& x) const;

  /// Derivatives of the mean by the coded factors.
  std::vector<double> gradient(const std::vector<double>& x) const;

 private:
  struct Fitted;
  std::unique_ptr<Fitted> fitted_;
};

}  // namespace asperity
