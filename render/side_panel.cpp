#include "render/side_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/axes.hpp"
#include "render/force_chains.hpp"
#include "render/fragment_colours.hpp"
#include "render/specimen.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kRow = 48, kSwatch = 84, kBarHeight = 36;  // pixels of the standard picture
constexpr int kBarSteps = 256, kBarParts = 5;
constexpr double kPercent = 100;
constexpr double kForceSwatchWidth = 6;

Text label(Vec2 at, const std::string& text, double size, Anchor anchor = Anchor::left) {
  return {at, text, size, anchor, Weight::regular, Direction::across, style::kInk};
}

/// A row's text, shrunk where the room is too narrow.
void draw_row_text(Drawing& drawing, Vec2 at, const std::string& text, double unit, double right) {
  const double size = fitting_size(text, style::kLabelSize * unit, Weight::regular, right - at.x);
  drawing.shapes.push_back(label(at + Vec2{0, 0.36 * size}, text, size));
}

struct CrackRow {
  CrackMode mode;
  const char* text;
};

double draw_crack_key(Drawing& drawing, const Frame& frame, const Box& room, double unit) {
  const CrackRow rows[] = {{CrackMode::tension, "Broken in tension"},
                           {CrackMode::shear, "Broken in shear"},
                           {CrackMode::softening, "Softening, not broken"},
                           {CrackMode::defect, "Open before the test"}};
  double y = room.top + 0.5 * kRow * unit;
  for (const auto& [mode, text] : rows) {
    const auto count = std::count_if(frame.cracks.begin(), frame.cracks.end(),
                                     [wanted = mode](const CrackSegment& crack) { return crack.mode == wanted; });
    if (mode == CrackMode::defect && count == 0) continue;
    draw_crack_swatch(drawing, mode, {room.left + 6 * unit, y}, {room.left + kSwatch * unit, y}, unit);
    draw_row_text(drawing, {room.left + (kSwatch + 20) * unit, y}, fmt::format("{}: {}", text, count), unit,
                  room.right);
    y += kRow * unit;
  }
  return y - 0.5 * kRow * unit;
}

const char* text_of(ForceClass kind) {
  switch (kind) {
    case ForceClass::compression:
      return "Compression";
    case ForceClass::tension:
      return "Tension";
    case ForceClass::broken:
      return "Bond broken";
    case ForceClass::general:
      return "New contact";
  }
  return "";
}

std::string force_text(double force_n) {
  if (force_n >= 1e3) return fmt::format("{:.3g} kN", 1e-3 * force_n);
  return force_n >= 0.1 ? fmt::format("{:.3g} N", force_n) : fmt::format("{:.3g} mN", 1e3 * force_n);
}

/// The widest line and two narrower ones, with the forces they stand for.
double draw_width_key(Drawing& drawing, const ForceScale& scale, const Box& room, double unit) {
  double y = room.top + 0.5 * kRow * unit;
  draw_row_text(drawing, {room.left, y}, "Line width: normal force", unit, room.right);
  for (const double part : {1.0, 0.5, 0.2}) {
    y += kRow * unit;
    const double force = part * scale.largest_n;
    draw_force(drawing, ForceClass::compression, {room.left + 6 * unit, y}, {room.left + kSwatch * unit, y},
               scale.width(force));
    draw_row_text(drawing, {room.left + (kSwatch + 20) * unit, y}, force_text(force) + (part == 1 ? " and more" : ""),
                  unit, room.right);
  }
  return y + 0.5 * kRow * unit;
}

double draw_force_key(Drawing& drawing, const Frame& frame, const ForceScale& scale, const Box& room, double unit) {
  double y = room.top + 0.5 * kRow * unit;
  for (const ForceClass kind : kForceClasses) {
    const auto count = std::count_if(frame.contacts.begin(), frame.contacts.end(),
                                     [kind](const ContactForce& contact) { return force_class(contact) == kind; });
    draw_force(drawing, kind, {room.left + 6 * unit, y}, {room.left + kSwatch * unit, y}, kForceSwatchWidth * unit);
    draw_row_text(drawing, {room.left + (kSwatch + 20) * unit, y}, fmt::format("{}: {}", text_of(kind), count), unit,
                  room.right);
    y += kRow * unit;
  }
  const Box below{room.left, y - 0.5 * kRow * unit, room.right, room.bottom};
  return scale.largest_n > 0 ? draw_width_key(drawing, scale, below, unit) : below.top;
}

std::vector<std::string> fragment_rows(const std::vector<FragmentShare>& order) {
  std::vector<std::string> rows;
  double rest = 1;
  for (std::size_t i = 0; i < std::min(order.size(), style::kFragments.size() + 1); ++i) {
    rows.push_back(i == 0 ? fmt::format("Largest: {:.1f} % of the area", kPercent * order[i].share)
                          : fmt::format("Fragment {}: {:.2f} %", i + 1, kPercent * order[i].share));
    rest -= order[i].share;
  }
  if (order.size() > rows.size())
    rows.push_back(fmt::format("{} smaller: {:.2f} %", order.size() - rows.size(), kPercent * std::max(rest, 0.0)));
  return rows;
}

/// The colours of the fragments that a row stands for: one, or all muted ones.
std::vector<Colour> row_colours(std::size_t row) {
  if (row == 0) return {style::kLargestFragment};
  if (row <= style::kFragments.size()) return {style::kFragments[row - 1]};
  return {style::kSmallFragments.begin(), style::kSmallFragments.end()};
}

void draw_fragment_swatch(Drawing& drawing, const Box& swatch, const std::vector<Colour>& colours, double unit) {
  const double width = swatch.width() / static_cast<double>(colours.size());
  double left = swatch.left;
  for (const Colour colour : colours) {
    add_box(drawing, {left, swatch.top, left + width, swatch.bottom}, colour);
    left += width;
  }
  add_frame(drawing, swatch, {style::kSoftInk, 1.5 * unit, {}, Cap::butt});
}

double draw_fragment_key(Drawing& drawing, const Frame& frame, const Box& room, double unit) {
  const std::vector<std::string> rows = fragment_rows(fragments_by_area(frame));
  const double row_height = 42 * unit;
  double y = room.top + 0.5 * row_height;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Box swatch{room.left, y - 14 * unit, room.left + 46 * unit, y + 14 * unit};
    draw_fragment_swatch(drawing, swatch, row_colours(i), unit);
    draw_row_text(drawing, {room.left + 64 * unit, y}, rows[i], unit, room.right);
    y += row_height;
  }
  return y - 0.5 * row_height;
}

/// Pointed ends say that there are values beyond.
void draw_bar_ends(Drawing& drawing, const Box& bar, ColourMap map, Range range, Range values) {
  const double middle = bar.centre().y, tip = 0.5 * bar.height();
  if (values.low < range.low - 1e-9 * (range.high - range.low))
    drawing.shapes.push_back(
        Triangle{{Vec2{bar.left, bar.top}, {bar.left, bar.bottom}, {bar.left - tip, middle}}, colour_at(map, 0)});
  if (values.high > range.high + 1e-9 * (range.high - range.low))
    drawing.shapes.push_back(
        Triangle{{Vec2{bar.right, bar.top}, {bar.right, bar.bottom}, {bar.right + tip, middle}}, colour_at(map, 1)});
}

void draw_bar(Drawing& drawing, const Box& bar, ColourMap map) {
  for (int i = 0; i < kBarSteps; ++i) {
    const double left = bar.left + bar.width() * i / kBarSteps;
    add_box(drawing, {left, bar.top, bar.right, bar.bottom}, colour_at(map, (i + 0.5) / kBarSteps));
  }
}

void draw_bar_ticks(Drawing& drawing, const Box& bar, const Axis& axis, double unit) {
  for (const Tick& tick : axis.ticks) {
    const double x = std::round(bar.left + fraction_in(axis.range, tick.value) * bar.width());
    add_line(drawing, {x, bar.bottom}, {x, bar.bottom + 8 * unit}, {style::kInk, 2 * unit, {}, Cap::butt});
    drawing.shapes.push_back(label({x, bar.bottom + (12 + 0.9 * style::kTickSize) * unit}, tick.label,
                                   style::kTickSize * unit, Anchor::centre));
  }
}

/// Encloses the curve, the present point and zero, with some headroom but on the side where zero is the end.
Range inset_range(double low, double high, double present) {
  const Range all{std::min({low, present, 0.0}), std::max({high, present, 0.0})};
  if (all.low == all.high) return all;
  const Range wide = widened(all, 0.06);
  return {all.low < 0 ? wide.low : 0, wide.high};
}

}  // namespace

void draw_crack_swatch(Drawing& drawing, CrackMode mode, Vec2 a, Vec2 b, double unit) {
  using namespace style;
  if (mode == CrackMode::tension) add_line(drawing, a, b, {kTension, kTensionWidth * unit, {}, Cap::round});
  if (mode == CrackMode::defect) add_line(drawing, a, b, {kDefect, kDefectWidth * unit, {}, Cap::round});
  if (mode == CrackMode::softening) add_line(drawing, a, b, {kSoftening, kSofteningWidth * unit, {}, Cap::round});
  if (mode != CrackMode::shear) return;
  add_line(drawing, a, b, {kShear, kShearWidth * unit, {}, Cap::round});
  add_line(drawing, a, b, {kShearCore, kShearCoreWidth * unit, {}, Cap::round});
}

double draw_colour_bar(Drawing& drawing, const FieldColours& colours, const ShownRanges& ranges, const Box& room,
                       double unit) {
  const Axis axis = make_axis(ranges.shown, colours.label, kBarParts);
  const double indent = 26 * unit, top = room.top + 1.5 * style::kLabelSize * unit;
  const Box bar{room.left + indent, top, room.right - indent, top + kBarHeight * unit};
  const double size = fitting_size(axis.label, style::kLabelSize * unit, Weight::regular, bar.width());
  drawing.shapes.push_back(label({bar.left, room.top + 0.95 * style::kLabelSize * unit}, axis.label, size));
  draw_bar(drawing, bar, colours.map);
  draw_bar_ends(drawing, bar, colours.map, axis.range, ranges.values);
  add_frame(drawing, bar, {style::kInk, 2 * unit, {}, Cap::butt});
  draw_bar_ticks(drawing, bar, axis, unit);
  return bar.bottom + (22 + 0.9 * style::kTickSize) * unit;
}

ExperimentTexts experiment_texts(const Frame& frame) {
  if (frame.experiment == "brazilian")
    return {"Brazilian disc", "Closure / diameter", "Tensile stress 2P/(πDt)", "%", 100};
  if (frame.experiment == "uniaxial") return {"Uniaxial compression", "Axial strain", "Axial stress", "%", 100};
  if (frame.experiment == "triaxial") return {"Triaxial compression", "Axial strain", "Axial stress σ₁", "%", 100};
  if (frame.experiment == "direct_shear") {
    return {"Direct shear", "Shear displacement", "Shear stress", "mm", frame.joint.length_mm};
  }
  return {frame.experiment, "Axial strain", "Axial stress", "%", 100};
}

double draw_key(Drawing& drawing, const Frame& frame, const PictureOptions& options, const View& view, const Box& room,
                double unit) {
  if (options.field == Field::cracks) return draw_crack_key(drawing, frame, room, unit);
  if (options.field == Field::contacts)
    return draw_force_key(drawing, frame, force_scale(frame, options, view, unit), room, unit);
  if (options.field == Field::fragments) return draw_fragment_key(drawing, frame, room, unit);
  const std::vector<double> values = field_values(frame, options.field);
  const Range shown = options.value_range.value_or(field_range(options.field, values));
  return draw_colour_bar(drawing, *field_colours(options.field), {shown, range_of(values)}, room, unit);
}

namespace {
PlotArea inset_area(const Frame& frame, const PictureOptions& options, const Box& room, const AxesStyle& sizes) {
  const Range strain = options.strain_range.value_or(range_of(frame.curve.axial_strain));
  const Range stress = options.stress_range.value_or(range_of(frame.curve.stress_mpa));
  const ExperimentTexts texts = experiment_texts(frame);
  const double k = texts.strain_factor;
  const Range x = inset_range(k * strain.low, k * strain.high, k * frame.axial_strain);
  const Range y = inset_range(stress.low, stress.high, frame.stress_mpa);
  return fit_axes(room, make_axis(x, texts.strain + " [" + texts.strain_unit + "]", 4),
                  make_axis(y, texts.stress + " [MPa]", 6), {}, sizes);
}
}  // namespace

void draw_inset(Drawing& drawing, const Frame& frame, const PictureOptions& options, const Box& room, double unit) {
  const AxesStyle sizes{style::kTickSize * unit, style::kLabelSize * unit, 2 * unit};
  const PlotArea area = inset_area(frame, options, room, sizes);
  const double factor = experiment_texts(frame).strain_factor;
  const auto place = [&](double strain, double stress) { return area.place(factor * strain, stress); };
  draw_grid(drawing, area, sizes);
  Polyline curve{{}, {style::kBlue, style::kLineWidth * unit, {}, Cap::butt}};
  const std::vector<double>&strain = frame.curve.axial_strain, &stress = frame.curve.stress_mpa;
  for (std::size_t i = 0; i < std::min(strain.size(), stress.size()); ++i)
    if (std::isfinite(strain[i]) && std::isfinite(stress[i])) curve.points.push_back(place(strain[i], stress[i]));
  if (curve.points.size() > 1) drawing.shapes.push_back(curve);
  draw_axes(drawing, area, sizes);
  const Vec2 point = place(frame.axial_strain, frame.stress_mpa);
  add_disc(drawing, point, (style::kPresentPointRadius + 3) * unit, style::kPaper);
  add_disc(drawing, point, style::kPresentPointRadius * unit, style::kVermilion);
}

}  // namespace asperity::render
