#include "render/rose_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "render/axes.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"
#include "render/title_caption.hpp"

namespace asperity::render {
namespace {

constexpr double kTextSize = 24, kHeadingSize = 28, kHeadingRoom = 50;  // pixels
constexpr double kTextGap = 12, kOverhang = 34;                         // beyond the circle, pixels
constexpr double kDegree = std::numbers::pi / 180;
constexpr int kRingCorners = 120;
constexpr std::array<double, 12> kOuterShares{0.04, 0.08, 0.12, 0.16, 0.2, 0.24, 0.32, 0.4, 0.52, 0.64, 0.8, 1.0};

/// A circle of a rose and what its rim stands for.
struct Circle {
  Vec2 centre;
  double radius = 0;
  double share = 1;  ///< Of a sector that reaches the rim.
  Vec2 at(double degrees, double distance) const {
    return centre + distance * Vec2{std::cos(degrees * kDegree), -std::sin(degrees * kDegree)};
  }
  /// Areas are shares.
  double reach(double of_share) const { return radius * std::sqrt(of_share / share); }
};

double total(const Rose& rose) { return std::accumulate(rose.sectors.begin(), rose.sectors.end(), 0.0); }

/// The first round share that holds every sector of every rose.
double outer_share(const std::vector<Rose>& roses) {
  double largest = 0;
  for (const Rose& rose : roses)
    for (const double length : rose.sectors) largest = std::max(largest, total(rose) > 0 ? length / total(rose) : 0);
  return *std::find_if(kOuterShares.begin(), kOuterShares.end() - 1, [&](double s) { return s >= largest; });
}

void draw_sector(Drawing& drawing, const Circle& circle, double from, double to, double reach, Colour fill) {
  constexpr int kParts = 6;
  Polygon wedge{{circle.centre}, fill};
  for (int i = 0; i <= kParts; ++i) wedge.corners.push_back(circle.at(from + (to - from) * i / kParts, reach));
  drawing.shapes.push_back(wedge);
  std::vector<Vec2> outline = wedge.corners;
  outline.push_back(circle.centre);
  drawing.shapes.push_back(Polyline{outline, {style::kPaper, 1.5, {}, Cap::butt}});
}

void draw_sectors(Drawing& drawing, const Circle& circle, const Rose& rose) {
  const double whole = total(rose), width = 180.0 / static_cast<double>(rose.sectors.size());
  if (whole == 0) return;
  for (std::size_t i = 0; i < rose.sectors.size(); ++i) {
    const double from = width * static_cast<double>(i), reach = circle.reach(rose.sectors[i] / whole);
    if (reach == 0) continue;
    for (const double turn : {0.0, 180.0})
      draw_sector(drawing, circle, from + turn, from + width + turn, reach, rose.fill);
  }
}

void draw_ring(Drawing& drawing, const Circle& circle, double distance, const Stroke& stroke) {
  std::vector<Vec2> ring;
  for (int i = 0; i <= kRingCorners; ++i) ring.push_back(circle.at(360.0 * i / kRingCorners, distance));
  drawing.shapes.push_back(Polyline{ring, stroke});
}

Text text_at(Vec2 at, const std::string& words, Anchor anchor, Colour colour) {
  return {at, words, kTextSize, anchor, Weight::regular, Direction::across, colour};
}

/// What the rings stand for, outside the circle at its lower right, where no sector can lie.
void draw_ring_names(Drawing& drawing, const Circle& circle, double inner_share, double outer_share) {
  const Vec2 at = circle.at(-45, circle.radius + kTextGap) + Vec2{0, kTextSize};
  const std::string shares = tick_label(100 * inner_share, 1) + ", " + tick_label(100 * outer_share, 1) + " %";
  drawing.shapes.push_back(text_at(at, "rings:", Anchor::left, style::kInk));
  drawing.shapes.push_back(text_at(at + Vec2{0, 1.2 * kTextSize}, shares, Anchor::left, style::kInk));
}

/// The angles of the upper half, every 30 degrees but the marked direction, which has a name.
void draw_angles(Drawing& drawing, const Circle& circle, double marked) {
  for (int degrees = 0; degrees < 180; degrees += 30) {
    if (std::abs(degrees - marked) < 15) continue;
    const double across = std::cos(degrees * kDegree);
    const Anchor anchor = across > 0.2 ? Anchor::left : across < -0.2 ? Anchor::right : Anchor::centre;
    const Vec2 at = circle.at(degrees, circle.radius + kTextGap) + Vec2{0, 0.35 * kTextSize};
    drawing.shapes.push_back(text_at(at, std::to_string(degrees) + "°", anchor, style::kSoftInk));
  }
}

void draw_axis(Drawing& drawing, const Circle& circle, const RosePlot& plot) {
  const Stroke stroke{style::kInk, 3, {14, 8}, Cap::butt};
  const Vec2 head = circle.at(plot.axis_deg, circle.radius + kOverhang);
  add_line(drawing, circle.at(plot.axis_deg + 180, circle.radius + kOverhang), head, stroke);
  const bool upright = std::abs(std::cos(plot.axis_deg * kDegree)) < 0.5;
  // Beside the end of an upright line; over that of a level one, clear of the circle.
  const Vec2 at = upright ? head + Vec2{kTextGap, 0.5 * kTextSize}
                          : circle.at(plot.axis_deg, circle.radius + 0.5 * kTextGap) - Vec2{0, kTextGap};
  drawing.shapes.push_back(text_at(at, plot.axis_label, Anchor::left, style::kInk));
}

void draw_rose(Drawing& drawing, const RosePlot& plot, const Rose& rose, const Box& room, double share) {
  const double left = text_width("150°", kTextSize) + kTextGap;
  const double radius =
      std::min(0.5 * room.width() - left, 0.5 * (room.height() - kHeadingRoom) - kOverhang - kTextSize);
  const Circle circle{{room.centre().x, room.bottom - radius - kOverhang}, radius, share};
  const double size = fitting_size(rose.heading, kHeadingSize, Weight::bold, room.width());
  drawing.shapes.push_back(Text{{room.centre().x, room.top + kHeadingSize},
                                rose.heading,
                                size,
                                Anchor::centre,
                                Weight::bold,
                                Direction::across,
                                style::kInk});
  draw_sectors(drawing, circle, rose);
  draw_ring(drawing, circle, radius, {style::kOutline, 2, {}, Cap::butt});
  draw_ring(drawing, circle, 0.5 * radius, {style::kOutline, 1.5, {4, 6}, Cap::butt});
  draw_axis(drawing, circle, plot);
  draw_angles(drawing, circle, plot.axis_deg);
  draw_ring_names(drawing, circle, 0.25 * share, share);
}

}  // namespace

Drawing draw_roses(const RosePlot& plot) {
  Drawing drawing{plot.width, plot.height, {}};
  const double top = draw_title(drawing, plot.title), bottom = draw_caption(drawing, plot.caption);
  const double share = plot.roses.empty() ? 1 : outer_share(plot.roses);
  const double width =
      (plot.width - 2 * kFigureMargin) / static_cast<double>(std::max<std::size_t>(1, plot.roses.size()));
  for (std::size_t i = 0; i < plot.roses.size(); ++i) {
    const double left = kFigureMargin + width * static_cast<double>(i);
    draw_rose(drawing, plot, plot.roses[i], {left, top, left + width, bottom}, share);
  }
  return drawing;
}

}  // namespace asperity::render
