#include "app/report/quantities.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <regex>

namespace asperity::app {
namespace {

const std::map<std::string, Quantity>& known() {
  static const std::map<std::string, Quantity> table{
      {"youngs_modulus_gpa", {"Young's modulus", "E", "GPa"}},
      {"poissons_ratio", {"Poisson's ratio", "ν", "–"}},
      {"tensile_strength_mpa", {"tensile strength", "σ_t", "MPa"}},
      {"uniaxial_strength_mpa", {"uniaxial strength", "σ_c", "MPa"}},
      {"cohesion_mpa", {"cohesion", "C", "MPa"}},
      {"friction_angle_deg", {"friction angle", "φ", "°"}},
      {"disc_tension_crack_share", {"tension share, disc", "", "–"}},
      {"mohr_coulomb_residual_mpa", {"Mohr-Coulomb residual", "", "MPa"}}};
  return table;
}

const std::map<std::string, Quantity>& known_pointers() {
  static const std::map<std::string, Quantity> table{
      {"/particles/youngs_modulus_gpa", {"particles' Young's modulus", "E_p", "GPa"}},
      {"/particles/poissons_ratio", {"particles' Poisson's ratio", "ν_p", "–"}},
      {"/contacts/tensile_strength_mpa", {"contact tensile strength", "t_c", "MPa"}},
      {"/contacts/cohesion_mpa", {"contact cohesion", "c_c", "MPa"}},
      {"/contacts/friction_angle_deg", {"contact friction angle", "φ_c", "°"}}};
  return table;
}

struct Ending {
  const char* key;
  const char* unit;
};

/// Longer endings first.
constexpr std::array<Ending, 14> kEndings{{{"_mpa_sqrt_m", "MPa m½"},
                                           {"_mpa_per_mm", "MPa/mm"},
                                           {"_kg_per_m3", "kg/m³"},
                                           {"_mm_per_s", "mm/s"},
                                           {"_n_per_mm", "N/mm"},
                                           {"_percent", "%"},
                                           {"_n_mm", "N mm"},
                                           {"_mpa", "MPa"},
                                           {"_gpa", "GPa"},
                                           {"_deg", "°"},
                                           {"_mm", "mm"},
                                           {"_ms", "ms"},
                                           {"_n", "N"},
                                           {"_s", "s"}}};

/// Any key as words, its ending as unit: "band_angle_deg" is "band angle" in degrees.
Quantity spelled_out(std::string key) {
  std::string unit = "–";
  for (const Ending& ending : kEndings) {
    if (!key.ends_with(ending.key)) continue;
    key.resize(key.size() - std::string_view(ending.key).size());
    unit = ending.unit;
    break;
  }
  std::replace(key.begin(), key.end(), '_', ' ');
  return {key, "", unit};
}

std::string with_unit(const std::string& text, const Quantity& quantity) {
  return quantity.unit.empty() ? text : text + " [" + quantity.unit + "]";
}

}  // namespace

Quantity quantity_of(const std::string& key) {
  const auto found = known().find(key);
  return found == known().end() ? spelled_out(key) : found->second;
}

Quantity quantity_of_pointer(const std::string& pointer) {
  const auto found = known_pointers().find(pointer);
  if (found != known_pointers().end()) return found->second;
  const std::size_t slash = pointer.rfind('/');
  return spelled_out(slash == std::string::npos ? pointer : pointer.substr(slash + 1));
}

std::string marked_indices(const std::string& text) {
  // A letter, Greek ones included, that no word character precedes; then its index.
  static const std::regex index("(^|[^A-Za-z0-9_\\x80-\\xFF])([A-Za-z]|[\\xC2-\\xDF][\\x80-\\xBF])_([A-Za-z0-9]+)");
  return std::regex_replace(text, index, "$1$2_{$3}");
}

html::Markup page_text(const std::string& text) { return html::with_indices(marked_indices(text)); }

std::string picture_symbol(const Quantity& quantity) {
  return quantity.symbol.empty() ? quantity.name : marked_indices(quantity.symbol);
}

std::string axis_label(const Quantity& quantity) {
  if (quantity.symbol.empty()) return with_unit(quantity.name, quantity);
  return with_unit(quantity.name + " " + picture_symbol(quantity), quantity);
}

std::string short_axis_label(const Quantity& quantity) { return with_unit(picture_symbol(quantity), quantity); }

html::Markup page_symbol(const Quantity& quantity) {
  return quantity.symbol.empty() ? html::Markup(quantity.name) : html::with_indices(picture_symbol(quantity));
}

html::Markup name_and_symbol(const Quantity& quantity) {
  if (quantity.symbol.empty()) return quantity.name;
  return html::Markup(quantity.name + " ") + page_symbol(quantity);
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace asperity::app
