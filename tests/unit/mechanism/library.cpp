#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <set>

#include "core/config/enum_words.hpp"
#include "core/config/read_config.hpp"
#include "core/config/write_config.hpp"
#include "core/mechanism/mechanism.hpp"

using namespace asperity;

namespace {

/// The ids of the project's list of mechanisms.
const std::set<std::string> kIds{"platen_friction",    "frame_compliance",    "seating",         "crack_closure",
                                 "coulomb_peak",       "curved_envelope",     "shear_softening", "slip_weakening",
                                 "rate_strengthening", "strength_scatter",    "initial_defects", "weak_plane",
                                 "eccentric_load",     "joint_wear",          "joint_mismatch",  "normal_stiffness",
                                 "block_rotation",     "out_of_plane_strips", "weak_skin",       "particle_plasticity",
                                 "mesh_size",          "loading_rate",        "damping",         "plane_condition"};

std::string config_of(ExperimentType type) {
  const std::string name(word(type));
  const std::string more = name == "triaxial"       ? ", \"confining_pressure_mpa\": 1"
                           : name == "direct_shear" ? ", \"normal_stress_mpa\": 1"
                                                    : "";
  return "{\"experiment\": {\"type\": \"" + name + "\"" + more + "}}";
}

RunConfig read(ExperimentType type, const std::string& mechanisms) {
  return parse_run_config(config_of(type), "test.json", {"/mechanisms=" + mechanisms});
}

std::vector<Fault> faults_of(ExperimentType type, const std::string& mechanisms) {
  try {
    read(type, mechanisms);
  } catch (const Error& error) {
    return error.faults();
  }
  return {};
}

constexpr std::array kTypes{ExperimentType::uniaxial, ExperimentType::triaxial, ExperimentType::brazilian,
                            ExperimentType::direct_shear};

}  // namespace

TEST_CASE("the library holds every mechanism of the list, each told in full") {
  std::set<std::string> ids;
  for (const MechanismDeclaration& m : declared_mechanisms()) {
    INFO(m.id);
    ids.insert(m.id);
    for (const std::string& text : {m.title, m.equation, m.source, m.reason, m.expectation}) CHECK(text.size() > 8);
    CHECK_FALSE(m.acts_in.empty());
    CHECK_FALSE(m.parameters.empty());
    for (const MechanismParameter& p : m.parameters) {
      INFO(p.key);
      CHECK((p.lowest <= p.strong && p.strong <= p.highest));
      CHECK(p.description.size() > 5);
    }
  }
  for (const std::string& id : kIds) CHECK(ids.contains(id));
}

TEST_CASE("every mechanism is accepted where it acts, and refused where it does nothing") {
  for (const MechanismDeclaration& m : declared_mechanisms()) {
    for (const ExperimentType type : kTypes) {
      INFO(m.id << " in " << word(type));
      const std::vector<Fault> faults = faults_of(type, "[{\"type\":\"" + m.id + "\"}]");
      CHECK(faults.empty() == acts_in(m, type));
      if (!faults.empty()) CHECK(faults.front().where == "/mechanisms/0/type");
    }
  }
}

TEST_CASE("amplitude 0 leaves the settings as they are; amplitude 1 is what holds without one; a parameter stands") {
  for (const MechanismDeclaration& m : declared_mechanisms()) {
    INFO(m.id);
    const std::string type = "{\"type\":\"" + m.id + "\"";
    const auto settings = [&](const std::string& more) {
      RunConfig config = with_mechanisms(read(m.acts_in.front(), "[" + type + more + "}]"));
      config.mechanisms.clear();
      return config;
    };
    CHECK(settings(", \"amplitude\": 0") == parse_run_config(config_of(m.acts_in.front()), "test.json"));
    CHECK(settings("") == settings(", \"amplitude\": 1"));
    for (const MechanismParameter& p : m.parameters) {
      const auto values = mechanism_values(m, {m.id, 0.5, {{p.key, p.strong}}});
      CHECK(values.at(p.key) == p.strong);
    }
  }
}

TEST_CASE("two mechanisms set the same in either order") {
  for (const MechanismDeclaration& a : declared_mechanisms()) {
    for (const MechanismDeclaration& b : declared_mechanisms()) {
      const auto both = std::find_if(kTypes.begin(), kTypes.end(),
                                     [&](ExperimentType type) { return acts_in(a, type) && acts_in(b, type); });
      if (a.id >= b.id || both == kTypes.end()) continue;
      INFO(a.id << " and " << b.id);
      const auto settings = [&](const std::string& first, const std::string& second) {
        RunConfig config = with_mechanisms(read(
            *both, "[{\"type\":\"" + first + "\",\"amplitude\":0.5},{\"type\":\"" + second + "\",\"amplitude\":0.5}]"));
        config.mechanisms.clear();
        return config;
      };
      CHECK(settings(a.id, b.id) == settings(b.id, a.id));
    }
  }
}

TEST_CASE(
    "a configuration with mechanisms is written and read back to the same one, and another amplitude is another run") {
  for (const MechanismDeclaration& m : declared_mechanisms()) {
    const RunConfig config = read(m.acts_in.front(), "[{\"type\":\"" + m.id + "\", \"amplitude\": 0.75}]");
    CHECK(parse_run_config(effective_json(config), "test.json") == config);
    CHECK(config_hash(config) != config_hash(read(m.acts_in.front(), "[{\"type\":\"" + m.id + "\"}]")));
  }
}

TEST_CASE("half an amplitude is half of the way, or half of the inverse") {
  const MechanismDeclaration& friction = *find_mechanism("platen_friction");
  CHECK(mechanism_values(friction, {"platen_friction", 0.5, {}}).at("friction_coefficient") == Approx(0.15));
  const MechanismDeclaration& frame = *find_mechanism("frame_compliance");
  const double strong = frame.parameters.front().strong;
  CHECK(mechanism_values(frame, {"frame_compliance", 0.5, {}}).at("stiffness_n_per_mm") == Approx(2.0 * strong));
}

TEST_CASE("faults of a list name the place, what is allowed and what may be meant") {
  const auto one = [](const std::string& list) {
    const std::vector<Fault> faults = faults_of(ExperimentType::uniaxial, list);
    REQUIRE(faults.size() == 1);
    return faults.front();
  };
  CHECK(one(R"([{"type":"platen_fiction"}])").hint == "did you mean \"platen_friction\"?");
  CHECK(one(R"([{"type":"platen_friction","friction_coeficient":0.1}])").hint.find("friction_coefficient") !=
        std::string::npos);
  CHECK(one(R"([{"type":"platen_friction","weibull_modulus":3}])").what.find("platen_friction") != std::string::npos);
  CHECK(one(R"([{"type":"curved_envelope","exponent":1.5}])").where == "/mechanisms/0/exponent");
  CHECK(one(R"([{"type":"initial_defects","amplitude":8}])").where == "/mechanisms/0/amplitude");
  CHECK(one(R"([{"type":"curved_envelope","amplitude":2}])").what.find("exponent") != std::string::npos);
  CHECK(one(R"([{"type":"damping"},{"type":"damping"}])").where == "/mechanisms/1/type");
  CHECK(one(R"([{"amplitude":1}])").what == "is missing");
}

TEST_CASE("a mechanism that would leave a setting out of range is refused with its name") {
  CHECK_THROWS_AS(with_mechanisms(parse_run_config(
                      R"({"experiment": {"type": "uniaxial", "width_mm": 10, "height_mm": 20},
                          "particles": {"edge_mm": 4.9}, "mechanisms": [{"type": "mesh_size", "edge_factor": 2}]})",
                      "test.json")),
                  Error);
}

TEST_CASE("the page on own mechanisms shows a file that is compiled, and that enters itself") {
  const auto text_of = [](const std::string& path) {
    std::ifstream file(std::string(ASPERITY_SOURCE_DIR) + path);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string code = text_of("/tests/unit/mechanism/settled_casting.cpp");
  REQUIRE(code.size() > 500);
  CHECK(text_of("/docs/own_mechanism.md").find("```cpp\n" + code + "```") != std::string::npos);
  CHECK(find_mechanism("settled_casting"));
  CHECK(read(ExperimentType::uniaxial, R"([{"type":"settled_casting","gradient":0.2}])").mechanisms.size() == 1);
}
