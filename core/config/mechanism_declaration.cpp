#include "core/config/mechanism_declaration.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

/// By id: a map keeps the order and its entries' addresses.
std::map<std::string, MechanismDeclaration, std::less<>>& registry() {
  static std::map<std::string, MechanismDeclaration, std::less<>> all;
  return all;
}

double value_at(const MechanismParameter& p, double amplitude) {
  if (p.reciprocal) return amplitude > 0.0 ? p.strong / amplitude : ModelExtensions::kNone;
  if (!p.neutral) return p.strong;
  const double value = *p.neutral + amplitude * (p.strong - *p.neutral);
  return p.whole ? std::round(value) : value;
}

}  // namespace

void declare_mechanism(const MechanismDeclaration& declaration) { registry()[declaration.id] = declaration; }

std::vector<MechanismDeclaration> declared_mechanisms() {
  std::vector<MechanismDeclaration> all;
  for (const auto& [id, declaration] : registry()) all.push_back(declaration);
  return all;
}

const MechanismDeclaration* find_mechanism(std::string_view id) {
  const auto found = registry().find(id);
  return found == registry().end() ? nullptr : &found->second;
}

bool acts_in(const MechanismDeclaration& declaration, ExperimentType type) {
  return std::find(declaration.acts_in.begin(), declaration.acts_in.end(), type) != declaration.acts_in.end();
}

std::map<std::string, double> mechanism_values(const MechanismDeclaration& declaration, const MechanismConfig& config) {
  std::map<std::string, double> values;
  for (const MechanismParameter& p : declaration.parameters) {
    const auto given = config.parameters.find(p.key);
    values[p.key] = given != config.parameters.end() ? given->second : value_at(p, config.amplitude.value_or(1.0));
  }
  return values;
}

bool is_off(const MechanismConfig& config) { return config.amplitude == 0.0 && config.parameters.empty(); }

}  // namespace asperity
