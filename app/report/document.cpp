#include "app/report/document.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/output/shallow_json.hpp"

namespace asperity::app {

using Json = nlohmann::ordered_json;

namespace {

Json parsed(const std::filesystem::path& path) try {
  return parse_shallow_json(read_file(path), path);
} catch (const Json::parse_error& fault) {
  throw Error(ErrorKind::config, {{path.string(), "is no JSON", "", "", fault.what()}});
}

std::string shown(const Json& json) {
  constexpr std::size_t kMost = 60;
  const std::string text = json.dump();
  return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
}

}  // namespace

Document::Document(const std::filesystem::path& path) : path_(path.string()), json_(parsed(path)) {
  if (!json_.is_object()) throw Error(ErrorKind::config, {{path_, "is no JSON object", shown(json_), "", ""}});
}

void Value::refuse(const char* expected) const {
  throw Error(ErrorKind::config, {{where_, "has another type than a report reads", shown(*json_), expected, ""}});
}

Value Value::operator[](const std::string& key) const {
  const std::string where = where_ + "/" + key;
  if (!exists()) return {nullptr, where};
  if (!json_->is_object()) refuse("an object");
  const auto found = json_->find(key);
  return {found == json_->end() ? nullptr : &*found, where};
}

double Value::number() const {
  if (!exists()) return NAN;
  if (!json_->is_number()) refuse("a number or null");
  return json_->get<double>();
}

int Value::count() const {
  if (!exists()) return 0;
  const double value = number();
  if (std::floor(value) != value || std::abs(value) > 1e9) refuse("a whole number or null");
  return static_cast<int>(value);
}

bool Value::truth() const {
  if (!exists()) return false;
  if (!json_->is_boolean()) refuse("true, false or null");
  return json_->get<bool>();
}

std::string Value::text() const {
  if (!exists()) return "";
  if (!json_->is_string()) refuse("a text or null");
  return json_->get<std::string>();
}

std::vector<double> Value::numbers() const {
  std::vector<double> values;
  for (const Value& item : items()) values.push_back(item.number());
  return values;
}

std::vector<Value> Value::items() const {
  std::vector<Value> values;
  if (!exists()) return values;
  if (!json_->is_array()) refuse("a list or null");
  for (std::size_t i = 0; i < json_->size(); ++i) values.emplace_back(&(*json_)[i], where_ + "/" + std::to_string(i));
  return values;
}

std::vector<std::pair<std::string, Value>> Value::entries() const {
  std::vector<std::pair<std::string, Value>> values;
  if (!exists()) return values;
  if (!json_->is_object()) refuse("an object or null");
  for (const auto& [key, value] : json_->items()) values.emplace_back(key, Value(&value, where_ + "/" + key));
  return values;
}

std::string Value::words() const {
  if (!exists()) return "–";
  if (json_->is_boolean()) return json_->get<bool>() ? "yes" : "no";
  if (json_->is_number_integer()) return json_->dump();
  if (json_->is_number()) return fmt::format("{:.4g}", json_->get<double>());
  if (json_->is_string()) return json_->get<std::string>();
  std::string all;
  if (json_->is_array())
    for (const Value& item : items()) all += (all.empty() ? "" : ", ") + item.words();
  else
    for (const auto& [key, value] : entries()) all += (all.empty() ? "" : ", ") + key + " " + value.words();
  return all;
}

}  // namespace asperity::app
