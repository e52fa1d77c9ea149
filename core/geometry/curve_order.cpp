#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/geometry/mesh.hpp"

namespace asperity {
namespace {

constexpr int kLevels = 16;  // 65,536 cells along a side: finer than any mesh.

/// Position of cell (x, y) on the Hilbert curve through 2^kLevels by 2^kLevels cells.
std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y) {
  std::uint64_t index = 0;
  for (std::uint32_t s = 1u << (kLevels - 1); s > 0; s /= 2) {
    const std::uint32_t right = (x & s) ? 1 : 0, upper = (y & s) ? 1 : 0;
    index = 4 * index + ((3 * right) ^ upper);
    x &= s - 1;
    y &= s - 1;
    if (upper) continue;
    if (right) {
      x = s - 1 - x;
      y = s - 1 - y;
    }
    std::swap(x, y);
  }
  return index;
}

std::vector<std::uint64_t> curve_positions(const Mesh& mesh) {
  Vec2 low = mesh.vertices.front(), high = low;
  for (const Vec2& p : mesh.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double cells = ((1u << kLevels) - 1) / std::max(high.x - low.x, high.y - low.y);
  std::vector<std::uint64_t> positions;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec2 centroid = (1.0 / 3.0) * (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]);
    const Vec2 cell = cells * (centroid - low);
    positions.push_back(hilbert_index(static_cast<std::uint32_t>(cell.x), static_cast<std::uint32_t>(cell.y)));
  }
  return positions;
}

/// New numbers in the order in which the old ones are first asked for.
class Renumbering {
 public:
  explicit Renumbering(std::size_t n) : fresh_(n, -1) {}
  /// The new number, and whether it has just been given out.
  std::pair<int, bool> operator()(int old) {
    const bool first = fresh_[old] < 0;
    if (first) fresh_[old] = next_++;
    return {fresh_[old], first};
  }

 private:
  std::vector<int> fresh_;
  int next_ = 0;
};

}  // namespace

std::vector<int> curve_order(const Mesh& mesh) {
  if (mesh.triangles.empty()) return {};
  const std::vector<std::uint64_t> position = curve_positions(mesh);
  std::vector<int> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return position[a] < position[b]; });
  return order;
}

Mesh sort_along_curve(const Mesh& mesh) {
  if (mesh.triangles.empty()) return mesh;
  Mesh sorted;
  sorted.outline_area_mm2 = mesh.outline_area_mm2;
  Renumbering vertex(mesh.vertices.size()), grain(mesh.triangles.size());
  for (int t : curve_order(mesh)) {
    std::array<int, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      const int old = mesh.triangles[t][k];
      const auto [fresh, first] = vertex(old);
      if (first) sorted.vertices.push_back(mesh.vertices[old]);
      corners[k] = fresh;
    }
    sorted.triangles.push_back(corners);
    sorted.grain.push_back(grain(mesh.grain[t]).first);
  }
  return sorted;
}

}  // namespace asperity
