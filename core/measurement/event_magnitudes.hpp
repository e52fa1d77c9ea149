#pragma once
#include <optional>
#include <span>
#include <vector>

/// Magnitudes of acoustic events and the slope of their frequency, after Gutenberg & Richter. README.md has the
/// equations and what a fracture energy stands for here.
namespace asperity {

/// Magnitude of an event of a fracture energy (N mm, whole thickness; above 0), Eq. (M35).
double event_magnitude(double energy_n_mm);

/// Those of all events whose energy is above 0, in their order.
std::vector<double> event_magnitudes(std::span<const double> energies_n_mm);

/// Width of the bins in which the completeness is sought.
inline constexpr double kMagnitudeBin = 0.2;

/// A b-value needs so many events above the completeness: its error is then some 14 %.
inline constexpr int kLeastEvents = 50;

/// Frequency of magnitudes; log10 N(M or larger) = a - b M from the completeness on.
struct MagnitudeStatistics {
  int events = 0;                  ///< All of them.
  double completeness = 0;         ///< M_c, Eq. (M36).
  int complete = 0;                ///< Events of at least M_c.
  std::optional<double> b, error;  ///< Eqs. (M37), (M38); unset below kLeastEvents, or where all are of one magnitude.
  double a() const;                ///< Of that line; needs b.
};

/// Empty without an event.
std::optional<MagnitudeStatistics> magnitude_statistics(std::span<const double> magnitudes);

}  // namespace asperity
