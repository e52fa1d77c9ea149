#include "core/campaign/campaign_config.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.hpp"
#include "core/config/read_config.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/config/write_config.hpp"

using namespace asperity;

namespace fs = std::filesystem;

namespace {

const fs::path kFolder = fs::path(ASPERITY_TEST_SCRATCH) / "campaign_config";

/// The campaign file of this text, beside two run configurations, disc.json and block.json.
fs::path written(const std::string& text) {
  fs::create_directories(kFolder);
  std::ofstream(kFolder / "disc.json") << R"({"experiment": {"type": "brazilian"}})";
  std::ofstream(kFolder / "block.json") << R"({"experiment": {"type": "uniaxial"}, "particles": {"edge_mm": 3}})";
  std::ofstream(kFolder / "sweep.json") << text;
  return kFolder / "sweep.json";
}

CampaignConfig read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return read_campaign_config(written(text), overrides);
}

std::vector<std::string> labels(const CampaignConfig& config) {
  std::vector<std::string> list;
  for (const CampaignRun& run : config.runs) list.push_back(run.label);
  return list;
}

/// The one fault that the text has, as the user reads it.
std::string fault(const std::string& text, const std::vector<std::string>& overrides = {},
                  ErrorKind kind = ErrorKind::config) {
  try {
    read(text, overrides);
    return "none";
  } catch (const Error& error) {
    CHECK(error.kind() == kind);
    CHECK(error.faults().size() == 1);
    return error.what();
  }
}

}  // namespace

TEST_CASE("a grid: base first, then what is varied, then the seeds") {
  const CampaignConfig c = read(R"({"base": "block.json", "set": {"/output/frames": 0},
    "vary": [{"pointer": "/particles/edge_mm", "values": [4, 5]}, {"pointer": "/contacts/law/reading", "values": ["literal"]}],
    "seeds": [7, 9]})");
  CHECK(c.name == "sweep");
  CHECK(c.varied == std::vector<std::string>{"/particles/edge_mm", "/contacts/law/reading"});
  CHECK(labels(c) == std::vector<std::string>{"edge_mm=4 reading=literal seed=7", "edge_mm=4 reading=literal seed=9",
                                              "edge_mm=5 reading=literal seed=7", "edge_mm=5 reading=literal seed=9"});
  CHECK(c.runs[3].config.particles.edge_mm == 5);
  CHECK(c.runs[3].config.particles.seed == 9);
  CHECK(c.runs[3].config.contacts.law.reading == LawReading::literal);
  CHECK(c.runs[3].config.output.frames == 0);
  CHECK(c.base_names == std::vector<std::string>(4, "block"));
}

TEST_CASE("several bases, and runs one by one beside them") {
  const CampaignConfig c = read(R"({"base": ["block.json", "disc.json"], "set": {"/particles/edge_mm": 6},
    "runs": [{"label": "fine", "config": "disc.json", "set": {"/particles/edge_mm": 2}}],
    "seeds": {"first": 4, "count": 2}})");
  CHECK(labels(c) == std::vector<std::string>{"block seed=4", "block seed=5", "disc seed=4", "disc seed=5",
                                              "fine seed=4", "fine seed=5"});
  CHECK(c.runs[0].config.particles.edge_mm == 6);
  CHECK(c.runs[4].config.particles.edge_mm == 2);
  CHECK(c.runs[4].config.experiment.type == ExperimentType::brazilian);
  CHECK(c.varied == std::vector<std::string>{"/particles/edge_mm"});
}

TEST_CASE("one configuration alone is a campaign, and gives the run that `run` would make") {
  const CampaignConfig c = read(R"({"base": "disc.json"})");
  REQUIRE(c.runs.size() == 1);
  CHECK(c.runs[0].label == "disc");
  CHECK(config_hash(c.runs[0].config) ==
        config_hash(parse_run_config(R"({"experiment": {"type": "brazilian"}})", "x")));
}

TEST_CASE("overrides change the campaign where it has the key, else every run, above all else") {
  const std::string text = R"({"base": "block.json", "set": {"/output/frames": 3}, "seeds": {"first": 1, "count": 2},
                               "slurm": {"partition": "long", "memory_mb": 300}})";
  const CampaignConfig c = read(text, {"/seeds/count=3", "/output/frames=0", "/slurm/partition=short", "/name=other"});
  CHECK(c.runs.size() == 3);
  CHECK(c.runs[0].config.output.frames == 0);
  CHECK(c.slurm.partition == "short");
  CHECK(c.slurm.memory_mb == 300);
  CHECK(c.name == "other");
}

TEST_CASE("every bad campaign is one clear error") {
  using Catch::Contains;
  using Catch::StartsWith;
  CHECK_THAT(fault("{}"), StartsWith("/base: is missing, and so is \"runs\""));
  CHECK_THAT(fault("[]"), Contains("sweep.json: must be an object"));
  CHECK_THAT(fault("{"), Contains("sweep.json:1:2: is not JSON"));
  CHECK_THAT(fault(R"({"base": 3})"), StartsWith("/base: must be a string or an array (found 3"));
  CHECK_THAT(fault(R"({"base": []})"), StartsWith("/base: has the wrong number of values"));
  CHECK_THAT(fault(R"({"bse": "disc.json"})"), StartsWith("/bse: is not a key") && Contains("did you mean base?"));
  CHECK_THAT(fault(R"({"base": "dics.json"})"), Contains("dics.json: cannot be read: No such file"));
  CHECK_THAT(fault(R"({"vary": [], "runs": []})"), StartsWith("/vary: has no \"base\" to vary"));
  CHECK_THAT(fault(R"({"base": "disc.json", "vary": [{"pointer": "/particles/edge_mm", "values": []}]})"),
             StartsWith("/vary/0/values: has the wrong number of values"));
  CHECK_THAT(
      fault(R"({"base": "disc.json", "vary": [{"pointer": "/a", "values": [1]}, {"pointer": "/a", "values": [1]}]})"),
      StartsWith("/vary/1/pointer: is varied twice (found /a"));
  CHECK_THAT(fault(R"({"base": "disc.json", "seeds": [1], "vary": [{"pointer": "/particles/seed", "values": [1]}]})"),
             Contains("\"seeds\" varies /particles/seed"));
  CHECK_THAT(fault(R"({"base": "disc.json", "set": {"particles": 1}})"),
             StartsWith("/set/particles: is no JSON pointer"));
  CHECK_THAT(fault(R"({"base": "disc.json", "seeds": {"first": 1}})"), StartsWith("/seeds/count: is missing"));
  CHECK_THAT(fault(R"({"base": "disc.json", "seeds": [1, 1]})"), StartsWith("/seeds: has a value twice"));
  CHECK_THAT(fault(R"({"base": "disc.json", "seeds": {"first": 1, "count": 100000},
                       "vary": [{"pointer": "/particles/edge_mm", "values": [2, 3]}]})"),
             Contains("number of runs that is out of range (found 2e+05; allowed: 1 to 100000)"));
  CHECK_THAT(fault(R"({"runs": [{"label": "a", "config": "disc.json"}, {"label": "a", "config": "block.json"}]})"),
             Contains("gives a label twice (found a)"));
  CHECK_THAT(fault(R"({"base": "disc.json", "slurm": {"memory_mb": -1}})"),
             StartsWith("/slurm/memory_mb: is out of range"));
  CHECK_THAT(fault(R"({"base": "disc.json", "seeds": [1]})", {"/particles/seed=3"}),
             StartsWith("--set /particles/seed: is varied by the campaign"));
  CHECK_THAT(fault(R"({"base": "disc.json", "seeds": [1]})", {"/seeds/0=3"}),
             StartsWith("/seeds/0: is inside an array, which is set as a whole"));
  CHECK_THAT(fault(R"({"base": "disc.json"})", {"nonsense"}, ErrorKind::usage), StartsWith("--set"));
}

TEST_CASE("what is wrong with many runs in the same way is told of the first, with its label") {
  const std::string text = R"({"base": "disc.json", "set": {"/particles/edge_mn": 3}, "seeds": [1, 2, 3]})";
  CHECK_THAT(fault(text), Catch::Contains("disc.json, run \"disc seed=1\": /particles/edge_mn") &&
                              Catch::Contains("did you mean edge_mm?"));
}

TEST_CASE("the schema's defaults for Slurm are the struct's") {
  const nlohmann::json& node = *schema_at(parsed_schema("campaign"), "/slurm");
  const auto fallback = [&](const char* key) { return node.at("properties").at(key).at("default"); };
  const SlurmConfig c;
  CHECK(fallback("partition") == c.partition);
  CHECK(fallback("account") == c.account);
  CHECK(fallback("time_limit_min") == c.time_limit_min);
  CHECK(fallback("memory_mb") == c.memory_mb);
  CHECK(fallback("max_tasks") == c.max_tasks);
  CHECK(fallback("extra_arguments") == c.extra_arguments);
  CHECK(fallback("poll_interval_s") == c.poll_interval_s);
  CHECK(fallback("lost_after_s") == c.lost_after_s);
  CHECK(fallback("resubmissions") == c.resubmissions);
  CHECK(node.at("properties").size() == 9);
}

TEST_CASE("the shipped campaigns are read without a fault") {
  const fs::path folder = fs::path(ASPERITY_SOURCE_DIR) / "configs/campaign";
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    INFO(entry.path());
    CHECK_FALSE(read_campaign_config(entry.path()).runs.empty());
    CHECK(read_campaign_config(entry.path()).name == entry.path().stem().string());
    CHECK(config_kind(entry.path()) == "campaign");
    ++count;
  }
  CHECK(count >= 1);
}
