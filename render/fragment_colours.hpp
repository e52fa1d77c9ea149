#pragma once
#include <map>
#include <vector>

#include "core/measurement/frame.hpp"
#include "render/drawing.hpp"

namespace asperity::render {

/// Fragments by area, largest first, with their share of all area.
struct FragmentShare {
  int fragment = 0;
  double share = 0;
};
std::vector<FragmentShare> fragments_by_area(const Frame& frame);

/// The fill of every fragment: the largest neutral, the next ones each its own colour, all smaller ones muted colours
/// such that two which were neighbours before loading differ.
std::map<int, Colour> fragment_colours(const Frame& frame, const std::vector<FragmentShare>& order);

}  // namespace asperity::render
