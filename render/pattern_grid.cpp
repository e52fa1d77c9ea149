#include "render/pattern_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "render/crack_legend.hpp"
#include "render/side_panel.hpp"
#include "render/specimen.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

// Pixels.
constexpr double kMargin = 36, kGap = 36, kHeader = 118, kRowGap = 20;
constexpr double kWidest = 2100, kHighest = 1500;  // all panels of a picture together, without their texts
constexpr double kNarrowest = 300, kNarrowestPicture = 1100;
constexpr double kHeadingRow = 40, kLineRow = 32, kHeadingSize = 27, kLineSize = 24;
constexpr double kRoseRadius = 62, kRoseRow = 150, kWideEnough = 560;
constexpr double kLegendFoot = 76, kBarFoot = 120, kNoteRow = 44, kFootUnit = 0.85, kScaleBarText = 170,
                 kColourBar = 620;
constexpr double kStandardSpecimen = 950;  // height of a specimen whose lines are as wide as the style says

Text text_at(Vec2 at, const std::string& text, double size, Weight weight = Weight::regular,
             Colour colour = style::kInk, Anchor anchor = Anchor::left) {
  return {at, text, size, anchor, weight, Direction::across, colour};
}

/// What a frame takes at one pixel a millimetre.
Vec2 room_mm(const Frame& frame) {
  const View view = fit_view(frame, {0, 0, 1000, 1000});
  return {view.area.width() / view.pixels_per_mm, view.specimen_mm.y + 2 * view.platen_mm};
}

/// Columns, scale and the size of a cell's parts.
struct Layout {
  int columns = 1, rows = 1;
  double pixels_per_mm = 0;
  double panel_width = 0, specimen_height = 0, text_height = 0, rose_height = 0;
  bool roses_beside = false;  ///< The texts, where there is room; else they stand below.
  double text_width() const { return panel_width - (roses_beside ? kRoseRow : 0); }
  double cell_height() const { return specimen_height + text_height + rose_height; }
  double width() const { return std::max(kNarrowestPicture, 2 * kMargin + columns * (panel_width + kGap) - kGap); }
};

Vec2 largest_room_mm(const PatternGrid& grid) {
  Vec2 room;
  for (const PatternPanel& panel : grid.panels) {
    const Vec2 own = room_mm(panel.frame);
    room = {std::max(room.x, own.x), std::max(room.y, own.y)};
  }
  return room;
}

/// The number of columns that shows the specimens largest and leaves the fewest cells empty.
Layout place_panels(const PatternGrid& grid) {
  const Vec2 room = largest_room_mm(grid);
  const int count = static_cast<int>(grid.panels.size());
  Layout best;
  double most = 0;
  for (int columns = 1; columns <= count; ++columns) {
    const int rows = (count + columns - 1) / columns;
    const double scale = std::min((kWidest / columns - kGap) / room.x, kHighest / rows / room.y);
    const double filled = scale * count / (rows * columns);
    if (filled <= most) continue;
    most = filled;
    best = {columns, rows, scale, std::max(kNarrowest, scale * room.x), std::ceil(scale * room.y), 0, 0};
  }
  return best;
}

std::vector<std::string> lines_of(const PatternPanel& panel, double width) {
  std::vector<std::string> all;
  for (const std::string& line : panel.lines)
    for (std::string& part : wrapped(line, kLineSize, width)) all.push_back(std::move(part));
  return all;
}

Layout layout_of(const PatternGrid& grid) {
  assert(!grid.panels.empty());
  Layout layout = place_panels(grid);
  const bool roses = std::any_of(grid.panels.begin(), grid.panels.end(),
                                 [](const PatternPanel& panel) { return !panel.rose.shares.empty(); });
  layout.roses_beside = roses && layout.panel_width >= kWideEnough;
  std::size_t lines = 0;
  for (const PatternPanel& panel : grid.panels) lines = std::max(lines, lines_of(panel, layout.text_width()).size());
  layout.text_height = kHeadingRow + kLineRow * static_cast<double>(lines) + kRowGap;
  if (layout.roses_beside)
    layout.text_height = std::max(layout.text_height, kRoseRow);
  else if (roses)
    layout.rose_height = kRoseRow;
  return layout;
}

void draw_texts(Drawing& drawing, const PatternPanel& panel, Vec2 top_left, double width) {
  double y = top_left.y + kHeadingRow - 8;
  const double size = fitting_size(panel.heading, kHeadingSize, Weight::bold, width);
  drawing.shapes.push_back(text_at({top_left.x, y}, panel.heading, size, Weight::bold));
  for (const std::string& line : lines_of(panel, width)) {
    y += kLineRow;
    const double fitting = fitting_size(line, kLineSize, Weight::regular, width);
    drawing.shapes.push_back(text_at({top_left.x, y}, line, fitting, Weight::regular, style::kSoftInk));
  }
}

/// The specimen in the middle of its cell, standing on the bottom that all of its row have.
View place_specimen(const PatternPanel& panel, const Layout& layout, Vec2 top_left) {
  const Vec2 size = layout.pixels_per_mm * room_mm(panel.frame);
  const double left = top_left.x + 0.5 * (layout.panel_width - size.x), bottom = top_left.y + layout.specimen_height;
  View view = fit_view(panel.frame, {left, bottom - size.y, left + size.x, bottom});
  view.pixels_per_mm = layout.pixels_per_mm;
  view.beside = 0.4 * kGap;
  return view;
}

double line_unit(const View& view) {
  const double pixels = view.pixels_per_mm * std::max(view.specimen_mm.x, view.specimen_mm.y);
  return std::clamp(std::sqrt(pixels / kStandardSpecimen), 0.45, 1.0);
}

void draw_panel(Drawing& drawing, const PatternPanel& panel, Field field, const Layout& layout, Vec2 top_left) {
  PictureOptions options;
  options.field = field;
  const View view = place_specimen(panel, layout, top_left);
  draw_specimen(drawing, panel.frame, options, view, line_unit(view));
  const double below = top_left.y + layout.specimen_height;
  draw_texts(drawing, panel, {top_left.x, below}, layout.text_width());
  if (panel.rose.shares.empty()) return;
  const Vec2 rose = layout.roses_beside
                        ? Vec2{top_left.x + layout.panel_width - 0.5 * kRoseRow, below + 0.5 * kRoseRow + 4}
                        : Vec2{top_left.x + 0.5 * kRoseRow, below + layout.text_height + 0.45 * kRoseRow};
  draw_rose(drawing, rose, kRoseRadius, panel.rose);
}

bool any_defect(const PatternGrid& grid) {
  return std::any_of(grid.panels.begin(), grid.panels.end(),
                     [](const PatternPanel& panel) { return has_defects(panel.frame); });
}

double foot_height(const PatternGrid& grid) {
  return (field_colours(grid.field) ? kBarFoot : kLegendFoot) +
         (grid.panels.front().rose.shares.empty() ? 0 : kNoteRow);
}

void draw_foot(Drawing& drawing, const PatternGrid& grid, const Layout& layout, double top) {
  View view = place_specimen(grid.panels.front(), layout, {kMargin, top - layout.specimen_height});
  view.area.left = kMargin;
  draw_scale_bar(drawing, view, kFootUnit);
  const double bar = round_step(std::max(view.specimen_mm.x, view.specimen_mm.y), 6) * view.pixels_per_mm;
  const double left = kMargin + bar + kScaleBarText;
  if (const auto colours = field_colours(grid.field)) {
    draw_colour_bar(drawing, *colours, {field_range(grid.field, {}), {0, 1}},
                    {left, top, left + kColourBar, top + kBarFoot}, kFootUnit);
  } else {
    draw_crack_legend(drawing, any_defect(grid), {left, top + 36 * kFootUnit}, drawing.width - kMargin - left,
                      kFootUnit);
  }
  const PatternPanel& first = grid.panels.front();
  if (first.rose.shares.empty()) return;
  const std::string note = fmt::format(
      "Roses: crack length by orientation at rest, the loading axis upwards; areas go by length, the ring stands for "
      "{:.0f} % within {:g}°.",
      100 * first.rose.outer, 180.0 / static_cast<double>(first.rose.shares.size()));
  const double width = drawing.width - 2 * kMargin;
  drawing.shapes.push_back(text_at({kMargin, drawing.height - 22.0}, note,
                                   fitting_size(note, 22, Weight::regular, width), Weight::regular, style::kSoftInk));
}

}  // namespace

double pattern_grid_scale(const PatternGrid& grid) { return place_panels(grid).pixels_per_mm; }

Drawing draw_pattern_grid(const PatternGrid& grid) {
  const Layout layout = layout_of(grid);
  const double foot = kHeader + layout.rows * (layout.cell_height() + kRowGap);
  Drawing drawing{
      static_cast<int>(std::ceil(layout.width())), static_cast<int>(std::ceil(foot + foot_height(grid))), {}};
  const double room = drawing.width - 2 * kMargin;
  drawing.shapes.push_back(
      text_at({kMargin, 58}, grid.title, fitting_size(grid.title, 36, Weight::bold, room), Weight::bold));
  drawing.shapes.push_back(text_at({kMargin, 96}, grid.subtitle, fitting_size(grid.subtitle, 26, Weight::regular, room),
                                   Weight::regular, style::kSoftInk));
  for (std::size_t i = 0; i < grid.panels.size(); ++i) {
    const auto column = static_cast<double>(i % static_cast<std::size_t>(layout.columns));
    const auto row = static_cast<double>(i / static_cast<std::size_t>(layout.columns));
    draw_panel(drawing, grid.panels[i], grid.field, layout,
               {kMargin + column * (layout.panel_width + kGap), kHeader + row * (layout.cell_height() + kRowGap)});
  }
  draw_foot(drawing, grid, layout, foot);
  return drawing;
}

}  // namespace asperity::render
