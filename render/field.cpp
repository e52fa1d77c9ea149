#include "render/field.hpp"

#include <algorithm>
#include <cmath>

#include "render/vtu.hpp"

namespace asperity::render {
namespace {

constexpr double kPercentile = 0.99;
constexpr double kFaintFrame = 0.02;  // of the run's forces

double displacement_of(const Frame& frame, std::size_t triangle) {
  Vec2 sum;
  for (const int node : frame.triangles[triangle]) sum += frame.displacement[static_cast<std::size_t>(node)];
  return norm(sum) / 3;
}

double value_at(const Frame& frame, Field field, std::size_t i) {
  switch (field) {
    case Field::damage:
      return frame.damage[i];
    case Field::stress:
      return principal_stress(frame.stress[i]).major;
    case Field::compressive_stress:
      return -principal_stress(frame.stress[i]).minor;
    case Field::shear_stress:
      return principal_stress(frame.stress[i]).max_shear();
    case Field::displacement:
      return displacement_of(frame, i);
    case Field::cracks:
    case Field::contacts:
    case Field::fragments:
      break;
  }
  return 0;
}

Range force_range(const std::vector<ContactForce>& contacts) {
  std::vector<double> sizes;
  for (const ContactForce& contact : contacts) sizes.push_back(std::abs(contact.normal_n));
  return {0, percentiles(sizes, 0, kPercentile).high};
}

}  // namespace

const std::vector<Field>& all_fields() {
  static const std::vector<Field> fields{Field::cracks,    Field::contacts,           Field::damage,
                                         Field::stress,    Field::compressive_stress, Field::shear_stress,
                                         Field::fragments, Field::displacement};
  return fields;
}

std::string_view field_name(Field field) {
  switch (field) {
    case Field::cracks:
      return "cracks";
    case Field::contacts:
      return "contacts";
    case Field::damage:
      return "damage";
    case Field::stress:
      return "stress";
    case Field::compressive_stress:
      return "compressive_stress";
    case Field::shear_stress:
      return "shear_stress";
    case Field::fragments:
      return "fragments";
    case Field::displacement:
      return "displacement";
  }
  return "";
}

std::optional<Field> field_from_name(std::string_view name) {
  for (const Field field : all_fields())
    if (field_name(field) == name) return field;
  return std::nullopt;
}

std::optional<FieldColours> field_colours(Field field) {
  switch (field) {
    case Field::damage:
      return FieldColours{ColourMap::magma_light_to_dark, "Damage of contacts [–]"};
    case Field::stress:
      return FieldColours{ColourMap::red_blue, "Major principal stress, tension + [MPa]"};
    case Field::compressive_stress:
      return FieldColours{ColourMap::magma_light_to_dark, "Largest compressive stress [MPa]"};
    case Field::shear_stress:
      return FieldColours{ColourMap::viridis, "Maximum shear stress [MPa]"};
    case Field::displacement:
      return FieldColours{ColourMap::cividis, "Displacement [mm]"};
    case Field::cracks:
    case Field::contacts:
    case Field::fragments:
      break;
  }
  return std::nullopt;
}

std::vector<double> field_values(const Frame& frame, Field field) {
  if (!field_colours(field)) return {};
  std::vector<double> values(frame.triangles.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = value_at(frame, field, i);
  return values;
}

Range field_range(Field field, const std::vector<double>& values) {
  if (field == Field::damage || values.empty()) return {0, 1};
  std::vector<double> sizes = values;
  for (double& size : sizes) size = field == Field::stress ? std::abs(size) : std::max(size, 0.0);
  const double high = percentiles(sizes, 0, kPercentile).high;
  if (!(high > 0)) return field == Field::stress ? Range{-1, 1} : Range{0, 1};
  return {field == Field::stress ? -high : 0, high};
}

std::optional<Range> frame_range(const Frame& frame, Field field) {
  if (field == Field::contacts) return force_range(frame.contacts);
  if (!field_colours(field)) return std::nullopt;
  return field_range(field, field_values(frame, field));
}

std::optional<Range> range_in_run(const Frame& frame, Field field, const std::optional<Range>& run) {
  if (field != Field::contacts || !run) return run;
  return Range{0, std::max(force_range(frame.contacts).high, kFaintFrame * run->high)};
}

}  // namespace asperity::render
