#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.hpp"

namespace asperity {

/// One object of a config, read key by key; what is missing or of the wrong type is noted and read as nothing.
class Section {
 public:
  /// `json` may be null where the section is not there.
  Section(const nlohmann::ordered_json* json, std::string pointer, std::vector<Fault>& faults)
      : json_(json), pointer_(std::move(pointer)), faults_(&faults) {}

  bool has(const std::string& key) const { return find(key) != nullptr; }
  const std::string& pointer() const { return pointer_; }
  Section section(const std::string& key) const;

  double number(const std::string& key, std::optional<double> otherwise = {}) const;
  std::string text(const std::string& key, std::optional<std::string> otherwise = {}) const;
  bool flag(const std::string& key, bool otherwise) const;
  std::size_t count(const std::string& key, std::size_t otherwise) const;

  /// Place of the word among those allowed; 0, the default, where the key is missing.
  std::size_t choice(const std::string& key, const std::vector<std::string>& words) const;
  std::vector<std::string> texts(const std::string& key) const;
  std::vector<double> numbers(const std::string& key) const;

  /// Calls visit(key, element section) for each member of an object, or each element of an array (key: its index).
  template <class Visit>
  void for_each(const Visit& visit) const {
    if (!json_) return;
    std::size_t i = 0;
    for (const auto& [key, value] : json_->items()) {
      const std::string name = json_->is_array() ? std::to_string(i++) : key;
      visit(name, Section(&value, pointer_ + "/" + name, *faults_));
    }
  }

  const nlohmann::ordered_json* json() const { return json_; }
  void fault(const std::string& key, const std::string& what, const std::string& allowed) const;

 private:
  const nlohmann::ordered_json* find(const std::string& key) const;
  const nlohmann::ordered_json* expect(const std::string& key, bool required) const;
  const nlohmann::ordered_json* json_;
  std::string pointer_;
  std::vector<Fault>* faults_;
};

}  // namespace asperity
