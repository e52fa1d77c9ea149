#include "core/output/manifest.hpp"

#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/geometry/mesh.hpp"
#include "core/output/run_identity.hpp"
#include "core/output/shallow_json.hpp"

namespace asperity {

// The first entry also stands for a word that is none of them.
NLOHMANN_JSON_SERIALIZE_ENUM(Outcome, {{Outcome::failed, "failed"},
                                       {Outcome::running, "running"},
                                       {Outcome::finished, "finished"},
                                       {Outcome::interrupted, "interrupted"}})

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kProgram = "asperity";
constexpr int kFormat = 1;

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

/// Counts print as integers; JSON has no NaN, which becomes null.
Json number_json(double value) {
  const bool whole = std::floor(value) == value && std::abs(value) < 0x1p53;
  return whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json numbers_json(const std::map<std::string, double>& numbers) {
  Json json = Json::object();
  for (const auto& [name, value] : numbers) json[name] = number_json(value);
  return json;
}

double number_of(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::map<std::string, double> numbers_of(const Json& json) {
  std::map<std::string, double> numbers;
  for (const auto& [name, value] : json.items()) numbers[name] = number_of(value);
  return numbers;
}

Json to_json(const Manifest& m) {
  return {{"program", kProgram},
          {"format", kFormat},
          {"version", m.build.version},
          {"revision", m.build.revision},
          {"dirty", m.build.dirty},
          {"executable_sha256", m.executable_sha256},
          {"compiler", m.build.compiler},
          {"flags", m.build.flags},
          {"build_type", m.build.build_type},
          {"libraries", m.libraries},
          {"host", {{"cpu_model", m.host.cpu_model}, {"cores", m.host.cores}}},
          {"threads", m.threads},
          {"seed", m.seed},
          {"config_name", m.config_name},
          {"config_hash", m.config_hash},
          {"started_utc", m.started_utc},
          {"ended_utc", m.ended_utc},
          {"time_step_s", m.time_step_s},
          {"timings", numbers_json(m.timings_s)},
          {"mesh", numbers_json(m.mesh)},
          {"warnings", m.warnings},
          {"outcome", m.outcome},
          {"exit_reason", m.exit_reason}};
}

BuildInfo build_of(const Json& json) {
  return {json.at("version"),  json.at("revision"), json.at("dirty"),
          json.at("compiler"), json.at("flags"),    json.at("build_type")};
}

/// Whether it is a whole number in this range; a conversion would take any number for one.
bool is_count(const Json& json, std::uint64_t least, std::uint64_t most) {
  return json.is_number_unsigned() && json.get<std::uint64_t>() >= least && json.get<std::uint64_t>() <= most;
}

bool counts_hold(const Json& json) {
  return is_count(json.at("threads"), 1, std::numeric_limits<int>::max()) &&
         is_count(json.at("seed"), 0, std::numeric_limits<std::uint64_t>::max()) &&
         is_count(json.at("host").at("cores"), 0, std::numeric_limits<unsigned>::max());
}

Manifest from_json(const Json& json) {
  Manifest m;
  m.build = build_of(json);
  json.at("executable_sha256").get_to(m.executable_sha256);
  json.at("libraries").get_to(m.libraries);
  m.host = {json.at("host").at("cpu_model"), json.at("host").at("cores")};
  json.at("threads").get_to(m.threads);
  json.at("seed").get_to(m.seed);
  json.at("config_name").get_to(m.config_name);
  json.at("config_hash").get_to(m.config_hash);
  json.at("started_utc").get_to(m.started_utc);
  json.at("ended_utc").get_to(m.ended_utc);
  m.time_step_s = number_of(json.at("time_step_s"));
  m.timings_s = numbers_of(json.at("timings"));
  m.mesh = numbers_of(json.at("mesh"));
  json.at("warnings").get_to(m.warnings);
  json.at("outcome").get_to(m.outcome);
  json.at("exit_reason").get_to(m.exit_reason);
  return m;
}

}  // namespace

Manifest started_manifest() {
  Manifest manifest;
  manifest.build = build_info();
  manifest.executable_sha256 = this_executable_sha256_if_unnamed();
  manifest.host = {cpu_model(), std::thread::hardware_concurrency()};
  manifest.started_utc = utc_now();
  return manifest;
}

void end_manifest(Manifest& manifest, Outcome outcome, const std::string& exit_reason) {
  manifest.outcome = outcome;
  manifest.exit_reason = exit_reason;
  manifest.ended_utc = utc_now();
}

std::map<std::string, double> mesh_quality_entries(const MeshQuality& quality) {
  return {{"triangles", quality.triangles},
          {"vertices", quality.vertices},
          {"grains", quality.grains},
          {"edge_mean_mm", quality.edge_mean_mm},
          {"edge_deviation_mm", quality.edge_deviation_mm},
          {"edge_min_mm", quality.edge_min_mm},
          {"edge_max_mm", quality.edge_max_mm},
          {"angle_min_deg", quality.angle_min_deg},
          {"area_mm2", quality.area_mm2},
          {"outline_area_mm2", quality.outline_area_mm2}};
}

void write_manifest(const std::filesystem::path& path, const Manifest& manifest) {
  // Warnings may quote bytes of a user's file that are not UTF-8: replaced, not thrown.
  write_file_atomically(path, to_json(manifest).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

Manifest read_manifest(const std::filesystem::path& path) { return parse_manifest(read_file(path), path); }

Manifest parse_manifest(std::string_view text, const std::filesystem::path& name) {
  try {
    const Json json = parse_shallow_json(text, name);
    if (json.value("program", "") == kProgram && counts_hold(json)) return from_json(json);
  } catch (const nlohmann::json::exception&) {
    // Told below like a manifest of another program.
  }
  throw Error(ErrorKind::output, {{name.string(), "is no manifest of Asperity", "", "", ""}});
}

std::optional<Manifest> find_manifest(const std::filesystem::path& path) {
  try {
    return read_manifest(path);
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[sizeof "2024-05-01T12:34:56Z"];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

}  // namespace asperity
