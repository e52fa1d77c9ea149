#include <algorithm>
#include <cmath>

#include "render/chart_layers.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kLineWidth = 1.6, kLabelSize = 22, kNameSize = 24, kLabelPad = 5, kCasing = 2.5;  // pixels
constexpr double kDarkBelow = 120;        // luminance, 0 to 255
constexpr std::size_t kPlacesALine = 24;  // tried for a line's label

double luminance(Colour c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

/// Ink on light colours, white on dark ones.
Colour readable_on(Colour background) { return luminance(background) < kDarkBelow ? style::kPaper : style::kInk; }

std::vector<Vec2> placed(const PlotArea& area, const std::vector<Vec2>& points) {
  std::vector<Vec2> pixels;
  for (const Vec2 p : points) {
    const Vec2 at = area.place(p.x, p.y);
    pixels.push_back(
        {std::clamp(at.x, area.box.left, area.box.right), std::clamp(at.y, area.box.top, area.box.bottom)});
  }
  return pixels;
}

using Lines = std::vector<std::vector<Vec2>>;

/// A grid's lines at a level in pixels, cut at the frame, the longest first.
Lines lines_at(const PlotArea& area, const ScalarGrid& grid, double level) {
  Lines lines;
  for (const auto& line : contour_lines(grid, level)) {
    std::vector<Vec2> pixels;
    for (const Vec2 p : line) pixels.push_back(area.place(p.x, p.y));
    for (auto& part : clipped(pixels, area.box)) lines.push_back(std::move(part));
  }
  std::stable_sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return lines;
}

Box grown(const Box& box, double by) { return {box.left - by, box.top - by, box.right + by, box.bottom + by}; }

double length_of(const std::vector<Vec2>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += norm(line[i] - line[i - 1]);
  return length;
}

/// Numbers 0 to n - 1 from the middle outwards.
std::vector<std::size_t> from_the_middle(std::size_t n) {
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [n](std::size_t a, std::size_t b) {
    const auto off = [n](std::size_t i) { return 2 * i > n ? 2 * i - n : n - 2 * i; };
    return off(a) < off(b);
  });
  return order;
}

/// A place on the line where its label is inside the frame and `fits`, if there is one.
template <class Fits>
std::optional<Text> label_on(const PlotArea& area, const std::vector<Vec2>& line, Text label, const Fits& fits) {
  const double wanted = 2.2 * text_width(label.text, label.size, label.weight);
  if (length_of(line) < wanted) return std::nullopt;
  for (const std::size_t k : from_the_middle(kPlacesALine)) {
    label.at = line[(line.size() - 1) * k / kPlacesALine] + Vec2{0, 0.36 * label.size};
    const Box box = grown(text_box(label), kLabelPad);
    if (within(box, grown(area.box, -kLabelPad)) && fits(box)) return label;
  }
  return std::nullopt;
}

/// What is left of lines outside a box.
Lines without(const Lines& lines, const Box& box) {
  Lines left;
  for (const auto& line : lines) {
    left.emplace_back();
    for (const Vec2 p : line) {
      const bool inside = p.x > box.left && p.x < box.right && p.y > box.top && p.y < box.bottom;
      if (!inside) left.back().push_back(p);
      if (inside && !left.back().empty()) left.emplace_back();
    }
  }
  std::erase_if(left, [](const auto& line) { return line.size() < 2; });
  return left;
}

/// More points on long segments, so that a gap for a label ends where the label does.
std::vector<Vec2> refined(const std::vector<Vec2>& line) {
  constexpr double kStep = 4;  // pixels
  std::vector<Vec2> points{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 d = line[i] - line[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(norm(d) / kStep)));
    for (int k = 1; k <= parts; ++k) points.push_back(line[i - 1] + (static_cast<double>(k) / parts) * d);
  }
  return points;
}

bool holds_point_of(const Lines& lines, const Box& box) {
  return std::any_of(lines.begin(), lines.end(), [&](const auto& line) {
    return std::any_of(line.begin(), line.end(), [&](Vec2 p) { return near_box(p, box); });
  });
}

/// A field's lines at all its levels, ready for labels.
std::vector<Lines> level_lines(const PlotArea& area, const FieldLayer& field) {
  std::vector<Lines> all;
  for (const double level : field.levels) {
    all.push_back(lines_at(area, field.grid, level));
    for (auto& line : all.back()) line = refined(line);
  }
  return all;
}

/// Where a level's label meets no other line and no other text; nowhere, if there is no such place. The colour bar then
/// tells the level.
std::optional<Text> place_label(const PlotArea& area, const std::vector<Lines>& all, std::size_t level,
                                const Text& label, const Occupied& occupied) {
  const auto fits = [&](const Box& box) {
    if (!occupied.free(box) || !occupied.free_of_lines_but(nullptr, box)) return false;
    for (std::size_t other = 0; other < all.size(); ++other)
      if (other != level && holds_point_of(all[other], box)) return false;
    return true;
  };
  for (const auto& line : all[level])
    if (const auto text = label_on(area, line, label, fits)) return text;
  return std::nullopt;
}

/// Draws a level's lines with a gap for its label.
void draw_level(Drawing& drawing, Lines lines, const std::optional<Text>& label, const Stroke& stroke,
                Occupied& occupied) {
  if (label) {
    const Box box = grown(text_box(*label), kLabelPad);
    lines = without(lines, {box.left, box.top + 0.2 * label->size, box.right, box.bottom - 0.1 * label->size});
    occupied.boxes.push_back(box);
  }
  for (const auto& line : lines) drawing.shapes.push_back(Polyline{line, stroke});
  if (label) drawing.shapes.push_back(*label);
}

void fill_bands(Drawing& drawing, const PlotArea& area, const FieldLayer& field, const std::vector<Colour>& colours) {
  for (const auto& polygon : area_above(field.grid, -INFINITY))
    drawing.shapes.push_back(Polygon{placed(area, polygon), colours[0]});
  for (std::size_t i = 0; i < field.levels.size(); ++i)
    for (const auto& polygon : area_above(field.grid, field.levels[i]))
      drawing.shapes.push_back(Polygon{placed(area, polygon), colours[i + 1]});
}

}  // namespace

std::string level_name(const FieldLayer& field, std::size_t level) {
  if (level < field.level_names.size()) return field.level_names[level];
  const double step = field.levels.size() > 1 ? field.levels[1] - field.levels[0] : 0;
  return tick_label(field.levels[level], step);
}

std::vector<Colour> band_colours(const FieldLayer& field) {
  std::vector<Colour> colours;
  const double last = std::max<double>(1, static_cast<double>(field.levels.size()));
  for (std::size_t i = 0; i <= field.levels.size(); ++i)
    colours.push_back(colour_at(field.map, static_cast<double>(i) / last));
  return colours;
}

void draw_field(Drawing& drawing, const PlotArea& area, const FieldLayer& field, Occupied& occupied) {
  const std::vector<Colour> colours = band_colours(field);
  fill_bands(drawing, area, field, colours);
  const std::vector<Lines> all = level_lines(area, field);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Colour ink = readable_on(colours[i]);
    const Text label{{}, level_name(field, i), kLabelSize, Anchor::centre, Weight::regular, Direction::across, ink};
    draw_level(drawing, all[i], place_label(area, all, i, label, occupied), {ink, kLineWidth, {}, Cap::butt}, occupied);
  }
}

void draw_contour(Drawing& drawing, const PlotArea& area, const ContourLayer& contour) {
  const Stroke casing{style::kPaper, contour.stroke.width + 2 * kCasing, {}, Cap::butt};
  const Lines lines = lines_at(area, contour.grid, contour.level);
  for (const auto& line : lines) drawing.shapes.push_back(Polyline{line, casing});
  for (const auto& line : lines) drawing.shapes.push_back(Polyline{line, contour.stroke});
}

void draw_contour_name(Drawing& drawing, const PlotArea& area, const ContourLayer& contour, Occupied& occupied) {
  if (contour.name.empty()) return;
  const Text label{{}, contour.name, kNameSize, Anchor::centre, Weight::bold, Direction::across, style::kInk};
  const auto free = [&](const Box& box) { return occupied.free(box); };
  const auto clear = [&](const Box& box) { return free(box) && occupied.free_of_lines_but(&contour, box); };
  std::optional<Text> text;
  for (auto& line : lines_at(area, contour.grid, contour.level)) {
    line = refined(line);
    if (!text) text = label_on(area, line, label, clear);
    if (!text) text = label_on(area, line, label, free);
  }
  if (!text) return;
  const Box box = grown(text_box(*text), kLabelPad);
  add_box(drawing, box, style::kPaper);
  drawing.shapes.push_back(*text);
  occupied.boxes.push_back(box);
}

std::vector<double> round_levels(const std::vector<double>& values, int parts) {
  const Range range = range_of(values);
  if (!(range.high > range.low)) return {range.low};
  const double step = round_step(range.high - range.low, parts);
  std::vector<double> levels;
  for (double i = std::floor(range.low / step) + 1; i * step < range.high - 1e-9 * step; ++i)
    levels.push_back(i * step);
  if (levels.empty()) levels.push_back(0.5 * (range.low + range.high));
  return levels;
}

}  // namespace asperity::render
