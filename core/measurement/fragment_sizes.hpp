#pragma once
#include <span>
#include <vector>

namespace asperity {

/// Diameter (mm) of the disc of a fragment's area (mm2), Eq. (M43).
double equivalent_diameter(double area_mm2);

/// One step of a size distribution: fragments no larger than `size_mm` have this share of the whole area.
struct PassingStep {
  double size_mm = 0, share = 0;
};

/// Share of area passing over the size, ascending, one step a fragment, Eq. (M44).
std::vector<PassingStep> passing_curve(std::span<const double> area_mm2);

/// The smallest size (mm) of that curve at which so much passes; 0 without a fragment.
double passing_size(std::span<const double> area_mm2, double share);

}  // namespace asperity
