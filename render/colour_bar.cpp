#include "render/colour_bar.hpp"

#include <algorithm>
#include <cmath>

#include "render/chart_layers.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kBefore = 20, kWidth = 28, kTick = 7, kGap = 8;  // pixels
constexpr double kLineHeight = 1.3;                               // of a tick's text, parts of its size
constexpr double kCapHeight = 0.73;                               // of DejaVu Sans, parts of the size

double widest_level(const FieldLayer& field, double size) {
  double width = 0;
  for (std::size_t i = 0; i < field.levels.size(); ++i) width = std::max(width, text_width(level_name(field, i), size));
  return width;
}

/// Every how many levels one gets a number, so that numbers do not touch.
std::size_t stride(std::size_t bands, double height, double tick_size) {
  return static_cast<std::size_t>(
      std::max(1.0, std::ceil(kLineHeight * tick_size * static_cast<double>(bands) / height)));
}

void draw_level(Drawing& drawing, double right, double y, const std::string& label, const AxesStyle& style) {
  add_line(drawing, {right, y}, {right + kTick, y}, {style::kInk, style.line_width, {}, Cap::butt});
  drawing.shapes.push_back(Text{{right + kTick + kGap, y + 0.5 * kCapHeight * style.tick_size},
                                label,
                                style.tick_size,
                                Anchor::left,
                                Weight::regular,
                                Direction::across,
                                style::kInk});
}

}  // namespace

double colour_bar_room(const FieldLayer& field, const AxesStyle& style) {
  return kBefore + kWidth + kTick + 2 * kGap + widest_level(field, style.tick_size) + 1.3 * style.label_size;
}

void draw_colour_bar(Drawing& drawing, const Box& frame, const FieldLayer& field, const AxesStyle& style) {
  const std::vector<Colour> colours = band_colours(field);
  const double left = std::round(frame.right + kBefore), right = left + kWidth;
  const double band = frame.height() / static_cast<double>(colours.size());
  const std::size_t every = stride(colours.size(), frame.height(), style.tick_size);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const double bottom = frame.bottom - static_cast<double>(i) * band;
    add_box(drawing, {left, bottom - band, right, bottom}, colours[i]);
    if (i == 0 || (i - 1) % every != 0) continue;
    draw_level(drawing, right, bottom, level_name(field, i - 1), style);
  }
  add_frame(drawing, {left, frame.top, right, frame.bottom}, {style::kInk, style.line_width, {}, Cap::butt});
  const double beyond = right + kTick + 2 * kGap + widest_level(field, style.tick_size) + 0.95 * style.label_size;
  const double size = fitting_size(field.value_label, style.label_size, Weight::regular, frame.height());
  drawing.shapes.push_back(Text{{beyond, frame.centre().y},
                                field.value_label,
                                size,
                                Anchor::centre,
                                Weight::regular,
                                Direction::upwards,
                                style::kInk});
}

}  // namespace asperity::render
