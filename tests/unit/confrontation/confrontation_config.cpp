#include "core/confrontation/confrontation_config.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <set>

#include "core/config/read_config.hpp"
#include "core/config/schema.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/confrontation/feature_bank.hpp"
#include "tests/unit/confrontation/confrontation_folder.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

/// One fault there, in these words, with what is allowed or a hint.
void check_fault(const std::vector<Fault>& faults, const std::string& where, const std::string& words) {
  std::string all;
  for (const Fault& fault : faults) all += describe(fault) + "\n";
  CAPTURE(all, where, words);
  REQUIRE(faults.size() == 1);
  CHECK(faults.front().where == where);
  CHECK(describe(faults.front()).find(words) != std::string::npos);
}

TestUse use_of(const ConfrontationConfig& config, const std::string& id) {
  return find_test(config.measured, id)->use.value();
}

}  // namespace

TEST_CASE("the schema of confrontations is embedded, and every number in it has a unit or is the parameter's own") {
  std::ifstream file(ASPERITY_SOURCE_DIR "/configs/schema/confrontation.schema.json");
  CHECK(schema_text("confrontation") == std::string(std::istreambuf_iterator<char>(file), {}));
  const json& schema = parsed_schema("confrontation");
  const std::set<std::string> own_unit{"lower", "upper"};
  for (const auto& [key, node] : schema.at("properties").at("parameters").at("items").at("properties").items()) {
    CAPTURE(key);
    CHECK(!node.at("description").get<std::string>().empty());
    if (single_type(node) == "number") CHECK(node.contains("unit") != own_unit.contains(key));
  }
}

TEST_CASE("defaults of the schema are those of the struct") {
  const json& meshes = parsed_schema("confrontation").at("properties").at("meshes").at("properties");
  const ConfrontationConfig config;
  CHECK(meshes.at("noise").at("default") == config.meshes.noise);
  CHECK(meshes.at("common").at("default") == config.meshes.common);
  CHECK(meshes.at("screen").at("default") == config.meshes.screen);
  CHECK(meshes.at("fresh").at("default") == config.meshes.fresh);
  CHECK(meshes.at("first_seed").at("default") == config.meshes.first_seed);
  CHECK(parsed_schema("confrontation").at("properties").at("draws").at("default") == config.draws);
  CHECK(parsed_schema("confrontation").at("properties").at("seed").at("default") == config.seed);
  CHECK(parsed_schema("confrontation").at("properties").at("alarm_level").at("default") == config.alarm_level);
}

TEST_CASE("a confrontation is read with its measured file, parameters, features and mechanisms") {
  const ConfrontationFolder folder("read");
  json document = confrontation();
  document["declared"] = json::parse(R"([{"what": "E", "value": "18 GPa", "why": "a handbook"}])");
  document["meshes"] = {{"noise", 10}, {"common", 5}};
  document["linearise_at"] = "reference";
  document["bank"] = "bank.txt";
  write_bank(folder.root() / "bank.txt", {});
  document["slurm"] = {{"partition", "short"}};
  const ConfrontationConfig config = folder.read(document, {"/draws=260", "/alarm_level=0.05"});
  CHECK(config.measured.name == "D17");
  CHECK(config.measured_path == folder.root() / "data.json");
  CHECK(config.bank == folder.root() / "bank.txt");
  CHECK(config.meshes.noise == 10);
  CHECK(config.meshes.screen == 3);
  CHECK(config.draws == 260);
  CHECK(config.alarm_level == 0.05);
  CHECK(config.linearise_at == LineariseAt::reference);
  CHECK(config.slurm.partition == "short");
  CHECK(config.declared.at(0).value == "18 GPa");
  REQUIRE(config.parameters.size() == 3);
  CHECK(config.parameters[0].reference == 1.3);
  CHECK(config.parameters[0].unit == "MPa");
  CHECK(config.parameters[0].label == "c_c");
  CHECK(config.parameters[1].transform == ParameterTransform::tangent);
  CHECK(config.parameters[2].calibrated);
  CHECK(config.features.at(ExperimentType::brazilian).front() == "tensile_strength_mpa");
  CHECK(std::is_sorted(config.mechanisms.begin(), config.mechanisms.end()));
  CHECK(std::count(config.mechanisms.begin(), config.mechanisms.end(), "joint_wear") == 1);
}

TEST_CASE("mechanisms: a list, without some, and only those that act in one of the tests") {
  ConfrontationFolder folder("mechanisms");
  json document = confrontation();
  document["mechanisms"] = {"seating", "crack_closure", "damping"};
  document["without"] = {"damping"};
  CHECK(folder.read(document).mechanisms == std::vector<std::string>{"crack_closure", "seating"});
  folder.measured["tests"].erase(3);
  document.erase("mechanisms");
  const std::vector<std::string> all = folder.read(document).mechanisms;
  CHECK(std::count(all.begin(), all.end(), "joint_wear") == 0);
  CHECK(std::count(all.begin(), all.end(), "seating") == 1);
  document["mechanisms"] = {"joint_wear"};
  check_fault(folder.faults(document), "/mechanisms", "joint_wear");
  document["mechanisms"] = {"seatin"};
  check_fault(folder.faults(document), "/mechanisms/0", "did you mean seating?");
}

TEST_CASE("a mechanism that a base has is no candidate any more") {
  const ConfrontationFolder folder("base mechanism");
  json document = confrontation();
  for (auto& [type, base] : document["bases"].items())
    base["mechanisms"] = json::array({{{"type", "crack_closure"}, {"amplitude", 0.5}}});
  const std::vector<std::string> all = folder.read(document).mechanisms;
  CHECK(std::count(all.begin(), all.end(), "crack_closure") == 0);
  CHECK(std::count(all.begin(), all.end(), "seating") == 1);
}

TEST_CASE("calibrate: all, some, none; a parameter that acts nowhere is left out and named") {
  ConfrontationFolder folder("calibrate");
  json document = confrontation();
  document["calibrate"] = {"E_p"};
  ConfrontationConfig config = folder.read(document);
  CHECK_FALSE(config.parameters[0].calibrated);
  CHECK(config.parameters[2].calibrated);
  document["calibrate"] = json::array();
  config = folder.read(document);
  CHECK(std::none_of(config.parameters.begin(), config.parameters.end(),
                     [](const ConfrontationParameter& p) { return p.calibrated; }));
  document["parameters"][0]["only"] = {"direct_shear"};
  folder.measured["tests"].erase(3);
  config = folder.read(document);
  CHECK(config.parameters.size() == 2);
  CHECK(config.idle_parameters == std::vector<std::string>{"c_c"});
  document["calibrate"] = {"phi"};
  check_fault(folder.faults(document), "/calibrate/0", "is no name of a parameter");
}

TEST_CASE("hold_out goes over the measured file's use; neither: a split is proposed") {
  ConfrontationFolder folder("split");
  json document = confrontation();
  CHECK(folder.read(document).split_proposed);
  folder.measured["tests"][1]["use"] = "hold_out";
  ConfrontationConfig config = folder.read(document);
  CHECK_FALSE(config.split_proposed);
  CHECK(use_of(config, "T1") == TestUse::hold_out);
  CHECK(use_of(config, "U") == TestUse::fit);
  document["hold_out"] = {"B"};
  config = folder.read(document);
  CHECK(use_of(config, "T1") == TestUse::fit);
  CHECK(use_of(config, "B") == TestUse::hold_out);
  document["hold_out"] = {"B1"};
  check_fault(folder.faults(document), "/hold_out/0", "did you mean B?");
  document["hold_out"] = {"U", "T1", "B", "J"};
  check_fault(folder.faults(document), "/hold_out", "leaves no test to be fitted");
}

TEST_CASE("what a parameter cannot be is told at its pointer") {
  const ConfrontationFolder folder("parameters");
  const auto faults = [&](const json& parameter) {
    json document = confrontation();
    document["parameters"] = json::array({parameter});
    return folder.faults(document);
  };
  const json good = confrontation()["parameters"][0];
  const auto with = [&](const char* key, const json& value) {
    json changed = good;
    changed[key] = value;
    return faults(changed);
  };
  CHECK(faults(good).empty());
  check_fault(with("pointer", "/contacts/cohesion"), "/parameters/0/pointer", "did you mean cohesion_mpa?");
  check_fault(with("pointer", "/particles/seed"), "/parameters/0/pointer", "is no number that could be moved");
  check_fault(with("lower", 5), "/parameters/0/lower", "does not lie below upper");
  check_fault(with("lower", 0), "/parameters/0/lower", "has no logarithm");
  check_fault(with("lower", 1.5), "/parameters/0", "starts outside its own range");
  check_fault(with("transfrom", "log"), "/parameters/0/transfrom", "did you mean transform?");
  check_fault(with("tied", {"/contacts/cohesion"}), "/parameters/0/tied/0", "is no microparameter");
  check_fault(with("tied", {"/contacts/cohesion_mpa"}), "/parameters/0/tied", "moves already");
  check_fault(with("pointer", "/contacts/~x"), "/parameters/0/pointer", "is no microparameter");
  check_fault(with("step", 10), "/parameters/0/step", "far wider than the way from lower to upper");
  const std::vector<Fault> derived = with("tied", {"/contacts/shear_stiffness_mpa_per_mm"});
  REQUIRE(derived.size() == 4);
  CHECK(derived[0].where == "/parameters/0/tied/0");
  CHECK(derived[0].what == "is not set in the base for uniaxial");
}

TEST_CASE("two parameters with one name or pointer, and bases that disagree") {
  const ConfrontationFolder folder("twice");
  json document = confrontation();
  document["parameters"][1]["name"] = "c_c";
  check_fault(folder.faults(document), "/parameters/1/name", "is another parameter's too");
  document = confrontation();
  document["parameters"][2]["tied"] = {"/contacts/cohesion_mpa"};
  check_fault(folder.faults(document), "/parameters/2", "moves what c_c moves");
  document = confrontation();
  document["bases"]["brazilian"]["contacts"]["cohesion_mpa"] = 1.4;
  check_fault(folder.faults(document), "/parameters/0/pointer", "has another value in the virtual test case_B");
  document["parameters"][0]["only"] = {"brazilian"};
  CHECK(folder.read(document).parameters[0].reference == 1.4);
}

TEST_CASE("bases: their own faults at their place, a missing one, another experiment's") {
  const ConfrontationFolder folder("bases");
  json document = confrontation();
  document["bases"]["brazilian"]["particles"]["edge"] = 3;
  check_fault(folder.faults(document), "/bases/brazilian/particles/edge", "did you mean edge_mm?");
  document = confrontation();
  document["bases"].erase("brazilian");
  check_fault(folder.faults(document), "/bases/brazilian", "is missing");
  document["bases"].erase("direct_shear");
  CHECK(folder.faults(document).size() == 2);
  document = confrontation();
  document["bases"]["brazilian"]["experiment"]["type"] = "uniaxial";
  check_fault(folder.faults(document), "/bases/brazilian/experiment/type", "move it to /bases/uniaxial");
  document["bases"]["brazilian"] = "disc.json";
  folder.put("disc.json", run_base("brazilian", 1600.0));
  CHECK(folder.faults(document).empty());
  json disc = run_base("brazilian", 1600.0);
  disc["contacts"]["cohesion_mpa"] = -1;
  folder.put("disc.json", disc);
  const std::string place = "/bases/brazilian, " + (folder.root() / "disc.json").string() + ": /contacts/cohesion_mpa";
  check_fault(folder.faults(document), place, "is out of range");
}

TEST_CASE("sets and sizes: pointers, tests, what is assumed without a word why") {
  const ConfrontationFolder folder("sets");
  json document = confrontation();
  document["set"] = {{"/particles/edg_mm", 3}};
  check_fault(folder.faults(document), "/set: /particles/edg_mm", "did you mean edge_mm?");
  document = confrontation();
  document["tests"] = {{"T2", {{"set", json::object()}}}};
  check_fault(folder.faults(document), "/tests/T2", "did you mean T1?");
  document["set"] = {{"/contacts/~x", 1}};
  document["tests"] = json::object();
  check_fault(folder.faults(document), "/set: /contacts/~x", "~ is written ~0");
  document = confrontation();
  document["tests"] = {{"T1", {{"/experiment/stop/axial_strain", 0.03}}}};
  check_fault(folder.faults(document), "/tests/T1", "is no object with the key \"set\"");
  document["tests"] = {{"T1", {{"set", {{"/experiment/stop/axial_strain", 7}}}}}};
  check_fault(folder.faults(document), "virtual test T1: /experiment/stop/axial_strain", "is out of range");
  document = confrontation();
  document["assumed"].erase("why");
  check_fault(folder.faults(document), "/assumed/why", "is missing");
  document["assumed"] = {{"width_mm", 50}, {"why", "usual"}};
  check_fault(folder.faults(document), "/assumed/height_mm", "does not give it for U");
}

TEST_CASE(
    "features are those of the declared list; meshes lie one within the other; the measured file's faults are its "
    "own") {
  ConfrontationFolder folder("features");
  json document = confrontation();
  document["features"] = {{"brazilian", {"stiffness_n_per_mm2", "tensile_strength_mpa"}}};
  CHECK(folder.read(document).features.at(ExperimentType::brazilian) ==
        std::vector<std::string>{"tensile_strength_mpa", "stiffness_n_per_mm2"});
  document["features"] = {{"brazilian", {"tensile_strength"}}};
  check_fault(folder.faults(document), "/features/brazilian/0", "did you mean tensile_strength_mpa?");
  document = confrontation();
  document["meshes"] = {{"noise", 6}};
  CHECK(folder.faults(document).empty());
  document["meshes"] = {{"common", 4}, {"screen", 5}};
  check_fault(folder.faults(document), "/meshes/screen", "at most 4");
  folder.measured["tests"][0]["experiment"] = "uniaxal";
  const std::vector<Fault> faults = folder.faults(confrontation());
  REQUIRE(!faults.empty());
  CHECK(faults.front().where == "/measured, " + (folder.root() / "data.json").string() + ": /tests/0/experiment");
}

TEST_CASE("a bank that cannot be read is told with the configuration's other faults") {
  const ConfrontationFolder folder("bad_bank");
  json document = confrontation();
  document["bank"] = "none.txt";
  document["hold_out"] = {"none"};
  const std::vector<Fault> faults = folder.faults(document);
  REQUIRE(faults.size() == 2);
  CHECK(faults[0].where == "/bank");
  std::ofstream(folder.root() / "none.txt") << "no bank";
  CHECK(folder.faults(document).front().where.starts_with("/bank, " + (folder.root() / "none.txt").string()));
}

TEST_CASE("a file is known for a confrontation by its keys") {
  const ConfrontationFolder folder("kinds");
  json document = confrontation();
  document.erase("$schema");
  folder.put("no_schema.json", document);
  CHECK(config_kind(folder.root() / "no_schema.json") == "confrontation");
}
