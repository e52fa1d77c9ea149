#include "core/calibration/verification.hpp"

#include <cmath>

#include "core/base/error.hpp"

namespace asperity {
namespace {

/// Eq. (S29).
void fill_statistics(Verification& verification) {
  const auto n = static_cast<double>(verification.values.size());
  for (double v : verification.values) verification.mean += v / n;
  double square = 0.0;
  for (double v : verification.values) square += (v - verification.mean) * (v - verification.mean);
  verification.sd = std::sqrt(square / (n - 1.0));
}

}  // namespace

Verification verify(const Target& target, std::vector<double> values, std::optional<double> predicted) {
  if (values.empty()) {
    throw Error(ErrorKind::config,
                {{"/verification/" + target.property, "has no run with a value", "0", "1 or more", ""}});
  }
  Verification result{target.property, target.value, target.tolerance, std::move(values), 0, 0, 0, false, predicted};
  fill_statistics(result);
  result.bias = result.mean / target.value - 1.0;  // Eq. (S30)
  result.within = std::abs(result.bias) <= target.tolerance;
  return result;
}

}  // namespace asperity
