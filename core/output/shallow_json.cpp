#include "core/output/shallow_json.hpp"

#include "core/base/error.hpp"

namespace asperity {

using Json = nlohmann::ordered_json;

Json parse_shallow_json(std::string_view text, const std::filesystem::path& name) {
  constexpr int kDeepest = 64;
  const auto refuse_depths = [&](int depth, Json::parse_event_t, const Json&) {
    if (depth <= kDeepest) return true;
    throw Error(ErrorKind::output, {{name.string(), "has brackets nested too deeply", "", "up to 64 levels", ""}});
  };
  return Json::parse(text, refuse_depths);
}

}  // namespace asperity
