#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Factors of a calibration, and the runs that tell most about them.
namespace asperity {

/// How a coded level becomes a microparameter: centre + step x, or centre step^x.
enum class FactorScale { linear, logarithmic };

/// One microparameter that the calibration varies.
struct Factor {
  std::string name;     ///< "x1", "x2", ...
  std::string pointer;  ///< JSON pointer in the run config, e.g. "/contacts/tensile_strength_mpa".
  std::string label, symbol, unit;
  double centre = 0;                       ///< Real value at the coded level 0.
  double step = 1;                         ///< Real units per coded unit; on the logarithmic scale a ratio above 1.
  std::optional<double> lower{}, upper{};  ///< Real values that no run may leave.
  FactorScale scale = FactorScale::linear;
};

/// Real value at a coded level, Eq. (S1).
double decode(const Factor& factor, double coded);

/// Its inverse.
double encode(const Factor& factor, double real);

/// A point's real values, factor by factor; `coded` has as many.
std::vector<double> decode(const std::vector<Factor>& factors, std::span<const double> coded);

enum class PointKind { factorial, star, centre };

/// Distance of the star points from the centre: `rotatable`, (2^k)^(1/4), where the variance of a prediction depends on
/// the distance from the centre alone; `spherical`, sqrt(k), on the sphere through the corners of the cube.
enum class StarDistance { rotatable, spherical };

/// Runs as rows, coded levels of the factors as columns.
struct Design {
  std::vector<Factor> factors;
  double alpha = 0;  ///< Coded distance of the star points: how far the design reaches along each axis.
  std::vector<std::vector<double>> coded;
  std::vector<PointKind> kind;  ///< One a row.
};

/// The coded distance of the star points for k factors, Eq. (S2).
double star_distance(std::size_t factors, StarDistance distance);

/// The central composite design: 2^k corners (x1 changes fastest), two star points a factor (minus, then plus), then
/// the centre points. Throws what check_design throws.
Design central_composite(std::vector<Factor> factors, StarDistance distance, std::size_t centre_points = 6);

/// The design's real values, row by row.
std::vector<std::vector<double>> real_matrix(const Design& design);

/// Throws one Error(config) that lists every fault of the factors ("/factors/0/step", ...): none or more than 10, a
/// pointer twice, steps that are no steps, limits the wrong way round, and star points beyond a limit.
void check_design(const Design& design);

}  // namespace asperity
