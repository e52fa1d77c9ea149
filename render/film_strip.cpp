#include "render/film_strip.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "render/crack_legend.hpp"
#include "render/range.hpp"
#include "render/specimen.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kMargin = 24, kGap = 20, kCaptionRow = 52, kScaleBarRow = 72;  // pixels
constexpr double kScaleBarText = 190;                                           // pixels, behind the bar
constexpr double kKeyUnit = 0.85;
constexpr double kUnit = 0.75;    // line widths, of the standard picture's
constexpr double kTallest = 1.6;  // of a panel, of its width

void draw_panel(Drawing& drawing, const StripPanel& panel, Field field, const Box& room) {
  PictureOptions options;
  options.field = field;
  View view = fit_view(panel.frame, room);
  const double left = room.left + 0.5 * (room.width() - view.area.width());
  view.area = {left, room.top, left + view.area.width(), room.bottom};
  view.beside = 0.4 * kGap;
  draw_specimen(drawing, panel.frame, options, view, kUnit);
  const double size = fitting_size(panel.caption, style::kLabelSize, Weight::regular, room.width());
  drawing.shapes.push_back(Text{{room.centre().x, room.bottom + kCaptionRow - 12},
                                panel.caption,
                                size,
                                Anchor::centre,
                                Weight::regular,
                                Direction::across,
                                style::kInk});
}

/// As high as the specimen is at the panel's full width.
double panel_height(const Frame& frame, double width) {
  const View view = fit_view(frame, {0, 0, width, kTallest * width});
  return std::ceil((view.specimen_mm.y + 2 * view.platen_mm) * view.pixels_per_mm) + 4;
}

/// Beside the scale bar.
void draw_key(Drawing& drawing, const std::vector<StripPanel>& panels, const View& view) {
  const bool defects =
      std::any_of(panels.begin(), panels.end(), [](const StripPanel& panel) { return has_defects(panel.frame); });
  const double bar = round_step(std::max(view.specimen_mm.x, view.specimen_mm.y), 6) * view.pixels_per_mm;
  const double left = kMargin + bar + kScaleBarText;
  draw_crack_legend(drawing, defects, {left, view.area.bottom + 36}, drawing.width - kMargin - left, kKeyUnit);
}

}  // namespace

Drawing draw_film_strip(const std::vector<StripPanel>& panels, Field field, int width) {
  assert(!panels.empty());
  const double count = static_cast<double>(panels.size());
  const double panel = (width - 2 * kMargin - (count - 1) * kGap) / count;
  const double height = panel_height(panels.front().frame, panel), bottom = kMargin + height;
  Drawing drawing{width, static_cast<int>(bottom + kCaptionRow + kScaleBarRow), {}};
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double left = kMargin + static_cast<double>(i) * (panel + kGap);
    draw_panel(drawing, panels[i], field, {left, kMargin, left + panel, bottom});
  }
  View view = fit_view(panels.front().frame, {kMargin, kMargin, kMargin + panel, bottom});
  view.area.bottom += kCaptionRow;
  draw_scale_bar(drawing, view, 1.0);
  if (field == Field::cracks) draw_key(drawing, panels, view);
  return drawing;
}

}  // namespace asperity::render
