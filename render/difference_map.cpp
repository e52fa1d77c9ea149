#include "render/difference_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "render/outline.hpp"
#include "render/side_panel.hpp"
#include "render/specimen.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr int kWidth = 1600, kHeight = 1200;
constexpr double kMargin = 36, kHeader = 124, kScaleBarRow = 62, kPanel = 560, kRow = 52, kSwatch = 84;  // pixels
constexpr Range kRange{-1, 1};

Vec2 at_rest(const Frame& frame, int node) {
  const auto i = static_cast<std::size_t>(node);
  return frame.position[i] - frame.displacement[i];
}

std::vector<double> differences(const DifferenceMap& map) {
  assert(map.first.damage.size() == map.second.damage.size());
  std::vector<double> values(map.first.damage.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = map.second.damage[i] - map.first.damage[i];
  return values;
}

void draw_particles(Drawing& drawing, const DifferenceMap& map, const View& view) {
  const std::vector<double> values = differences(map);
  for (std::size_t i = 0; i < values.size(); ++i) {
    Triangle triangle{{}, colour_at(ColourMap::red_blue, fraction_in(kRange, values[i]))};
    for (std::size_t c = 0; c < 3; ++c) triangle.corners[c] = view.place(at_rest(map.first, map.first.triangles[i][c]));
    drawing.shapes.push_back(triangle);
  }
  for (const auto& [a, b] : outline_edges(map.first))
    add_line(drawing, view.place(at_rest(map.first, a)), view.place(at_rest(map.first, b)),
             {style::kOutline, style::kOutlineWidth, {}, Cap::round});
}

/// Both: plain ink. One alone: a white casing, then a solid line for the first, dots for the second.
void draw_crack(Drawing& drawing, BrokenIn in, Vec2 a, Vec2 b) {
  if (in == BrokenIn::both) return add_line(drawing, a, b, {style::kInk, 3, {}, Cap::round});
  add_line(drawing, a, b, {style::kPaper, 8, {}, Cap::round});
  if (in == BrokenIn::first) return add_line(drawing, a, b, {style::kBlue, 5, {}, Cap::round});
  add_line(drawing, a, b, {style::kVermilion, 5, {7, 4}, Cap::butt});
}

double draw_legend(Drawing& drawing, const DifferenceMap& map, const Box& room) {
  const std::pair<BrokenIn, std::string> rows[] = {{BrokenIn::both, "Broken in both"},
                                                   {BrokenIn::first, "Broken in " + map.names[0] + " alone"},
                                                   {BrokenIn::second, "Broken in " + map.names[1] + " alone"}};
  double y = room.top;
  for (const auto& [in, words] : rows) {
    const auto count = std::count_if(map.cracks.begin(), map.cracks.end(),
                                     [wanted = in](const ComparedCrack& crack) { return crack.in == wanted; });
    const std::string text = words + ": " + std::to_string(count);
    draw_crack(drawing, in, {room.left + 6, y}, {room.left + kSwatch, y});
    const double left = room.left + kSwatch + 20;
    const double size = fitting_size(text, style::kLabelSize, Weight::regular, room.right - left);
    drawing.shapes.push_back(
        Text{{left, y + 0.36 * size}, text, size, Anchor::left, Weight::regular, Direction::across, style::kInk});
    y += kRow;
  }
  return y;
}

void draw_header(Drawing& drawing, const DifferenceMap& map) {
  const auto add = [&](double y, const std::string& text, double size, Weight weight, Colour colour) {
    const double fitting = fitting_size(text, size, weight, kWidth - 2 * kMargin);
    drawing.shapes.push_back(Text{{kMargin, y}, text, fitting, Anchor::left, weight, Direction::across, colour});
  };
  add(62, map.title, style::kTitleSize, Weight::bold, style::kInk);
  add(102, map.subtitle, 26, Weight::regular, style::kSoftInk);
}

}  // namespace

Drawing draw_difference_map(const DifferenceMap& map) {
  Drawing drawing{kWidth, kHeight, {}};
  draw_header(drawing, map);
  const View view =
      fit_view(map.first, {kMargin, kHeader, kWidth - kPanel - 2 * kMargin, kHeight - kMargin - kScaleBarRow});
  draw_particles(drawing, map, view);
  for (const BrokenIn in : {BrokenIn::both, BrokenIn::first, BrokenIn::second})
    for (const ComparedCrack& crack : map.cracks)
      if (crack.in == in) draw_crack(drawing, in, view.place(crack.end[0]), view.place(crack.end[1]));
  draw_scale_bar(drawing, view, 1);
  const Box panel{view.area.right + kMargin, kHeader, static_cast<double>(kWidth) - kMargin, kHeight - kMargin};
  const FieldColours colours{ColourMap::red_blue, "Damage in " + map.names[1] + " less that in " + map.names[0]};
  const double below = draw_colour_bar(drawing, colours, {kRange, range_of(differences(map))}, panel, 1);
  draw_legend(drawing, map, {panel.left, below + kRow, panel.right, panel.bottom});
  return drawing;
}

}  // namespace asperity::render
