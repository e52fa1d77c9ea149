#include "core/calibration/config_sections.hpp"

#include <algorithm>

namespace asperity {
namespace {

using nlohmann::ordered_json;

std::string quoted_list(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "\"" : ", \"") + word + "\"";
  return list;
}

}  // namespace

const ordered_json* Section::find(const std::string& key) const {
  if (!json_ || !json_->is_object()) return nullptr;
  const auto found = json_->find(key);
  return found == json_->end() ? nullptr : &*found;
}

void Section::fault(const std::string& key, const std::string& what, const std::string& allowed) const {
  const ordered_json* value = key.empty() ? json_ : find(key);
  faults_->push_back(
      {key.empty() ? pointer_ : pointer_ + "/" + key, what, value ? value->dump().substr(0, 60) : "", allowed, ""});
}

const ordered_json* Section::expect(const std::string& key, bool required) const {
  const ordered_json* value = find(key);
  if (!value && required && json_) fault(key, "is missing", "");
  return value;
}

Section Section::section(const std::string& key) const { return {find(key), pointer_ + "/" + key, *faults_}; }

double Section::number(const std::string& key, std::optional<double> otherwise) const {
  const ordered_json* value = expect(key, !otherwise);
  if (!value) return otherwise.value_or(0.0);
  if (value->is_number()) return value->get<double>();
  fault(key, "is no number", "a number");
  return otherwise.value_or(0.0);
}

std::string Section::text(const std::string& key, std::optional<std::string> otherwise) const {
  const ordered_json* value = expect(key, !otherwise);
  if (!value) return otherwise.value_or("");
  if (value->is_string()) return value->get<std::string>();
  fault(key, "is no text", "a text");
  return "";
}

bool Section::flag(const std::string& key, bool otherwise) const {
  const ordered_json* value = find(key);
  if (!value) return otherwise;
  if (value->is_boolean()) return value->get<bool>();
  fault(key, "is neither true nor false", "true or false");
  return otherwise;
}

std::size_t Section::count(const std::string& key, std::size_t otherwise) const {
  const ordered_json* value = find(key);
  if (!value) return otherwise;
  if (value->is_number_unsigned()) return value->get<std::size_t>();
  fault(key, "is no count", "a whole number from 0");
  return otherwise;
}

std::size_t Section::choice(const std::string& key, const std::vector<std::string>& words) const {
  if (!has(key)) return 0;
  const auto found = std::find(words.begin(), words.end(), text(key, ""));
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  fault(key, "is not one of the allowed words", quoted_list(words));
  return 0;
}

std::vector<std::string> Section::texts(const std::string& key) const {
  std::vector<std::string> list;
  section(key).for_each([&](const std::string&, const Section& item) {
    if (item.json()->is_string()) {
      list.push_back(item.json()->get<std::string>());
    } else {
      item.fault("", "is no text", "a text");
    }
  });
  return list;
}

std::vector<double> Section::numbers(const std::string& key) const {
  std::vector<double> list;
  section(key).for_each([&](const std::string&, const Section& item) {
    if (item.json()->is_number()) {
      list.push_back(item.json()->get<double>());
    } else {
      item.fault("", "is no number", "a number");
    }
  });
  return list;
}

}  // namespace asperity
