#include "render/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "render/force_chains.hpp"
#include "render/fragment_colours.hpp"
#include "render/outline.hpp"
#include "render/style.hpp"

namespace asperity::render {
namespace {

constexpr double kSideMargin = 0.05;                                 // of the specimen's width, at either side
constexpr double kPlatenThickness = 0.026;                           // of the specimen's larger side
constexpr double kPlatenOverDisc = 0.6, kPlatenOverRectangle = 1.1;  // widths of the platens, of the specimen's width
constexpr double kOutlineHalfWidth = 0.55;                           // pixels of the standard picture
constexpr double kOutlinesFromRadius = 3;  // pixels of the inscribed circle; below, outlines would hide the field
constexpr double kOutlinePaleness = 0.3;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

struct Extent {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
};

Extent extent_before_loading(const Frame& frame) {
  Extent extent;
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    const Vec2 p = frame.position[i] - frame.displacement[i];
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y)};
  }
  return frame.position.empty() ? Extent{{0, 0}, {1, 1}} : extent;
}

/// A joint's room: the lower half moves to the right, the upper one rises.
Extent room_of(const Frame& frame) {
  Extent extent = extent_before_loading(frame);
  extent.high.x += frame.joint.range_mm;
  extent.high.y += frame.joint.rise_mm;
  return extent;
}

Colour paler(Colour c) {
  const auto mix = [](std::uint8_t v) { return static_cast<std::uint8_t>(v + kOutlinePaleness * (255 - v)); };
  return {mix(c.r), mix(c.g), mix(c.b)};
}

/// The triangle with a paler outline: a full one in the outline's colour under a smaller one in its own.
void draw_particle(Drawing& drawing, const std::array<Vec2, 3>& corners, Colour fill, Colour outline,
                   double half_width) {
  const double a = norm(corners[1] - corners[2]), b = norm(corners[2] - corners[0]), c = norm(corners[0] - corners[1]);
  const double radius = std::abs(cross(corners[1] - corners[0], corners[2] - corners[0])) / (a + b + c);
  if (!(radius >= kOutlinesFromRadius)) {
    drawing.shapes.push_back(Triangle{corners, fill});
    return;
  }
  const Vec2 centre = (1 / (a + b + c)) * (a * corners[0] + b * corners[1] + c * corners[2]);
  std::array<Vec2, 3> inner = corners;
  for (Vec2& corner : inner) corner = centre + (1 - half_width / radius) * (corner - centre);
  drawing.shapes.push_back(Triangle{corners, outline});
  drawing.shapes.push_back(Triangle{inner, fill});
}

std::vector<Colour> particle_colours(const Frame& frame, const PictureOptions& options) {
  std::vector<Colour> colours(frame.triangles.size(), style::kSpecimen);
  if (options.field == Field::fragments) {
    const std::map<int, Colour> by_fragment = fragment_colours(frame, fragments_by_area(frame));
    for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = by_fragment.at(frame.fragment[i]);
  } else if (const auto field = field_colours(options.field)) {
    const std::vector<double> values = field_values(frame, options.field);
    const Range range = options.value_range.value_or(field_range(options.field, values));
    for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = colour_at(field->map, fraction_in(range, values[i]));
  }
  return colours;
}

/// Particles show through the crack network, and not under the forces, which are drawn between them.
Colour outline_colour(Field field, Colour fill) {
  if (field == Field::cracks) return style::kSpecimenEdge;
  return field == Field::contacts ? fill : paler(fill);
}

Vec2 shown_position(const Frame& frame, int node, double scale) {
  return frame.position[at(node)] + (scale - 1) * frame.displacement[at(node)];
}

void draw_particles(Drawing& drawing, const Frame& frame, const PictureOptions& options, const View& view,
                    double unit) {
  const std::vector<Colour> colours = particle_colours(frame, options);
  for (std::size_t i = 0; i < frame.triangles.size(); ++i) {
    std::array<Vec2, 3> corners;
    bool shown = true;
    for (std::size_t c = 0; c < 3; ++c) {
      corners[c] = view.place(shown_position(frame, frame.triangles[i][c], options.displacement_scale));
      shown = shown && view.shows(corners[c]);
    }
    const Colour outline = outline_colour(options.field, colours[i]);
    if (shown) draw_particle(drawing, corners, colours[i], outline, kOutlineHalfWidth * unit);
  }
}

void draw_outline(Drawing& drawing, const Frame& frame, const PictureOptions& options, const View& view, double unit) {
  const Stroke stroke{style::kOutline, style::kOutlineWidth * unit, {}, Cap::round};
  for (const auto& [from, to] : outline_edges(frame)) {
    const Vec2 a = view.place(shown_position(frame, from, options.displacement_scale));
    const Vec2 b = view.place(shown_position(frame, to, options.displacement_scale));
    if (view.shows(a) && view.shows(b)) add_line(drawing, a, b, stroke);
  }
}

void draw_cracks(Drawing& drawing, const Frame& frame, CrackMode mode, const Stroke& stroke, const View& view) {
  for (const CrackSegment& crack : frame.cracks) {
    const Vec2 a = view.place(crack.a), b = view.place(crack.b);
    if (crack.mode == mode && view.shows(a) && view.shows(b)) add_line(drawing, a, b, stroke);
  }
}

void draw_crack_network(Drawing& drawing, const Frame& frame, const View& view, double unit) {
  using namespace style;
  draw_cracks(drawing, frame, CrackMode::defect, {kDefect, kDefectWidth * unit, {}, Cap::round}, view);
  draw_cracks(drawing, frame, CrackMode::softening, {kSoftening, kSofteningWidth * unit, {}, Cap::round}, view);
  draw_cracks(drawing, frame, CrackMode::shear, {kShear, kShearWidth * unit, {}, Cap::round}, view);
  draw_cracks(drawing, frame, CrackMode::shear, {kShearCore, kShearCoreWidth * unit, {}, Cap::round}, view);
  draw_cracks(drawing, frame, CrackMode::tension, {kTension, kTensionWidth * unit, {}, Cap::round}, view);
}

void draw_broken(Drawing& drawing, const Frame& frame, const Stroke& stroke, const View& view) {
  for (const CrackMode mode : {CrackMode::tension, CrackMode::shear}) draw_cracks(drawing, frame, mode, stroke, view);
}

void draw_broken_over_field(Drawing& drawing, const Frame& frame, const View& view, double unit) {
  const Stroke casing{style::kBrokenCasing, style::kBrokenCasingWidth * unit, {}, Cap::round};
  const Stroke core{style::kBroken, style::kBrokenWidth * unit, {}, Cap::round};
  for (const Stroke& stroke : {casing, core}) draw_broken(drawing, frame, stroke, view);
}

void draw_forces(Drawing& drawing, const Frame& frame, const PictureOptions& options, const View& view, double unit) {
  draw_broken(drawing, frame, {style::kBrokenUnder, style::kBrokenUnderWidth * unit, {}, Cap::round}, view);
  draw_force_chains(drawing, frame, view, force_scale(frame, options, view, unit));
}

void draw_flat_platen(Drawing& drawing, const Frame& frame, const View& view, double unit, int side) {
  const double part = frame.experiment == "brazilian" ? kPlatenOverDisc : kPlatenOverRectangle;
  const double half = 0.5 * part * view.specimen_mm.x;
  const double face = frame.platen_y[at(side)], back = face + (side == 0 ? -1 : 1) * view.platen_mm;
  const Vec2 a = view.place({view.centre.x - half, std::max(face, back)});
  const Vec2 b = view.place({view.centre.x + half, std::min(face, back)});
  add_box(drawing, {a.x, a.y, b.x, b.y}, style::kPlaten);
  add_frame(drawing, {a.x, a.y, b.x, b.y}, {style::kPlatenEdge, 2 * unit, {}, Cap::butt});
}

/// Height of a jaw's face over its apex, mm; level beyond the arc.
double jaw_height(const FrameJaws& jaws, double x) {
  const double aside = std::min(std::abs(x - jaws.centre_x_mm), jaws.half_width_mm);
  return jaws.radius_mm - std::sqrt(std::max(0.0, jaws.radius_mm * jaws.radius_mm - aside * aside));
}

void draw_jaw(Drawing& drawing, const Frame& frame, const View& view, double unit, int side) {
  constexpr int kPieces = 96;  // of the arc: a corner of a degree at most between two of them
  const FrameJaws& jaws = frame.jaws;
  const double arc = jaws.half_width_mm, half = std::max(arc, 0.5 * kPlatenOverRectangle * view.specimen_mm.x);
  const double up = side == 0 ? 1 : -1, apex = frame.platen_y[at(side)];
  Band block{{}, {}, style::kPlaten};
  const auto add = [&](double aside) {
    const double x = jaws.centre_x_mm + aside;
    block.lower.push_back(view.place({x, apex + up * jaw_height(jaws, x)}));
    block.upper.push_back(view.place({x, apex - up * view.platen_mm}));
  };
  add(-half);
  for (int i = 0; i <= kPieces; ++i) add(arc * (2.0 * i / kPieces - 1.0));
  add(half);
  drawing.shapes.push_back(block);
  Polyline edge{block.lower, {style::kPlatenEdge, 2 * unit, {}, Cap::butt}};
  edge.points.insert(edge.points.end(), {block.upper.back(), block.upper.front(), block.lower.front()});
  drawing.shapes.push_back(edge);
}

/// The rigid blocks that a joint's halves are bonded to.
void draw_blocks(Drawing& drawing, const Frame& frame, const View& view, double unit) {
  const Extent rest = extent_before_loading(frame);
  const auto draw = [&](Vec2 low, Vec2 high) {
    const Vec2 a = view.place({low.x, high.y}), b = view.place({high.x, low.y});
    add_box(drawing, {a.x, a.y, b.x, b.y}, style::kPlaten);
    add_frame(drawing, {a.x, a.y, b.x, b.y}, {style::kPlatenEdge, 2 * unit, {}, Cap::butt});
  };
  const FrameJoint& joint = frame.joint;
  const double left = rest.low.x + joint.shear_mm, right = rest.high.x;  // an upper half may be shifted to the right
  for (int strip = 0; strip < joint.strips; ++strip) {
    const double bottom = rest.low.y + strip * joint.pitch_mm;
    const double top = rest.high.y - (joint.strips - 1 - strip) * joint.pitch_mm + joint.lift_mm;
    draw({left, bottom - view.platen_mm}, {left + joint.length_mm, bottom});
    draw({right - joint.length_mm, top}, {right, top + view.platen_mm});
  }
}

void draw_platens(Drawing& drawing, const Frame& frame, const View& view, double unit) {
  if (frame.joint.length_mm > 0.0) return draw_blocks(drawing, frame, view, unit);
  if (!(frame.platen_y[1] > frame.platen_y[0])) return;
  for (const int side : {0, 1}) {
    frame.jaws.radius_mm > 0 ? draw_jaw(drawing, frame, view, unit, side)
                             : draw_flat_platen(drawing, frame, view, unit, side);
  }
}

}  // namespace

Vec2 View::place(Vec2 mm) const { return area.centre() + pixels_per_mm * Vec2{mm.x - centre.x, centre.y - mm.y}; }

bool View::shows(Vec2 pixel) const {
  return pixel.x >= area.left - beside && pixel.x <= area.right + beside && pixel.y >= area.top &&
         pixel.y <= area.bottom;
}

View fit_view(const Frame& frame, const Box& room) {
  const Extent extent = room_of(frame);
  View view;
  view.specimen_mm = extent.high - extent.low;
  view.centre = 0.5 * (extent.low + extent.high);
  view.platen_mm = kPlatenThickness * std::max(view.specimen_mm.x, view.specimen_mm.y);
  const double width = std::max(1 + 2 * kSideMargin, kPlatenOverRectangle) * view.specimen_mm.x;
  const double height = view.specimen_mm.y + 2 * view.platen_mm;
  view.pixels_per_mm = std::min(room.width() / width, room.height() / height);
  view.area = room;
  view.area.right = room.left + width * view.pixels_per_mm;
  return view;
}

void draw_specimen(Drawing& drawing, const Frame& frame, const PictureOptions& options, const View& view, double unit) {
  draw_platens(drawing, frame, view, unit);
  draw_particles(drawing, frame, options, view, unit);
  draw_outline(drawing, frame, options, view, unit);
  if (options.field == Field::cracks)
    draw_crack_network(drawing, frame, view, unit);
  else if (options.field == Field::contacts)
    draw_forces(drawing, frame, options, view, unit);
  else if (options.field == Field::fragments && options.displacement_scale == 1)
    draw_broken(drawing, frame, {style::kInk, style::kFragmentEdgeWidth * unit, {}, Cap::round}, view);
  else if (options.field != Field::damage && options.displacement_scale == 1)
    draw_broken_over_field(drawing, frame, view, unit);
}

void draw_scale_bar(Drawing& drawing, const View& view, double unit) {
  const double length = round_step(std::max(view.specimen_mm.x, view.specimen_mm.y), 6);
  const Vec2 left{view.area.left + 2 * unit, view.area.bottom + 36 * unit};
  const Vec2 right = left + Vec2{length * view.pixels_per_mm, 0}, end{0, 10 * unit};
  const Stroke bar{style::kInk, 5 * unit, {}, Cap::butt}, ends{style::kInk, 3 * unit, {}, Cap::butt};
  add_line(drawing, left, right, bar);
  add_line(drawing, left - end, left + end, ends);
  add_line(drawing, right - end, right + end, ends);
  drawing.shapes.push_back(Text{right + unit * Vec2{16, 10}, fmt::format("{:g} mm", length), style::kLabelSize * unit,
                                Anchor::left, Weight::regular, Direction::across, style::kInk});
}

}  // namespace asperity::render
