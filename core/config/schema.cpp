#include "core/config/schema.hpp"

#include <map>

#include "core/base/error.hpp"

namespace asperity {

namespace {
const std::map<std::string, std::string, std::less<>>& schema_texts() {
  static const std::map<std::string, std::string, std::less<>> texts{
#include "schema_texts.inc"
  };
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
