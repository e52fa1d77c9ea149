#include "core/calibration/design.hpp"

#include <cmath>
#include <openturns/Axial.hxx>
#include <openturns/Factorial.hxx>

namespace asperity {
namespace {

std::vector<double> level_of(const OT::Sample& sample, std::size_t row) {
  std::vector<double> levels(sample.getDimension());
  for (std::size_t j = 0; j < levels.size(); ++j) levels[j] = sample(row, j);
  return levels;
}

void add_row(Design& design, std::vector<double> levels, PointKind kind) {
  design.coded.push_back(std::move(levels));
  design.kind.push_back(kind);
}

/// OpenTURNS puts the centre first, then the corners in standard order.
void add_corners(Design& design) {
  const OT::Sample corners = OT::Factorial(design.factors.size(), OT::Point(1, 1.0)).generate();
  for (std::size_t row = 1; row < corners.getSize(); ++row)
    add_row(design, level_of(corners, row), PointKind::factorial);
}

/// OpenTURNS puts the centre first, then plus before minus on each axis.
void add_stars(Design& design) {
  const OT::Sample stars = OT::Axial(design.factors.size(), OT::Point(1, design.alpha)).generate();
  for (std::size_t row = 1; row + 1 < stars.getSize(); row += 2) {
    add_row(design, level_of(stars, row + 1), PointKind::star);
    add_row(design, level_of(stars, row), PointKind::star);
  }
}

}  // namespace

double decode(const Factor& factor, double coded) {
  if (factor.scale == FactorScale::logarithmic) return factor.centre * std::pow(factor.step, coded);
  return factor.centre + factor.step * coded;
}

double encode(const Factor& factor, double real) {
  if (factor.scale == FactorScale::logarithmic) return std::log(real / factor.centre) / std::log(factor.step);
  return (real - factor.centre) / factor.step;
}

std::vector<double> decode(const std::vector<Factor>& factors, std::span<const double> coded) {
  std::vector<double> real(factors.size());
  for (std::size_t j = 0; j < real.size(); ++j) real[j] = decode(factors[j], coded[j]);
  return real;
}

double star_distance(std::size_t factors, StarDistance distance) {
  const auto k = static_cast<double>(factors);
  return distance == StarDistance::rotatable ? std::exp2(k / 4.0) : std::sqrt(k);
}

Design central_composite(std::vector<Factor> factors, StarDistance distance, std::size_t centre_points) {
  Design design{std::move(factors), 0.0, {}, {}};
  design.alpha = star_distance(design.factors.size(), distance);
  check_design(design);
  add_corners(design);
  add_stars(design);
  for (std::size_t i = 0; i < centre_points; ++i) {
    add_row(design, std::vector<double>(design.factors.size(), 0.0), PointKind::centre);
  }
  return design;
}

std::vector<std::vector<double>> real_matrix(const Design& design) {
  std::vector<std::vector<double>> real;
  for (const std::vector<double>& row : design.coded) real.push_back(decode(design.factors, row));
  return real;
}

}  // namespace asperity
