#include "core/output/summary.hpp"

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"

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

Summary read_summary(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  try {
    const Json json = Json::parse(text);
    return {json.at("experiment"), json.at("results"), json.at("energy"),  json.at("cracks"),
            json.at("contacts"),   json.at("cost"),    json.at("warnings")};
  } catch (const nlohmann::json::exception& failure) {
    throw Error(ErrorKind::output, {{path.string(), std::string("is no summary: ") + failure.what(), "", "", ""}});
  }
}

}  // namespace asperity
