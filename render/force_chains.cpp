#include "render/force_chains.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "render/style.hpp"

namespace asperity::render {
namespace {

constexpr double kWidestOverSpacing = 0.6;
constexpr double kWidestLeast = 3, kWidestMost = 12, kNarrowest = 0.5;  // pixels of the standard picture

/// Side of a square as large as a particle before loading, mm.
double particle_spacing(const Frame& frame) {
  const auto before = [&](int node) {
    const auto i = static_cast<std::size_t>(node);
    return frame.position[i] - frame.displacement[i];
  };
  double area = 0;
  for (const auto& [a, b, c] : frame.triangles)
    area += 0.5 * std::abs(cross(before(b) - before(a), before(c) - before(a)));
  const std::size_t particles = std::set<int>(frame.grain.begin(), frame.grain.end()).size();
  return particles > 0 ? std::sqrt(area / static_cast<double>(particles)) : 0;
}

Colour colour_of(ForceClass kind) {
  switch (kind) {
    case ForceClass::compression:
      return style::kCompressiveForce;
    case ForceClass::tension:
      return style::kTensileForce;
    case ForceClass::broken:
      return style::kBrokenForce;
    case ForceClass::general:
      return style::kGeneralForce;
  }
  return style::kInk;
}

std::vector<const ContactForce*> weakest_first(const Frame& frame, ForceClass wanted) {
  std::vector<const ContactForce*> contacts;
  for (const ContactForce& contact : frame.contacts)
    if (force_class(contact) == wanted) contacts.push_back(&contact);
  std::stable_sort(contacts.begin(), contacts.end(), [](const ContactForce* a, const ContactForce* b) {
    return std::abs(a->normal_n) < std::abs(b->normal_n);
  });
  return contacts;
}

}  // namespace

ForceClass force_class(const ContactForce& contact) {
  if (contact.kind == ContactKind::general) return ForceClass::general;
  if (contact.kind == ContactKind::broken) return ForceClass::broken;
  return contact.normal_n < 0 ? ForceClass::tension : ForceClass::compression;
}

double ForceScale::width(double normal_n) const {
  if (!(largest_n > 0)) return narrowest;
  return std::clamp(widest * std::abs(normal_n) / largest_n, narrowest, widest);
}

ForceScale force_scale(const Frame& frame, const PictureOptions& options, const View& view, double unit) {
  const Range range = options.value_range ? *options.value_range : *frame_range(frame, Field::contacts);
  const double spacing = particle_spacing(frame) * view.pixels_per_mm;
  return {range.high, std::clamp(kWidestOverSpacing * spacing, kWidestLeast * unit, kWidestMost * unit),
          kNarrowest * unit};
}

void draw_force(Drawing& drawing, ForceClass kind, Vec2 a, Vec2 b, double width) {
  add_line(drawing, a, b, {colour_of(kind), width, {}, Cap::round});
}

void draw_force_chains(Drawing& drawing, const Frame& frame, const View& view, const ForceScale& scale) {
  for (const ForceClass kind : kForceClasses)
    for (const ContactForce* contact : weakest_first(frame, kind)) {
      const Vec2 a = view.place(contact->a), b = view.place(contact->b);
      if (view.shows(a) && view.shows(b)) draw_force(drawing, kind, a, b, scale.width(contact->normal_n));
    }
}

}  // namespace asperity::render
