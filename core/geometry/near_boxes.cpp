#include "core/geometry/near_boxes.hpp"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>

#include "core/geometry/moderate.hpp"

namespace asperity {
namespace {

/// What CGAL asks of a box: its bounds by dimension and an id that breaks ties.
struct BoxTraits {
  using NT = double;
  using ID = const Box*;
  using Box_parameter = const Box*;
  static ID id(Box_parameter box) { return box; }
  static NT min_coord(Box_parameter box, int dimension) { return dimension == 0 ? box->low.x : box->low.y; }
  static NT max_coord(Box_parameter box, int dimension) { return dimension == 0 ? box->high.x : box->high.y; }
  static int dimension() { return 2; }
};

/// Ascending order in linear time: by the first index with one count, then each index's few partners.
std::vector<std::array<int, 2>> sorted(const std::vector<std::array<int, 2>>& pairs, std::size_t boxes) {
  std::vector<std::size_t> begin(boxes + 1, 0);
  for (const auto& pair : pairs) ++begin[pair[0] + 1];
  for (std::size_t i = 0; i < boxes; ++i) begin[i + 1] += begin[i];
  std::vector<std::array<int, 2>> result(pairs.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (const auto& pair : pairs) result[next[pair[0]]++] = pair;
  for (std::size_t i = 0; i < boxes; ++i) {
    std::sort(result.data() + begin[i], result.data() + begin[i + 1]);
  }
  return result;
}

}  // namespace

std::vector<std::array<int, 2>> near_boxes(const std::vector<Box>& boxes) {
  for (const Box& box : boxes) require_moderate(std::array{box.low, box.high});  // CGAL sorts them
  std::vector<const Box*> handles;
  handles.reserve(boxes.size());
  for (const Box& box : boxes) handles.push_back(&box);
  std::vector<std::array<int, 2>> pairs;
  const auto report = [&](const Box* a, const Box* b) {
    const int i = static_cast<int>(a - boxes.data()), j = static_cast<int>(b - boxes.data());
    pairs.push_back({std::min(i, j), std::max(i, j)});
  };
  constexpr std::ptrdiff_t kCutoff = 10;  // CGAL's own default
  CGAL::box_self_intersection_d(handles.begin(), handles.end(), report, BoxTraits(), kCutoff,
                                CGAL::Box_intersection_d::CLOSED);
  return sorted(pairs, boxes.size());
}

}  // namespace asperity
