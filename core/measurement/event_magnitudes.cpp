#include "core/measurement/event_magnitudes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace asperity {
namespace {

constexpr double kJoulePerNmm = 1e-3;
constexpr double kEnergySlope = 1.5, kEnergyOffset = 4.8;  // Gutenberg & Richter: log10 E = 1.5 M + 4.8, E in J

/// Lower edge of the bin that most magnitudes lie in; of equal ones the highest, which is the safe side.
double maximum_curvature(std::span<const double> magnitudes) {
  std::map<long, int> counts;
  for (const double m : magnitudes) ++counts[std::lround(std::floor(m / kMagnitudeBin))];
  const auto most =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second <= b.second; });
  return kMagnitudeBin * static_cast<double>(most->first);
}

}  // namespace

double event_magnitude(double energy_n_mm) {
  return (std::log10(kJoulePerNmm * energy_n_mm) - kEnergyOffset) / kEnergySlope;
}

std::vector<double> event_magnitudes(std::span<const double> energies_n_mm) {
  std::vector<double> magnitudes;
  for (const double energy : energies_n_mm)
    if (energy > 0.0) magnitudes.push_back(event_magnitude(energy));
  return magnitudes;
}

double MagnitudeStatistics::a() const { return std::log10(complete) + *b * completeness; }

std::optional<MagnitudeStatistics> magnitude_statistics(std::span<const double> magnitudes) {
  if (magnitudes.empty()) return std::nullopt;
  MagnitudeStatistics result{static_cast<int>(magnitudes.size()), maximum_curvature(magnitudes), 0, {}, {}};
  std::vector<double> complete;
  for (const double m : magnitudes)
    if (m >= result.completeness) complete.push_back(m);
  result.complete = static_cast<int>(complete.size());
  const auto [least, largest] = std::minmax_element(complete.begin(), complete.end());
  if (result.complete < kLeastEvents || *least == *largest) return result;
  const double n = result.complete, mean = std::accumulate(complete.begin(), complete.end(), 0.0) / n;
  double squares = 0.0;
  for (const double m : complete) squares += (m - mean) * (m - mean);
  result.b = std::numbers::log10e / (mean - result.completeness);
  result.error = std::numbers::ln10 * *result.b * *result.b * std::sqrt(squares / (n * (n - 1.0)));
  return result;
}

}  // namespace asperity
