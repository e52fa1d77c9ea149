#include "core/output/summary.hpp"

#include "core/base/error.hpp"
#include "core/output/atomic_file.hpp"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

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
    const Json json = Json::parse(text);
    return {json.at("experiment"), json.at("results"), json.at("energy"),  json.at("cracks"),
            json.at("contacts"),   json.at("cost"),    json.at("warnings")};
  } catch (const nlohmann::json::exception& failure) {
    throw Error(ErrorKind::output, {{name.string(), std::string("is no summary: ") + failure.what(), "", "", ""}});
  }
}

}  // namespace asperity
