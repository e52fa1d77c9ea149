#include "core/output/manifest.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/geometry/mesh.hpp"
#include "tests/unit/output/scratch.hpp"

using namespace asperity;
using asperity::testing::fresh_folder;

namespace {

Manifest example() {
  Manifest m = started_manifest();
  m.libraries = {{"VTK", "9.1.0"}, {"CGAL", "5.5"}};
  m.threads = 2;
  m.seed = std::numeric_limits<std::uint64_t>::max();
  m.config_name = "quickstart";
  m.config_hash = "ab12";
  m.time_step_s = 1.25e-7;
  m.timings_s = {{"mesh_s", 0.5}, {"compute_s", 12.25}};
  m.mesh = {{"triangles", 1234}, {"angle_min_deg", 25.5}};
  m.warnings = {"a stage ended by its time limit"};
  return m;
}

}  // namespace

TEST_CASE("a manifest reads back as it was written") {
  const auto path = fresh_folder("manifest") / "manifest.json";
  Manifest m = example();
  end_manifest(m, Outcome::interrupted, "SIGINT");
  write_manifest(path, m);
  const Manifest back = read_manifest(path);
  CHECK(back.build.version == m.build.version);
  CHECK(back.build.revision == m.build.revision);
  CHECK(back.build.dirty == m.build.dirty);
  CHECK(back.build.compiler == m.build.compiler);
  CHECK(back.build.flags == m.build.flags);
  CHECK(back.build.build_type == m.build.build_type);
  CHECK(back.executable_sha256 == m.executable_sha256);
  CHECK(back.libraries == m.libraries);
  CHECK(back.host.cpu_model == m.host.cpu_model);
  CHECK(back.host.cores == m.host.cores);
  CHECK(back.threads == m.threads);
  CHECK(back.seed == m.seed);
  CHECK(back.config_name == m.config_name);
  CHECK(back.config_hash == m.config_hash);
  CHECK(back.started_utc == m.started_utc);
  CHECK(back.ended_utc == m.ended_utc);
  CHECK(back.time_step_s == m.time_step_s);
  CHECK(back.timings_s == m.timings_s);
  CHECK(back.mesh == m.mesh);
  CHECK(back.warnings == m.warnings);
  CHECK(back.outcome == Outcome::interrupted);
  CHECK(back.exit_reason == "SIGINT");
}

TEST_CASE("a manifest starts as running, with its start in UTC and no end") {
  const Manifest m = started_manifest();
  CHECK(m.outcome == Outcome::running);
  CHECK(std::regex_match(m.started_utc, std::regex("\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ")));
  CHECK(m.ended_utc.empty());
  CHECK(m.executable_sha256.size() == (m.build.dirty || m.build.revision == "unknown" ? 64 : 0));
}

TEST_CASE("counts print as integers and NaN as null") {
  const auto path = fresh_folder("manifest_numbers") / "manifest.json";
  Manifest m = example();
  m.mesh["edge_mean_mm"] = std::nan("");
  write_manifest(path, m);
  const auto json = nlohmann::json::parse(read_file(path));
  CHECK(json["mesh"]["triangles"].is_number_integer());
  CHECK(json["mesh"]["edge_mean_mm"].is_null());
  CHECK(json["outcome"] == "running");
  CHECK(std::isnan(read_manifest(path).mesh.at("edge_mean_mm")));
}

TEST_CASE("bytes that are no UTF-8 in a warning do not stop the manifest") {
  const auto path = fresh_folder("manifest_utf8") / "manifest.json";
  Manifest m = example();
  m.warnings = {"unknown key \xff"};
  write_manifest(path, m);
  CHECK_THAT(read_manifest(path).warnings.at(0), Catch::StartsWith("unknown key "));
}

TEST_CASE("another program's manifest is not taken for ours") {
  const auto folder = fresh_folder("manifest_other");
  for (const std::string text : {"{\"name\": \"web app\"}", "[1]", "{\"program\": \"asperity\"}", "not json"}) {
    write_file_atomically(folder / "manifest.json", text);
    CHECK_THROWS_WITH(read_manifest(folder / "manifest.json"), Catch::Contains("is no manifest of Asperity"));
    CHECK_FALSE(find_manifest(folder / "manifest.json"));
  }
  CHECK_FALSE(find_manifest(folder / "none.json"));
}

TEST_CASE("mesh quality is recorded by name and unit") {
  MeshQuality quality;
  quality.triangles = 12;
  quality.edge_mean_mm = 2.01;
  const auto entries = mesh_quality_entries(quality);
  CHECK(entries.at("triangles") == 12);
  CHECK(entries.at("edge_mean_mm") == 2.01);
  CHECK(entries.size() == 10);
}

TEST_CASE("a manifest whose counts are none is not taken for ours") {
  const auto path = fresh_folder("manifest_counts") / "manifest.json";
  write_manifest(path, example());
  const auto whole = nlohmann::json::parse(read_file(path));
  const auto changed = [&](const std::string& pointer, const nlohmann::json& value) {
    nlohmann::json json = whole;
    json[nlohmann::json::json_pointer(pointer)] = value;
    return json.dump();
  };
  CHECK(parse_manifest(whole.dump(), path).threads == 2);
  for (const nlohmann::json& value : {nlohmann::json(0), nlohmann::json(-1), nlohmann::json(1e300), nlohmann::json(1.5),
                                      nlohmann::json(true), nlohmann::json(std::uint64_t{1} << 40)}) {
    CHECK_THROWS_WITH(parse_manifest(changed("/threads", value), path), Catch::Contains("is no manifest of Asperity"));
  }
  CHECK_THROWS_AS(parse_manifest(changed("/seed", -1), path), Error);
  CHECK_THROWS_AS(parse_manifest(changed("/host/cores", 1e300), path), Error);
}
