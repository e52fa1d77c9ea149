#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/measurement/frame.hpp"
#include "render/drawing.hpp"

namespace asperity::render {

/// Which of two runs on one mesh broke a contact.
enum class BrokenIn { first, second, both };

/// A contact edge at rest, mm.
struct ComparedCrack {
  std::array<Vec2, 2> end;
  BrokenIn in = BrokenIn::both;
};

/// Two runs on one mesh, drawn on it at rest: damage of the second less that of the first, and who broke what.
struct DifferenceMap {
  std::string title, subtitle;
  std::array<std::string, 2> names;  ///< Of the runs, for the legend.
  Frame first, second;               ///< Of one mesh.
  std::vector<ComparedCrack> cracks;
};

Drawing draw_difference_map(const DifferenceMap& map);

}  // namespace asperity::render
