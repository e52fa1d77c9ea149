#pragma once
#include <string>

#include "core/output/html.hpp"

namespace asperity::app {

/// What a key stands for. An index in a symbol follows "_" ("σ_t"); a quantity without unit has "–".
struct Quantity {
  std::string name, symbol, unit;
};

/// A property or measure by its key: "tensile_strength_mpa" is "tensile strength", σ_t, MPa. Of an unknown key the
/// words are the name and its ending is the unit.
Quantity quantity_of(const std::string& key);

/// A microparameter by its JSON pointer: name and unit from the pointer's last key.
Quantity quantity_of_pointer(const std::string& pointer);

/// "tensile strength σ_{t} [MPa]" for a picture's axis.
std::string axis_label(const Quantity& quantity);

/// "σ_{t} [MPa]", or the name where there is no symbol.
std::string short_axis_label(const Quantity& quantity);

/// The text with every index after a single letter in braces, "k_s/k_t" as "k_{s}/k_{t}"; "tensile_strength" stays.
std::string marked_indices(const std::string& text);

/// The same for a page, its indices lowered.
html::Markup page_text(const std::string& text);

/// Symbol with lowered index for a picture; the name where there is no symbol.
std::string picture_symbol(const Quantity& quantity);

/// Name and symbol for a page: "tensile strength σ<sub>t</sub>".
html::Markup name_and_symbol(const Quantity& quantity);

/// The symbol for a page, or the name.
html::Markup page_symbol(const Quantity& quantity);

/// The text with its first letter, if it is a Latin one, as a capital.
std::string capitalised(std::string text);

}  // namespace asperity::app
