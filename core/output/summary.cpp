#include "core/output/summary.hpp"

#include <array>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/output/shallow_json.hpp"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::array kSections{"experiment", "results", "energy", "cracks", "contacts", "cost"};

void require_object(const Json& section, const char* name, const std::filesystem::path& file) {
  if (section.is_object()) return;
  throw Error(ErrorKind::output,
              {{file.string(), std::string("is no summary: \"") + name + "\" is no object", "", "", ""}});
}

}  // namespace

void write_summary(const std::filesystem::path& path, const Summary& summary) {
  const Json json = {{"experiment", summary.experiment},
                     {"results", summary.results},
                     {"energy", summary.energy},
                     {"cracks", summary.cracks},
                     {"failure_mode", summary.failure_mode},
                     {"contacts", summary.contacts},
                     {"cost", summary.cost},
                     {"warnings", summary.warnings}};
  write_file_atomically(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

Summary read_summary(const std::filesystem::path& path) { return parse_summary(read_file(path), path); }

Summary parse_summary(std::string_view text, const std::filesystem::path& name) {
  try {
    const Json json = parse_shallow_json(text, name);
    for (const char* section : kSections) require_object(json.at(section), section, name);
    const Json failure_mode = json.value("failure_mode", Json::object());
    require_object(failure_mode, "failure_mode", name);
    return {json.at("experiment"), json.at("results"),  json.at("energy"), json.at("cracks"),
            failure_mode,          json.at("contacts"), json.at("cost"),   json.at("warnings")};
  } catch (const nlohmann::json::exception& failure) {
    throw Error(ErrorKind::output, {{name.string(), std::string("is no summary: ") + failure.what(), "", "", ""}});
  }
}

}  // namespace asperity
