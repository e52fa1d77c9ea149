#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace asperity::app {

/// A place in a JSON document that a report reads. What is absent and what is null are the same: a number is then NaN,
/// a text empty, a list without items. A value of another type than asked for: Error(config) with file and pointer.
class Value {
 public:
  Value(const nlohmann::ordered_json* json, std::string where) : json_(json), where_(std::move(where)) {}

  Value operator[](const std::string& key) const;
  bool exists() const { return json_ && !json_->is_null(); }
  bool is_number() const { return exists() && json_->is_number(); }
  bool is_list() const { return exists() && json_->is_array(); }
  bool is_object() const { return exists() && json_->is_object(); }

  double number() const;
  int count() const;  ///< 0 where absent.
  bool truth() const;
  std::string text() const;

  std::vector<double> numbers() const;  ///< null: NaN.
  std::vector<Value> items() const;
  std::vector<std::pair<std::string, Value>> entries() const;

  /// Any value as one reads it: a number in four digits, yes or no, a text, a list with commas.
  std::string words() const;

 private:
  [[noreturn]] void refuse(const char* expected) const;
  const nlohmann::ordered_json* json_;
  std::string where_;
};

/// A JSON file and its root. Throws Error(config) where it is missing, no JSON, or no object.
class Document {
 public:
  explicit Document(const std::filesystem::path& path);
  Value root() const { return {&json_, path_ + ": "}; }

 private:
  std::string path_;
  nlohmann::ordered_json json_;
};

}  // namespace asperity::app
