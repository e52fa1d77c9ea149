#include "app/report/mechanism_words.hpp"

#include "core/config/mechanism_declaration.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity::app {
namespace {

std::string words_of_entry(const MechanismConfig& entry) {
  std::string values;
  for (const auto& [key, value] : mechanism_values(*find_mechanism(entry.type), entry)) {
    values += (values.empty() ? "" : ", ") + key + " " + number_text(value);
  }
  return entry.type + " (" + values + ")";
}

}  // namespace

std::string mechanism_words(const RunConfig& config) {
  std::string words;
  for (const MechanismConfig& entry : config.mechanisms) {
    if (!is_off(entry)) words += (words.empty() ? "" : "; ") + words_of_entry(entry);
  }
  return words;
}

}  // namespace asperity::app
