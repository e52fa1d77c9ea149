#include "core/geometry/near_boxes.hpp"

#include <CGAL/box_intersection_d.h>

#include <algorithm>

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

}  // namespace

std::vector<std::array<int, 2>> near_boxes(const std::vector<Box>& boxes) {
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
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace asperity
