#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace asperity {

/// What a column or a result measures.
enum class Quantity { strain, stress, modulus, length, line_load, force, count, ratio };

/// A quantity in words, and what no measurement of it exceeds in absolute value, in the core's unit.
struct QuantityLimit {
  std::string_view word;  ///< "a stress".
  double largest;
  std::string_view unit;  ///< "MPa"; empty: none.
};

QuantityLimit limit_of(Quantity quantity);

/// A way to write a unit at the end of a name, with the factor to the core's unit.
struct UnitSuffix {
  std::string_view suffix;  ///< "_mpa"; empty: no suffix.
  double factor;
};

/// All ways to write a quantity's unit; the core's own comes first.
std::span<const UnitSuffix> unit_suffixes(Quantity quantity);

/// The factor where `name` is `base` with one of the suffixes; empty otherwise.
std::optional<double> unit_factor(std::string_view name, std::string_view base, Quantity quantity);

/// "axial_stress_mpa, axial_stress_kpa, ...".
std::string names_with_units(std::string_view base, Quantity quantity);

}  // namespace asperity
