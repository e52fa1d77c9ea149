#include "render/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/colour_map.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kGap = 0.45;        // between ticks, their labels and the axis label; parts of the tick size
constexpr double kTickLength = 0.3;  // parts of the tick size
constexpr double kLineHeight = 1.2;  // parts of a text's size
constexpr double kCapHeight = 0.73;  // of DejaVu Sans, parts of the size

/// The power of a thousand to take out of the numbers, 0 if they are handy.
int awkward_exponent(Range range, double step) {
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  if (largest < 1e5 && (step >= 1e-3 || largest >= 0.1)) return 0;
  return largest > 0 ? 3 * static_cast<int>(std::floor(std::log10(largest) / 3)) : 0;
}

std::string with_power(const std::string& label, int exponent) {
  if (exponent == 0) return label;
  const std::size_t unit = label.rfind('[');
  if (unit == std::string::npos) return label + " [" + power_of_ten(exponent) + "]";
  const std::string rest = label.substr(unit + 1), none = "–]";
  return label.substr(0, unit + 1) + power_of_ten(exponent) + (rest == none ? "]" : " " + rest);
}

double widest(const Axis& axis, double size) {
  double width = 0;
  for (const Tick& tick : axis.ticks) width = std::max(width, text_width(tick.label, size));
  return width;
}

/// Room a vertical axis takes beside the frame.
double side_room(const Axis& axis, const AxesStyle& style) {
  const double label = axis.label.empty() ? 0 : kLineHeight * style.label_size + kGap * style.tick_size;
  return widest(axis, style.tick_size) + 2 * kGap * style.tick_size + label;
}

/// The lines of a tick's label; names of categories may have two.
std::vector<std::string> lines_of(const std::string& label) {
  std::vector<std::string> lines(1);
  for (const char c : label)
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  return lines;
}

double tick_lines(const Axis& axis) {
  std::size_t lines = 1;
  for (const Tick& tick : axis.ticks) lines = std::max(lines, lines_of(tick.label).size());
  return static_cast<double>(lines);
}

double bottom_room(const Axis& axis, const AxesStyle& style) {
  const double label = axis.label.empty() ? 0 : kLineHeight * style.label_size + kGap * style.tick_size;
  return (kLineHeight * tick_lines(axis) + 2 * kGap) * style.tick_size + label;
}

void draw_x_axis(Drawing& drawing, const PlotArea& area, const AxesStyle& style) {
  const double gap = kGap * style.tick_size;
  const double baseline = area.box.bottom + gap + 1.1 * style.tick_size;
  for (const Tick& tick : area.x.ticks) {
    const double x = std::round(area.place(tick.value, area.y.range.low).x);
    add_line(drawing, {x, area.box.bottom}, {x, area.box.bottom + kTickLength * style.tick_size},
             {style::kInk, style.line_width, {}, Cap::butt});
    double down = 0;
    for (const std::string& line : lines_of(tick.label)) {
      const Vec2 at{x, baseline + down};
      drawing.shapes.push_back(
          Text{at, line, style.tick_size, Anchor::centre, Weight::regular, Direction::across, style::kInk});
      down += kLineHeight * style.tick_size;
    }
  }
  const double more_lines = (tick_lines(area.x) - 1) * kLineHeight * style.tick_size;
  const double below = baseline + more_lines + gap + kLineHeight * style.label_size;
  drawing.shapes.push_back(Text{{area.box.centre().x, below},
                                area.x.label,
                                style.label_size,
                                Anchor::centre,
                                Weight::regular,
                                Direction::across,
                                style::kInk});
}

/// A vertical axis at the frame's left (outwards -1) or right (+1) side.
void draw_y_axis(Drawing& drawing, const PlotArea& area, const Axis& axis, int outwards, const AxesStyle& style) {
  const double gap = kGap * style.tick_size, side = outwards < 0 ? area.box.left : area.box.right;
  for (const Tick& tick : axis.ticks) {
    const double y = std::round(area.box.bottom - fraction_in(axis.range, tick.value) * area.box.height());
    add_line(drawing, {side, y}, {side + outwards * kTickLength * style.tick_size, y},
             {style::kInk, style.line_width, {}, Cap::butt});
    drawing.shapes.push_back(Text{{side + outwards * gap, y + 0.5 * kCapHeight * style.tick_size},
                                  tick.label,
                                  style.tick_size,
                                  outwards < 0 ? Anchor::right : Anchor::left,
                                  Weight::regular,
                                  Direction::across,
                                  style::kInk});
  }
  const double beyond = side + outwards * (2 * gap + widest(axis, style.tick_size));
  const double baseline = outwards < 0 ? beyond - text_descent(style.label_size) : beyond + 0.95 * style.label_size;
  drawing.shapes.push_back(Text{{baseline, area.box.centre().y},
                                axis.label,
                                style.label_size,
                                Anchor::centre,
                                Weight::regular,
                                Direction::upwards,
                                style::kInk});
}

}  // namespace

std::string power_of_ten(int exponent) {
  static const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
  return text;
}

std::string tick_label(double value, double step) {
  const int decimals = step > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9) : 3;
  if (std::abs(value) < 1e-9 * step) value = 0;
  const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return value < 0 && !zero ? "−" + digits : digits;
}

Axis make_log_axis(Range exponents, const std::string& label) {
  constexpr double kFewDecades = 3, kPlainDigits = 4;
  if (!(exponents.high > exponents.low)) exponents = widened(exponents, 0.5);
  Axis axis{exponents, {}, label};
  const bool few = exponents.high - exponents.low < kFewDecades;
  for (int k = static_cast<int>(std::floor(exponents.low)); k <= exponents.high; ++k) {
    for (const int times : few ? std::vector<int>{1, 2, 5} : std::vector<int>{1}) {
      const double at = k + std::log10(times);
      if (at < exponents.low - 1e-9 || at > exponents.high + 1e-9) continue;
      const bool plain = few || std::abs(k) < kPlainDigits;
      axis.ticks.push_back({at, plain ? fmt::format("{:g}", times * std::pow(10.0, k)) : power_of_ten(k)});
    }
  }
  return axis;
}

Axis make_axis(Range range, const std::string& label, int parts) {
  if (range.low == 0 && range.high == 0) range.high = 1;
  if (!(range.high > range.low)) range = widened(range, 0.5);
  const double step = round_step(range.high - range.low, parts);
  const int exponent = awkward_exponent(range, step);
  const double unit = std::pow(10.0, exponent);
  Axis axis{range, {}, with_power(label, exponent)};
  for (double i = std::ceil(range.low / step - 1e-9); i * step <= range.high + 1e-9 * step; ++i)
    axis.ticks.push_back({i * step, tick_label(i * step / unit, step / unit)});
  return axis;
}

Vec2 PlotArea::place(double x_value, double y_value) const {
  return {box.left + fraction_in(x.range, x_value) * box.width(),
          box.bottom - fraction_in(y.range, y_value) * box.height()};
}

Vec2 PlotArea::place_second(double x_value, double y_value) const {
  return {box.left + fraction_in(x.range, x_value) * box.width(),
          box.bottom - fraction_in(second_y.range, y_value) * box.height()};
}

Margins axes_margins(const Axis& x, const Axis& y, const Axis& second_y, const AxesStyle& style) {
  const double overhang = x.ticks.empty() ? 0 : 0.5 * text_width(x.ticks.back().label, style.tick_size) + 2;
  const double right = second_y.ticks.empty() ? overhang : side_room(second_y, style);
  return {side_room(y, style), 0.5 * style.tick_size, right, bottom_room(x, style)};
}

PlotArea fit_axes(const Box& outer, Axis x, Axis y, Axis second_y, const AxesStyle& style) {
  const Margins room = axes_margins(x, y, second_y, style);
  const Box box{std::round(outer.left + room.left), std::round(outer.top + room.top),
                std::round(outer.right - room.right), std::round(outer.bottom - room.bottom)};
  return {box, std::move(x), std::move(y), std::move(second_y)};
}

void draw_grid(Drawing& drawing, const PlotArea& area, const AxesStyle& style) {
  const Stroke grid{style::kGrid, 0.75 * style.line_width, {}, Cap::butt};
  for (const Tick& tick : area.x.ticks) {
    const double x = std::round(area.place(tick.value, area.y.range.low).x);
    add_line(drawing, {x, area.box.top}, {x, area.box.bottom}, grid);
  }
  for (const Tick& tick : area.y.ticks) {
    const double y = std::round(area.place(area.x.range.low, tick.value).y);
    add_line(drawing, {area.box.left, y}, {area.box.right, y}, grid);
  }
}

void draw_axes(Drawing& drawing, const PlotArea& area, const AxesStyle& style) {
  add_frame(drawing, area.box, {style::kInk, style.line_width, {}, Cap::butt});
  draw_x_axis(drawing, area, style);
  draw_y_axis(drawing, area, area.y, -1, style);
  if (!area.second_y.ticks.empty()) draw_y_axis(drawing, area, area.second_y, +1, style);
}

}  // namespace asperity::render
