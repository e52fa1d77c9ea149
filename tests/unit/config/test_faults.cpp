#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/config/schema_faults.hpp"
#include "fault_finder.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {
std::string disc_with(const std::string& rest) { return R"({"experiment": {"type": "brazilian"}, )" + rest + "}"; }
}  // namespace

TEST_CASE("the smallest configuration is accepted") { CHECK_FALSE(refusal(kDisc).kind); }

TEST_CASE("a syntax error names file, line and column") {
  const Refusal r = refusal("{\n  \"experiment\": {\"type\": \"brazilian\",}\n}");
  CHECK(r.kind == ErrorKind::config);
  REQUIRE(r.faults.size() == 1);
  CHECK(r.faults[0].where == "dir/some run.json:2:38");
  CHECK(contains(r.faults[0].what, "is not JSON: syntax error while parsing object key"));
  CHECK(contains(r.faults[0].hint, "no comma before a closing bracket"));
  CHECK(refusal("").faults.at(0).where == "dir/some run.json:1:1");
  CHECK(contains(refusal("{} {}").faults.at(0).what, "expected end of input"));
  CHECK(refusal("{} // a comment").kind == ErrorKind::config);
}

TEST_CASE("brackets nested without end are refused, not followed") {
  const Refusal r = refusal("{\"a\": " + std::string(1000000, '[') + std::string(1000000, ']') + "}");
  REQUIRE(r.faults.size() == 1);
  CHECK(contains(r.faults[0].what, "nested too deeply"));
  const Refusal allowed = refusal("{\"a\": " + std::string(60, '[') + std::string(60, ']') + "}");
  CHECK(allowed.at("/a").what == "is not a key of the configuration");
}

/// So many times the same between commas.
std::string many(const std::string& item, int times) {
  std::string text = item;
  for (int i = 1; i < times; ++i) text += "," + item;
  return text;
}

TEST_CASE("an array without end is refused, not compared value by value") {
  const Refusal r = refusal(disc_with("\"output\": {\"fields\": [" + many("\"cracks\"", 100000) + "]}"));
  REQUIRE(r.faults.size() == 1);
  CHECK(r.faults[0].where == "/output/fields/256");
  CHECK(contains(r.faults[0].what, "too many"));
  const Refusal allowed = refusal(disc_with("\"output\": {\"fields\": [" + many("\"cracks\"", 256) + "]}"));
  CHECK(allowed.faults.size() == 1);
  CHECK(allowed.at("/output/fields").what == "has a value twice");
}

TEST_CASE("only the first hundred numbers that are too large are named") {
  std::string keys;
  for (int i = 0; i < 5000; ++i) keys += (i > 0 ? ",\"k" : "\"k") + std::to_string(i) + "\": 1e999";
  const Refusal r = refusal("{" + keys + "}");
  CHECK(r.faults.size() == 100);
  CHECK(r.at("/k99").what == "is too large for a number");
}

TEST_CASE("a text that is no object is refused") {
  const Refusal r = refusal("[1]");
  REQUIRE(r.faults.size() == 1);
  CHECK(r.faults[0].where == "dir/some run.json");
  CHECK(r.faults[0].value == "[1]");
}

TEST_CASE("a duplicate key is a fault at its pointer") {
  const Refusal r =
      refusal(R"({"experiment": {"type": "brazilian", "stop": {"time_s": 1, "time_s": 2}}, "name": "a", "name": "b"})");
  CHECK(r.faults.size() == 2);
  CHECK(r.at("/experiment/stop/time_s").what == "is given twice");
  CHECK(r.at("/name").what == "is given twice");
  CHECK_FALSE(refusal(R"({"experiment": {"type": "brazilian"}, "particles": {"seed": 1}, "name": "type"})").kind);
}

TEST_CASE("a number beyond double is a fault, and the rest is still checked") {
  const Refusal r =
      refusal(disc_with(R"("particles": {"edge_mm": -1e999, "density_kg_per_m3": 1e9999}, "output": {"frames": -1})"));
  CHECK(r.faults.size() == 3);
  CHECK(r.at("/particles/edge_mm").value == "-1e999");
  CHECK(r.at("/particles/edge_mm").what == "is too large for a number");
  CHECK(r.at("/particles/density_kg_per_m3").value == "1e9999");
  CHECK(r.at("/output/frames").what == "is out of range");
  CHECK(refusal(disc_with(R"("measurement": {"modulus_window": [0.1, 1e999]})"))
            .at("/measurement/modulus_window/1")
            .value == "1e999");
}

TEST_CASE("an unknown key names the nearest sibling, or the nearest key anywhere") {
  const Refusal r =
      refusal(R"({"experiment": {"type": "brazilian", "diametre_mm": 54, "platens": {"colour": "red"}}, "edge_mm": 2,
                               "contacts": {"seed": 3}, "particles": {"edge": 2.0}})");
  CHECK(r.faults.size() == 5);
  CHECK(r.at("/experiment/diametre_mm").hint == "did you mean diameter_mm?");
  CHECK(r.at("/experiment/diametre_mm").value == "54");
  CHECK(r.at("/experiment/platens/colour").hint.empty());
  CHECK(r.at("/experiment/platens/colour").allowed ==
        "an object with the keys friction_coefficient, jaw_radius_mm, shape and stiffness_mpa_per_mm");
  CHECK(r.at("/edge_mm").hint == "did you mean /particles/edge_mm?");
  CHECK(r.at("/contacts/seed").hint == "did you mean /particles/seed?");
  CHECK(r.at("/particles/edge").hint == "did you mean edge_mm?");
}

TEST_CASE("keys with slashes and tildes are escaped in the pointer") {
  CHECK(refusal(disc_with(R"("a/b~c": 1)")).at("/a~1b~0c").value == "1");
}

TEST_CASE("a wrong type names the right one") {
  const Refusal r = refusal(disc_with(
      R"("particles": {"edge_mm": "2.0", "seed": 1.5}, "material": 3, "output": {"fields": "damage", "frames": null},
                                         "name": 7, "integration": {"time_step_s": true})"));
  CHECK(r.faults.size() == 7);
  CHECK(r.at("/particles/edge_mm").what == "must be a number");
  CHECK(r.at("/particles/edge_mm").value == "\"2.0\"");
  CHECK(r.at("/particles/edge_mm").allowed == "above 0, up to 1000 mm");
  CHECK(r.at("/particles/edge_mm").hint == "write the number without quotes");
  CHECK(r.at("/particles/seed").what == "must be a whole number");
  CHECK(r.at("/material").what == "must be an object");
  CHECK(r.at("/output/fields").what == "must be an array");
  CHECK(r.at("/output/frames").value == "null");
  CHECK(r.at("/name").what == "must be a string");
  CHECK(r.at("/integration/time_step_s").value == "true");
}

TEST_CASE("a value out of range names value, range and unit") {
  const Refusal r = refusal(R"({"experiment": {"type": "brazilian", "diameter_mm": -5, "stop": {"fraction_of_peak": 1}},
    "particles": {"poissons_ratio": 0.5, "seed": -1}, "contacts": {"friction_angle_deg": 90, "cohesion_mpa": 0},
    "integration": {"mass_scaling_time_step_s": -1e-9}, "output": {"frames": -1, "width_px": 100}})");
  CHECK(r.faults.size() == 9);
  const Fault diameter = r.at("/experiment/diameter_mm");
  CHECK(diameter.what == "is out of range");
  CHECK(diameter.value == "-5");
  CHECK(diameter.allowed == "1 to 10000 mm");
  CHECK(contains(diameter.hint, "Diameter of the Brazilian disc"));
  CHECK(r.at("/experiment/stop/fraction_of_peak").allowed == "above 0, below 1");
  CHECK(r.at("/particles/poissons_ratio").allowed == "-0.99 to 0.49");
  CHECK(r.at("/particles/seed").allowed == "whole number, 0 to 9007199254740991");
  CHECK(r.at("/contacts/friction_angle_deg").allowed == "from 0, below 90 deg");
  CHECK(r.at("/contacts/cohesion_mpa").allowed == "above 0, up to 10000 MPa");
  CHECK(r.at("/integration/mass_scaling_time_step_s").allowed == "0 to 1 s");
  CHECK(r.at("/output/frames").allowed == "whole number, 0 to 100000");
  CHECK(r.at("/output/width_px").allowed == "whole number, 320 to 8192 px");
}

TEST_CASE("the largest seed is read, a larger one refused") {
  CHECK(parse_run_config(disc_with(R"("particles": {"seed": 9007199254740991})"), "x.json").particles.seed ==
        9007199254740991u);
  CHECK(refusal(disc_with(R"("particles": {"seed": 9007199254740992})")).at("/particles/seed").what ==
        "is out of range");
  CHECK(refusal(disc_with(R"("particles": {"seed": 18446744073709551615})")).at("/particles/seed").what ==
        "is out of range");
}

TEST_CASE("a word that is not allowed names the words and the nearest one") {
  const Refusal r = refusal(R"({"experiment": {"type": "brasilian"}, "contacts": {"law": {"reading": "consistent"}},
                               "output": {"fields": ["damage", "crackz", "damage"]}})");
  CHECK(r.faults.size() == 4);
  CHECK(r.at("/experiment/type").allowed == R"("uniaxial", "triaxial", "brazilian" or "direct_shear")");
  CHECK(r.at("/experiment/type").hint == R"(did you mean "brazilian"?)");
  CHECK(r.at("/contacts/law/reading").value == R"("consistent")");
  CHECK(r.at("/contacts/law/reading").allowed == R"("literal" or "default")");
  CHECK(r.at("/output/fields/1").hint == R"(did you mean "cracks"?)");
  CHECK(r.at("/output/fields").what == "has a value twice");
}

TEST_CASE("arrays of the wrong length, and names that are no folder names") {
  const Refusal r = refusal(
      R"({"experiment": {"type": "uniaxial"}, "name": "../up",
    "measurement": {"modulus_window": [0.2]}, "output": {"fields": []}})");
  CHECK(r.faults.size() == 3);
  CHECK(r.at("/measurement/modulus_window").what == "has the wrong number of values");
  CHECK(r.at("/output/fields").what == "has the wrong number of values");
  CHECK(contains(r.at("/name").what, "not allowed"));
  CHECK(refusal(disc_with("\"name\": \"" + std::string(101, 'a') + "\"")).at("/name").what == "has the wrong length");
}

TEST_CASE("the experiment and its type are required") {
  CHECK(refusal("{}").at("/experiment").what == "is missing");
  CHECK(refusal(R"({"experiment": {}})").at("/experiment/type").allowed == R"("uniaxial", "triaxial", "brazilian" or "direct_shear")");
}

TEST_CASE("faults of every kind come at once, each once") {
  const Refusal r = refusal(R"({"experiment": {"type": "brazilian", "width_mm": 54, "stop": {"time_s": 1, "time_s": 2}},
    "particles": {"edge_mm": 500, "density_kg_per_m3": "x"}, "contacts": {"cohesion": 5}})",
                            {"/experiment/diametre_mm=54", "/output/frames=-1"});
  CHECK(r.kind == ErrorKind::config);
  CHECK(r.faults.size() == 7);
  for (const char* where :
       {"/experiment/stop/time_s", "/experiment/diametre_mm", "/output/frames", "/contacts/cohesion",
        "/particles/density_kg_per_m3", "/experiment/width_mm", "/particles/edge_mm"})
    CHECK(r.at(where).where == where);
}

TEST_CASE("a faulty key brings no second fault by a cross check that needs it") {
  CHECK(refusal(R"({"experiment": {"type": "triaxial", "confining_pressure_mpa": "x"}})").faults.size() == 1);
  CHECK(refusal(R"({"experiment": {"type": "brazilian", "diameter_mm": -5}})").faults.size() == 1);
  CHECK(refusal(R"({"experiment": {"type": "triaxal", "width_mm": 54}})").faults.size() == 1);
  CHECK(refusal(R"({"experiment": {"type": "triaxal", "loading": {"hold_kinetic_ratio": 0.001}}})").faults.size() == 1);
  // An edge of 20 mm is too long for the default disc, but nobody knows how large this one is.
  CHECK(refusal(R"({"experiment": {"type": "brazilian", "diameter_mm": "0.5 m"}, "particles": {"edge_mm": 20}})")
            .faults.size() == 1);
}

TEST_CASE("the schema names a value once, by its type before its range or words") {
  const nlohmann::json schema = {{"type", "string"}, {"enum", {"a", "b"}}, {"maxLength", 5}};
  const std::vector<Fault> faults = schema_faults(7, schema);
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].what == "must be a string");
}

TEST_CASE("long values are cut in messages") {
  const std::string value = refusal(disc_with("\"output\": \"" + std::string(5000, 'x') + "\"")).at("/output").value;
  CHECK(value.size() == 80);
  CHECK(value.ends_with("..."));
}

TEST_CASE("a file that cannot be read is named") {
  for (const std::string path : {"no/such/file.json", ASPERITY_SOURCE_DIR}) {
    try {
      read_run_config(path);
      FAIL("read");
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::config);
      CHECK(contains(error.what(), path + ": cannot be read"));
    }
  }
}

TEST_CASE("the name is the file's if the text has none") {
  CHECK(parse_run_config(kDisc, "dir/some run.json").name == "some_run");
  CHECK(parse_run_config(kDisc, "dir/triaxial_0.5.json").name == "triaxial_0.5");
  CHECK(parse_run_config(kDisc, ".json").name == "run");
  CHECK(parse_run_config(disc_with(R"("name": "given")"), "dir/other.json").name == "given");
}

TEST_CASE("the plane condition's default follows the experiment") {
  CHECK(parse_run_config(kDisc, "x").experiment.plane == PlaneCondition::stress);
  CHECK(parse_run_config(kUniaxial, "x").experiment.plane == PlaneCondition::strain);
  CHECK(parse_run_config(kTriaxial, "x").experiment.plane == PlaneCondition::strain);
  CHECK(parse_run_config(kUniaxial, "x", {"/experiment/plane=stress"}).experiment.plane == PlaneCondition::stress);
}
