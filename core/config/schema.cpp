#include "core/config/schema.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "core/base/error.hpp"
#include "core/config/mechanism_declaration.hpp"

namespace asperity {

namespace {

/// The run's schema with the mechanisms that are declared; the file's own where none is.
std::string with_mechanisms(const std::string& text) {
  if (declared_mechanisms().empty()) return text;
  nlohmann::ordered_json schema = nlohmann::ordered_json::parse(text);
  schema["properties"]["mechanisms"] = mechanisms_schema();
  return schema.dump(2) + "\n";
}

const std::map<std::string, std::string, std::less<>>& schema_texts() {
  static const std::map<std::string, std::string, std::less<>> texts = [] {
    std::map<std::string, std::string, std::less<>> made{
#include "schema_texts.inc"
    };
    made.at("run") = with_mechanisms(made.at("run"));
    return made;
  }();
  return texts;
}
}  // namespace

std::vector<std::string> schema_kinds() {
  std::vector<std::string> kinds;
  for (const auto& [kind, text] : schema_texts()) kinds.push_back(kind);
  return kinds;
}

const std::string& schema_text(std::string_view kind) {
  const auto found = schema_texts().find(kind);
  if (found != schema_texts().end()) return found->second;
  std::string allowed;
  for (const std::string& known : schema_kinds()) allowed += (allowed.empty() ? "" : ", ") + known;
  throw Error(ErrorKind::usage, {Fault{"schema", "is of an unknown kind", std::string(kind), allowed, ""}});
}

}  // namespace asperity
