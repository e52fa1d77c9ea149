#include "core/campaign/campaign_table.hpp"

#include <catch2/catch.hpp>

#include "core/base/atomic_file.hpp"
#include "core/output/summary.hpp"

using namespace asperity;

namespace fs = std::filesystem;

namespace {

const fs::path kFolder = fs::path(ASPERITY_TEST_SCRATCH) / "campaign_table";

Summary summary_of(const nlohmann::ordered_json& results) {
  Summary summary;
  summary.results = results;
  summary.energy["relative_closure_error"] = 1e-5;
  summary.cracks = {{"tension", 3}, {"shear", 40}};
  return summary;
}

CampaignRun run_of(const std::string& label, double edge, std::uint64_t seed) {
  CampaignRun run{label, {}};
  run.config.particles.edge_mm = edge;
  run.config.particles.seed = seed;
  return run;
}

/// Three runs: a disc that finished, a block that finished with other results, and one that failed.
struct Example {
  CampaignConfig config;
  std::vector<CampaignOutcome> outcomes;
  Example() {
    fs::create_directories(kFolder / "a");
    fs::create_directories(kFolder / "b");
    write_summary(kFolder / "a/summary.json", summary_of({{"tensile_strength_mpa", 1.5}}));
    write_summary(kFolder / "b/summary.json",
                  summary_of({{"youngs_modulus_gpa", 0.1 + 0.2}, {"poissons_ratio", nullptr}}));
    config.name = "three";
    config.varied = {"/particles/edge_mm", "/contacts/law/reading"};
    config.runs = {run_of("one, two", 4, 1), run_of("two", 4.5, 2), run_of("three", 5, 18446744073709551615u)};
    config.base_names = {"disc", "block", "block"};
    outcomes = {{"one, two", kFolder / "a", RunStatus::finished, false, "reached the stop strain", 0, 2.5},
                {"two", kFolder / "b", RunStatus::finished, true, "reached the stop strain", 0, 4.0},
                {"three", kFolder / "c", RunStatus::failed, false, "step 7: not finite", 4, 0.5}};
  }
};

}  // namespace

TEST_CASE("the table has a row for each run and a column for each number of any run") {
  const Example example;
  write_campaign_table(kFolder / "table.csv", example.config, example.outcomes);
  CHECK(read_file(kFolder / "table.csv") ==
        "label,run,config,/particles/edge_mm,/contacts/law/reading,seed,status,reason,tensile_strength_mpa,"
        "youngs_modulus_gpa,poissons_ratio,cracks_tension,cracks_shear,relative_closure_error\n"
        "\"one, two\",a,disc,4,default,1,finished,reached the stop strain,1.5,,,3,40,1e-05\n"
        "two,b,block,4.5,default,2,finished,reached the stop strain,,0.30000000000000004,,3,40,1e-05\n"
        "three,c,block,5,default,18446744073709551615,failed,step 7: not finite,,,,,,\n");
}

TEST_CASE("campaign.json has what this call did and cost") {
  const Example example;
  write_campaign_json(kFolder / "campaign.json", example.config, example.outcomes, 3.5);
  const auto json = nlohmann::json::parse(read_file(kFolder / "campaign.json"));
  CHECK(json.at("name") == "three");
  CHECK(json.at("runs").size() == 3);
  CHECK(json.at("runs")[1].at("reused") == true);
  CHECK(json.at("runs")[2].at("exit_code") == 4);
  CHECK(json.at("runs")[2].at("status") == "failed");
  CHECK(json.at("runs")[0].at("varied").at("/particles/edge_mm") == "4");
  const auto& cost = json.at("cost");
  CHECK(cost.at("runs") == 3);
  CHECK(cost.at("finished") == 2);
  CHECK(cost.at("failed") == 1);
  CHECK(cost.at("reused") == 1);
  CHECK(cost.at("wall_s") == 3.5);
  CHECK(cost.at("compute_s") == 3.0);  // the re-used run's 4 s were paid before
}
