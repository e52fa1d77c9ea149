#include "core/config/enum_words.hpp"
#include "core/config/mechanism_declaration.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/config/schema_reference.hpp"

namespace asperity {

namespace {

std::string experiments_of(const MechanismDeclaration& m) {
  std::string text;
  for (const ExperimentType type : m.acts_in) text += (text.empty() ? "" : ", ") + std::string(word(type));
  return text;
}

/// What it needs beside an experiment in which it acts.
std::string needs_of(const MechanismDeclaration& m) {
  std::string text;
  const auto add = [&](bool needed, const std::string& what) {
    if (needed) text += (text.empty() ? "" : ", ") + what;
  };
  add(m.default_law_only, "the default law in its first form");
  add(m.needs_general_contact, "general contact");
  add(m.needs_breakable_particles, "breakable particles");
  add(!m.allows_elastic_start, "no elastic start");
  return text;
}

std::string off_value(const MechanismParameter& p) {
  if (p.reciprocal) return "infinite";
  return p.neutral ? number_text(*p.neutral) : "the same";
}

std::string parameter_row(const MechanismParameter& p) {
  return "| `/mechanisms/N/" + p.key + "` | " + (p.whole ? "whole number" : "number") + " | " +
         (p.unit == "1" ? "" : p.unit) + " | " + number_text(p.lowest) + " to " + number_text(p.highest) + " | " +
         off_value(p) + " | " + number_text(p.strong) + " | " + table_cell(p.description) + " |\n";
}

std::string ended(const std::string& text) { return text.empty() || text.back() == '.' ? text : text + "."; }

std::string mechanism_section(const MechanismDeclaration& m) {
  const std::string needs = needs_of(m);
  std::string text = "\n### `" + m.id + "`\n\n" + ended(m.title) +
                     (m.suspect ? " A setting of the solver or of the idealisation, no rock." : "") +
                     "\n\n* Acts in: " + experiments_of(m) + (needs.empty() ? "" : ". Needs: " + needs) +
                     "\n* Equation: " + m.equation + "\n* Source: " + m.source + "\n* Expected: " + m.expectation +
                     "\n* Why the strong values: " + m.reason + "\n\n";
  if (m.parameters.empty()) return text + "It has no parameter.\n";
  text += "| key | type | unit | allowed | at amplitude 0 | at amplitude 1 (strong) | meaning |\n";
  text += "|---|---|---|---|---|---|---|\n";
  for (const MechanismParameter& p : m.parameters) text += parameter_row(p);
  return text;
}

}  // namespace

std::string mechanisms_reference() {
  std::string text;
  for (const MechanismDeclaration& m : declared_mechanisms()) text += mechanism_section(m);
  return text;
}

}  // namespace asperity
