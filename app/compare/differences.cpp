#include "app/compare/differences.hpp"

#include <algorithm>
#include <map>

#include "app/report/mechanism_words.hpp"
#include "app/report/quantities.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kKeysInLabel = 3;
constexpr const char* kAbsent = "–";
constexpr const char* kSeed = "/particles/seed";
constexpr const char* kMechanisms = "/mechanisms";

bool is_told(const std::string& pointer) {
  return pointer != "/$schema" && pointer != "/name" && pointer != "/description" && !pointer.starts_with("/output");
}

std::string value_text(const Json& value) {
  if (value.is_number_integer()) return value.dump();
  if (value.is_number()) return number_text(value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// The leaves by pointer; a list is a leaf, since its items have no names.
void add_leaves(const Json& node, const std::string& pointer,
                std::vector<std::pair<std::string, std::string>>& leaves) {
  if (!node.is_object()) {
    leaves.emplace_back(pointer, value_text(node));
    return;
  }
  for (const auto& [key, child] : node.items()) add_leaves(child, child_pointer(pointer, key), leaves);
}

std::vector<std::pair<std::string, std::string>> leaves_of(const ComparedRun& run) {
  Json rest = run.effective;
  rest.erase("mechanisms");
  const std::string mechanisms = mechanism_words(run.config);
  std::vector<std::pair<std::string, std::string>> leaves{{kMechanisms, mechanisms.empty() ? "none" : mechanisms}};
  add_leaves(rest, "", leaves);
  return leaves;
}

/// Where a key stands in a label.
int rank_of(const std::string& pointer) {
  if (pointer == kSeed) return 0;
  return pointer == kMechanisms ? 1 : 2;
}

bool differs(const DifferingKey& key) {
  return std::any_of(key.values.begin(), key.values.end(),
                     [&](const std::string& v) { return v != key.values.front(); });
}

std::string words_of(const DifferingKey& key, std::size_t index) {
  const std::string& value = key.values[index];
  if (key.pointer == kMechanisms) return value == "none" ? "no mechanism" : value;
  const Quantity quantity = quantity_of_pointer(key.pointer);
  const bool bare = quantity.unit.empty() || quantity.unit == "–" || value == kAbsent;
  return quantity.name + " " + value + (bare ? "" : (quantity.unit == "°" ? "" : " ") + quantity.unit);
}

}  // namespace

std::vector<DifferingKey> differing_keys(const std::vector<ComparedRun>& runs) {
  std::vector<DifferingKey> keys;
  std::map<std::string, std::size_t> place;
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (const auto& [pointer, value] : leaves_of(runs[i])) {
      const auto [entry, is_new] = place.try_emplace(pointer, keys.size());
      if (is_new) keys.push_back({pointer, std::vector<std::string>(runs.size(), kAbsent)});
      keys[entry->second].values[i] = value;
    }
  std::erase_if(keys, [](const DifferingKey& key) { return !is_told(key.pointer) || !differs(key); });
  std::stable_sort(keys.begin(), keys.end(), [](const DifferingKey& a, const DifferingKey& b) {
    return rank_of(a.pointer) < rank_of(b.pointer);
  });
  return keys;
}

std::string label_of(const std::vector<DifferingKey>& keys, std::size_t index) {
  if (keys.empty()) return "same configuration";
  std::string label;
  for (std::size_t k = 0; k < std::min(keys.size(), kKeysInLabel); ++k)
    label += (label.empty() ? "" : ", ") + words_of(keys[k], index);
  if (keys.size() > kKeysInLabel) label += ", and " + std::to_string(keys.size() - kKeysInLabel) + " more";
  return label;
}

}  // namespace asperity::app
