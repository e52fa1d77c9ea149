#pragma once
#include <cstddef>
#include <vector>

#include "core/calibration/desirability.hpp"

/// All parameter sets that meet the targets, by the fitted models.
namespace asperity {

/// Where the models may be asked: the sphere |x| <= alpha, or the cube |x_i| <= alpha.
enum class RegionShape { sphere, cube };

struct SearchRegion {
  RegionShape shape = RegionShape::sphere;
  double alpha = 0;
};

bool inside(const SearchRegion& region, const std::vector<double>& x);

/// The nearest point of the sphere, or the point clamped into the cube.
std::vector<double> drawn_in(const SearchRegion& region, std::vector<double> x);

struct SearchOptions {
  DesirabilityOptions desirability;
  std::size_t starts = 256;      ///< Of a Sobol sequence over the region; the centre is one more.
  double cluster_radius = 0.05;  ///< Coded distance below which two solutions are one.
};

/// A point of the search.
struct Optimum {
  std::vector<double> x;  ///< Coded.
  double desirability = 0;
  bool within_tolerance = false;  ///< Every response is within its target's tolerance.
  /// How many directions of x change no response (to 1e-6 of the largest change): then this is one point of a curve or
  /// surface of solutions, the one of least |x|.
  std::size_t free_directions = 0;
};

struct Optima {
  std::vector<Optimum> solutions;  ///< All distinct ones inside the region, most desirable first; empty: none.
  Optimum compromise;  ///< The most desirable point of the region, or nearest to the targets where all is 0.
};

/// Levenberg-Marquardt for the misses of Eq. (S17) from every start: its ends inside the region where every response is
/// within tolerance are the solutions. COBYLA on the merit, Eq. (S22), from the best points: its best end is the
/// compromise, and the only solution where it is within tolerance although no end of the first kind is inside.
Optima find_optima(const ResponseSystem& system, const SearchRegion& region, const SearchOptions& options);

/// Where Levenberg-Marquardt ends that starts at x: a point where the sum of squared misses cannot be lowered. It may
/// leave the design.
std::vector<double> least_misses(const ResponseSystem& system, std::vector<double> x);

}  // namespace asperity
