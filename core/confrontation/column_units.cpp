#include "core/confrontation/column_units.hpp"

namespace asperity {
namespace {

constexpr double kMpaPerPsi = 0.00689475729;  // pound-force per square inch, NIST SP 811
constexpr double kMmPerInch = 25.4;

constexpr UnitSuffix kStrain[] = {{"", 1.0},           {"_percent", 1e-2},     {"_permille", 1e-3},
                                  {"_mm_per_m", 1e-3}, {"_microstrain", 1e-6}, {"_um_per_m", 1e-6}};
constexpr UnitSuffix kStress[] = {{"_mpa", 1.0},        {"_kpa", 1e-3},       {"_pa", 1e-6},
                                  {"_gpa", 1e3},        {"_bar", 0.1},        {"_n_per_mm2", 1.0},
                                  {"_kn_per_m2", 1e-3}, {"_psi", kMpaPerPsi}, {"_ksi", 1e3 * kMpaPerPsi}};
constexpr UnitSuffix kModulus[] = {{"_gpa", 1.0}, {"_mpa", 1e-3}, {"_kpa", 1e-6}, {"_ksi", kMpaPerPsi}};
constexpr UnitSuffix kLength[] = {{"_mm", 1.0}, {"_um", 1e-3}, {"_cm", 10.0}, {"_m", 1e3}, {"_in", kMmPerInch}};
constexpr UnitSuffix kLineLoad[] = {{"_n_per_mm", 1.0}, {"_kn_per_m", 1.0}, {"_kn_per_mm", 1e3}, {"_n_per_m", 1e-3}};
constexpr UnitSuffix kForce[] = {{"_n", 1.0}, {"_kn", 1e3}, {"_mn", 1e6}};
constexpr UnitSuffix kPure[] = {{"", 1.0}};

}  // namespace

QuantityLimit limit_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::strain:
      return {"a strain", 0.5, ""};  // beyond it a percentage under the wrong name
    case Quantity::stress:
      return {"a stress", 1e6, "MPa"};
    case Quantity::modulus:
      return {"a modulus", 1e4, "GPa"};
    case Quantity::length:
      return {"a length", 1e6, "mm"};
    case Quantity::line_load:
      return {"a load over thickness", 1e7, "N/mm"};
    case Quantity::force:
      return {"a force", 1e12, "N"};
    case Quantity::count:
      return {"a count", 1e12, ""};
    case Quantity::ratio:
      break;
  }
  return {"such a number", 1e6, ""};
}

std::span<const UnitSuffix> unit_suffixes(Quantity quantity) {
  switch (quantity) {
    case Quantity::strain:
      return kStrain;
    case Quantity::stress:
      return kStress;
    case Quantity::modulus:
      return kModulus;
    case Quantity::length:
      return kLength;
    case Quantity::line_load:
      return kLineLoad;
    case Quantity::force:
      return kForce;
    case Quantity::count:
    case Quantity::ratio:
      break;
  }
  return kPure;
}

std::optional<double> unit_factor(std::string_view name, std::string_view base, Quantity quantity) {
  if (!name.starts_with(base)) return std::nullopt;
  for (const UnitSuffix& unit : unit_suffixes(quantity)) {
    if (name.substr(base.size()) == unit.suffix) return unit.factor;
  }
  return std::nullopt;
}

std::string names_with_units(std::string_view base, Quantity quantity) {
  std::string names;
  for (const UnitSuffix& unit : unit_suffixes(quantity)) {
    names += (names.empty() ? "" : ", ") + std::string(base) + std::string(unit.suffix);
  }
  return names;
}

}  // namespace asperity
