#include "core/output/summary.hpp"

#include <array>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/output/shallow_json.hpp"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::array kSections{"experiment", "results", "energy", "cracks", "contacts", "cost"};

}  // namespace

void write_summary(const std::filesystem::path& path, const Summary& summary) {
  const Json json = {{"experiment", summary.experiment}, {"results", summary.results},   {"energy", summary.energy},
                     {"cracks", summary.cracks},         {"contacts", summary.contacts}, {"cost", summary.cost},
                     {"warnings", summary.warnings}};
  write_file_atomically(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

Summary read_summary(const std::filesystem::path& path) { return parse_summary(read_file(path), path); }

Summary parse_summary(std::string_view text, const std::filesystem::path& name) {
  try {
    const Json json = parse_shallow_json(text, name);
    for (const char* section : kSections) {
      if (!json.at(section).is_object())
        throw Error(ErrorKind::output,
                    {{name.string(), std::string("is no summary: \"") + section + "\" is no object", "", "", ""}});
    }
    return {json.at("experiment"), json.at("results"), json.at("energy"),  json.at("cracks"),
            json.at("contacts"),   json.at("cost"),    json.at("warnings")};
  } catch (const nlohmann::json::exception& failure) {
    throw Error(ErrorKind::output, {{name.string(), std::string("is no summary: ") + failure.what(), "", "", ""}});
  }
}

}  // namespace asperity
