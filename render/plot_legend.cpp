#include "render/plot_legend.hpp"

#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kSwatch = 92, kGap = 14, kBetween = 44, kRow = 44;  // pixels
constexpr double kPale = 0.45;                                       // how far an area's colour goes towards white

Colour paler(Colour colour) {
  const auto mix = [](std::uint8_t c) { return static_cast<std::uint8_t>(c + kPale * (255 - c)); };
  return {mix(colour.r), mix(colour.g), mix(colour.b)};
}

void draw_swatch(Drawing& drawing, const PlotSeries& series, const SeriesLook& look, Vec2 left_middle) {
  const Vec2 right = left_middle + Vec2{kSwatch, 0};
  if (series.style.kind == SeriesKind::stacked_area) {
    const Box box{left_middle.x, left_middle.y - 13, right.x, left_middle.y + 13};
    add_box(drawing, box, look.fill);
    add_line(drawing, {box.left, box.top}, {box.right, box.top}, {look.stroke.colour, 2, {}, Cap::butt});
    return;
  }
  if (series.style.kind != SeriesKind::points) add_line(drawing, left_middle, right, look.stroke);
  if (series.style.kind != SeriesKind::line)
    add_disc(drawing, left_middle + Vec2{0.5 * kSwatch, 0}, style::kMarkerRadius, look.stroke.colour);
}

}  // namespace

SeriesLook look_of(const Plot& plot, std::size_t series) {
  const int count = static_cast<int>(style::kLines.size());
  const int asked = plot.series[series].style.look.value_or(static_cast<int>(series));
  const std::size_t look = static_cast<std::size_t>((asked % count + count) % count);
  const Colour colour = style::kLines[look];
  return {{colour, style::kLineWidth, style::kDashes[look], Cap::butt}, paler(colour)};
}

double draw_plot_legend(Drawing& drawing, const Plot& plot, const Box& room) {
  double x = room.left, y = room.top + 0.5 * kRow;
  bool drawn = false;
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    const PlotSeries& series = plot.series[s];
    if (series.label.empty()) continue;
    const double size = fitting_size(series.label, style::kLabelSize, Weight::regular, room.width() - kSwatch - kGap);
    const double width = kSwatch + kGap + text_width(series.label, size);
    if (x > room.left && x + width > room.right) {
      x = room.left;
      y += kRow;
    }
    draw_swatch(drawing, series, look_of(plot, s), {x, y});
    drawing.shapes.push_back(Text{{x + kSwatch + kGap, y + 0.36 * size},
                                  series.label,
                                  size,
                                  Anchor::left,
                                  Weight::regular,
                                  Direction::across,
                                  style::kInk});
    x += width + kBetween;
    drawn = true;
  }
  return drawn ? y + 0.5 * kRow + kGap : room.top;
}

}  // namespace asperity::render
