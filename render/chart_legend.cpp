#include "render/chart_legend.hpp"

#include <algorithm>

#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kSwatch = 64, kSwatchHeight = 26, kMarkerSwatch = 34, kGap = 12, kBetween = 40, kRow = 42;  // pixels
constexpr double kCasing = 2.5;                                                                              // pixels
constexpr double kTextSize = 26;

const std::string& label_of(const Layer& layer) {
  static const std::string none;
  return std::visit(
      [](const auto& l) -> const std::string& {
        if constexpr (requires { l.label; })
          return l.label;
        else
          return none;
      },
      layer);
}

double swatch_width(const Layer& layer) { return std::holds_alternative<PointLayer>(layer) ? kMarkerSwatch : kSwatch; }

/// Draws what a layer looks like, from its left middle on.
struct SwatchPainter {
  Drawing& drawing;
  Vec2 left;
  Box box() const { return {left.x, left.y - 0.5 * kSwatchHeight, left.x + kSwatch, left.y + 0.5 * kSwatchHeight}; }
  void line(const Stroke& stroke) const { add_line(drawing, left, left + Vec2{kSwatch, 0}, stroke); }
  void operator()(const LineLayer& layer) const { line(layer.stroke); }
  void operator()(const BandLayer& layer) const { add_box(drawing, box(), layer.fill); }
  void operator()(const PointLayer& layer) const {
    add_marker(drawing, left + Vec2{0.5 * kMarkerSwatch, 0}, layer.marker);
  }
  void operator()(const BoxLayer& layer) const {
    if (layer.fill) add_box(drawing, box(), *layer.fill);
    if (layer.edge) add_frame(drawing, box(), *layer.edge);
  }
  void operator()(const ContourLayer& layer) const {
    line({style::kPaper, layer.stroke.width + 2 * kCasing, {}, Cap::butt});
    line(layer.stroke);
  }
  void operator()(const FieldLayer&) const {}
};

std::vector<const Layer*> labelled_layers(const std::vector<Chart>& charts) {
  std::vector<const Layer*> found;
  for (const Chart& chart : charts)
    for (const Layer& layer : chart.layers) {
      const std::string& label = label_of(layer);
      const bool known =
          std::any_of(found.begin(), found.end(), [&](const Layer* other) { return label_of(*other) == label; });
      if (!label.empty() && !known) found.push_back(&layer);
    }
  return found;
}

}  // namespace

double draw_chart_legend(Drawing& drawing, const std::vector<Chart>& charts, const Box& room) {
  const std::vector<const Layer*> layers = labelled_layers(charts);
  double x = room.left, y = room.top + 0.5 * kRow;
  for (const Layer* layer : layers) {
    const std::string& label = label_of(*layer);
    const double before = swatch_width(*layer) + kGap;
    const double size = fitting_size(label, kTextSize, Weight::regular, room.width() - before);
    const double width = before + text_width(label, size);
    if (x > room.left && x + width > room.right) {
      x = room.left;
      y += kRow;
    }
    std::visit(SwatchPainter{drawing, {x, y}}, *layer);
    drawing.shapes.push_back(Text{
        {x + before, y + 0.36 * size}, label, size, Anchor::left, Weight::regular, Direction::across, style::kInk});
    x += width + kBetween;
  }
  return layers.empty() ? room.top : y + 0.5 * kRow + kGap;
}

}  // namespace asperity::render
