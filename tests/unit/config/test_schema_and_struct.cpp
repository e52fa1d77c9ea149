#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <set>

#include "core/config/bindings.hpp"
#include "core/config/enum_words.hpp"
#include "core/config/schema.hpp"
#include "core/config/schema_faults.hpp"
#include "core/config/schema_lookup.hpp"

using namespace asperity;
using nlohmann::json;

namespace {

const json& node_at(std::string_view pointer) {
  const json* node = schema_at(parsed_schema("run"), std::string(pointer));
  REQUIRE(node);
  return *node;
}

/// Pointers of the schema's leaves: everything but objects.
std::set<std::string> schema_leaves() {
  std::set<std::string> leaves;
  for (const std::string& pointer : schema_pointers(parsed_schema("run")))
    if (node_at(pointer).at("type") != "object") leaves.insert(pointer);
  return leaves;
}

/// An array that the key may have and that is not its default.
json other_array(std::string_view pointer) {
  if (pointer == "/output/fields") return {"damage"};
  if (pointer == "/joint/profile")
    return json::array({{{"angle_deg", 15.0}, {"height_mm", 3.0}, {"gap_before_mm", 1.0}}});
  if (pointer == "/experiment/loading/unloading") return json::array({{{"at_mm", 0.2}, {"stress_ratio", 0.3}}});
  if (pointer == "/mechanisms")
    return json::array({{{"type", "platen_friction"}, {"amplitude", 0.5}, {"friction_coefficient", 0.1}}});
  if (pointer == "/joint/points_mm") return json::array({json::array({0.0, 0.0}), json::array({9.0, 1.0})});
  return {0.3, 0.4};
}

template <class Enum>
json words_as_json() {
  json words = json::array();
  for (const auto& [value, text] : words_of(Enum{})) words.push_back(text);
  return words;
}

}  // namespace

TEST_CASE("the embedded schema is the file, and an unknown kind is a usage error") {
  std::ifstream file(ASPERITY_SOURCE_DIR "/configs/schema/run.schema.json");
  CHECK(schema_text("run") == std::string(std::istreambuf_iterator<char>(file), {}));
  try {
    schema_text("rnu");
    FAIL("an unknown kind was accepted");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::usage);
    CHECK(error.faults().at(0).value == "rnu");
    CHECK(error.faults().at(0).allowed.find("run") != std::string::npos);
  }
}

TEST_CASE("schema, bindings and structs have the same keys") {
  std::set<std::string> bound{"/$schema", "/joint/profile_csv"};  // whose points become /joint/points_mm
  for (const Binding& binding : bindings()) CHECK(bound.insert(std::string(binding.pointer)).second);
  CHECK(bound == schema_leaves());
}

TEST_CASE("every schema default equals the struct's default") {
  const RunConfig defaults;
  const std::set<std::string> without_default{"/experiment/type", "/name"};
  for (const Binding& binding : bindings()) {
    INFO(binding.pointer);
    const json& node = node_at(binding.pointer);
    if (without_default.contains(std::string(binding.pointer))) {
      CHECK_FALSE(node.contains("default"));
      continue;
    }
    CHECK(binding.write(defaults) == node.value("default", json()));
    CHECK((node.contains("default") || node.contains("x-default")));
  }
}

TEST_CASE("reading a binding writes to its own member only") {
  for (const Binding& binding : bindings()) {
    INFO(binding.pointer);
    const json& node = node_at(binding.pointer);
    json value;
    if (node.contains("enum")) {
      value = node.at("enum").front() == binding.write({}) ? node.at("enum").back() : node.at("enum").front();
    } else if (node.at("type") == "boolean") {
      value = binding.write({}) == json(false);
    } else if (node.at("type") == "array") {
      value = other_array(binding.pointer);
    } else {
      value = node.at("type") == "string" ? json("other") : json(7);
    }
    RunConfig config;
    binding.read(config, value);
    CHECK(binding.write(config) == value);
    for (const Binding& other : bindings())
      CHECK((other.pointer == binding.pointer || other.write(config) == other.write({})));
  }
}

TEST_CASE("the schema's defaults lie in their own ranges") {
  json document = {{"experiment", {{"type", "brazilian"}}}};
  for (const std::string& pointer : schema_leaves())
    if (node_at(pointer).contains("default")) document[json::json_pointer(pointer)] = node_at(pointer).at("default");
  const std::vector<Fault> faults = schema_faults(document, parsed_schema("run"));
  CHECK((faults.empty() ? "" : describe(faults.front())) == "");
}

TEST_CASE("every key is described; a number says its unit as its name does, and its range; objects are closed") {
  const std::vector<std::pair<std::string, std::string>> endings{{"_mpa_per_mm", "MPa/mm"},
                                                                 {"_mpa_sqrt_m", "MPa m^0.5"},
                                                                 {"_kg_per_m3", "kg/m3"},
                                                                 {"_n_per_mm", "N/mm"},
                                                                 {"_mm_per_s", "mm/s"},
                                                                 {"_gpa", "GPa"},
                                                                 {"_mpa", "MPa"},
                                                                 {"_deg", "deg"},
                                                                 {"_mm", "mm"},
                                                                 {"_px", "px"},
                                                                 {"_s", "s"}};
  for (const std::string& pointer : schema_pointers(parsed_schema("run"))) {
    INFO(pointer);
    const json& node = node_at(pointer);
    CHECK(node.value("description", "").size() > 5);
    if (node.at("type") == "object") CHECK(node.at("additionalProperties") == false);
    if (node.at("type") != "number" && node.at("type") != "integer") continue;
    std::string unit = "1";
    for (const auto& [ending, its_unit] : endings)
      if (unit == "1" && pointer.ends_with(ending)) unit = its_unit;
    CHECK(node.at("unit") == unit);
    CHECK((unit == "1" || node.at("description").get<std::string>().ends_with("Unit: " + unit + ".")));
    CHECK((node.contains("minimum") || node.contains("exclusiveMinimum")));
    CHECK((node.contains("maximum") || node.contains("exclusiveMaximum")));
  }
}

TEST_CASE("the enumerations' words are the schema's") {
  CHECK(words_as_json<ExperimentType>() == node_at("/experiment/type").at("enum"));
  CHECK(words_as_json<PlaneCondition>() == node_at("/experiment/plane").at("enum"));
  CHECK(words_as_json<PlatenShape>() == node_at("/experiment/platens/shape").at("enum"));
  CHECK(words_as_json<ParticleKind>() == node_at("/particles/kind").at("enum"));
  CHECK(words_as_json<LoadingMode>() == node_at("/experiment/loading/mode").at("enum"));
  CHECK(words_as_json<LawReading>() == node_at("/contacts/law/reading").at("enum"));
  CHECK(words_as_json<LawForm>() == node_at("/contacts/law/form").at("enum"));
  CHECK(words_as_json<ShearPeak>() == node_at("/contacts/law/shear_peak").at("enum"));
  CHECK(words_as_json<OpeningShearStiffness>() == node_at("/contacts/law/opening_shear_stiffness").at("enum"));
  CHECK(word(LawReading::consistent) == "default");
  CHECK(from_word<LawReading>("default") == LawReading::consistent);
}

TEST_CASE("ranges in words") {
  CHECK(allowed_text(node_at("/experiment/diameter_mm")) == "1 to 10000 mm");
  CHECK(allowed_text(node_at("/experiment/thickness_mm")) == "above 0, up to 10000 mm");
  CHECK(allowed_text(node_at("/experiment/stop/fraction_of_peak")) == "above 0, below 1");
  CHECK(allowed_text(node_at("/contacts/friction_angle_deg")) == "from 0, below 90 deg");
  CHECK(allowed_text(node_at("/particles/poissons_ratio")) == "-0.99 to 0.49");
  CHECK(allowed_text(node_at("/output/frames")) == "whole number, 0 to 100000");
  CHECK(allowed_text(node_at("/experiment/plane")) == "\"stress\" or \"strain\"");
  CHECK(allowed_text(node_at("/measurement/modulus_window")) == "2 values, each 0 to 1");
  CHECK(allowed_text(json{{"type", "number"}, {"minimum", 0}, {"unit", "s"}}) == "0 or more s");
  CHECK(allowed_text(json{{"type", "number"}, {"exclusiveMinimum", 0.5}}) == "above 0.5");
  CHECK(allowed_text(json{{"type", "number"}, {"maximum", 2}}) == "up to 2");
  CHECK(allowed_text(json{{"type", "number"}}) == "a number");
}
