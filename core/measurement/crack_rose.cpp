#include "core/measurement/crack_rose.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {

std::vector<double> rose_lengths(std::span<const double> orientation_deg, std::span<const double> length_mm,
                                 int sectors) {
  std::vector<double> lengths(static_cast<std::size_t>(sectors), 0.0);
  const double width = 180.0 / sectors;
  for (std::size_t i = 0; i < std::min(orientation_deg.size(), length_mm.size()); ++i) {
    const double turned = orientation_deg[i] - 180.0 * std::floor(orientation_deg[i] / 180.0);
    const auto sector = static_cast<std::size_t>(turned / width);
    lengths[std::min(sector, lengths.size() - 1)] += length_mm[i];
  }
  return lengths;
}

}  // namespace asperity
