#include <catch2/catch.hpp>

#include "fault_finder.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE("an override is JSON or a bare string, and the last one wins") {
  const RunConfig config = parse_run_config(
      kDisc, "x.json",
      {"/particles/edge_mm=1.5", "/experiment/type=uniaxial", "/particles/seed=3", "/particles/seed=4",
       R"(/output/fields=["damage"])", R"(/contacts/law={"reading": "literal"})", "/description=a = b"});
  CHECK(config.particles.edge_mm == 1.5);
  CHECK(config.experiment.type == ExperimentType::uniaxial);
  CHECK(config.experiment.plane == PlaneCondition::strain);
  CHECK(config.particles.seed == 4);
  CHECK(config.output.fields == std::vector<std::string>{"damage"});
  CHECK(config.contacts.law.reading == LawReading::literal);
  CHECK(config.description == "a = b");
}

TEST_CASE("an override at a pointer the schema does not know is a fault with a hint") {
  const Refusal r = refusal(kDisc, {"/experiment/diametre_mm=54", "/particle/edge_mm=2", "/edge_mm=2",
                                    "/nothing/like/it=1", "/particles/edge_mm/value=2"});
  CHECK(r.kind == ErrorKind::config);
  CHECK(r.faults.size() == 5);
  CHECK(r.at("/experiment/diametre_mm").hint == "did you mean diameter_mm?");
  CHECK(r.at("/experiment/diametre_mm").value == "54");
  CHECK(r.at("/particle/edge_mm").hint == "did you mean particles?");
  CHECK(r.at("/edge_mm").hint == "did you mean /particles/edge_mm?");
  CHECK(contains(r.at("/nothing/like/it").what, "not a key of the configuration: nothing"));
  CHECK(contains(r.at("/particles/edge_mm/value").what, "value"));
}

TEST_CASE("an override's value is checked like the file's") {
  CHECK(refusal(kDisc, {"/experiment/diameter_mm=-5"}).at("/experiment/diameter_mm").value == "-5");
  CHECK(refusal(kDisc, {"/particles/edge_mm=abc"}).at("/particles/edge_mm").value == "\"abc\"");
  CHECK(refusal(kDisc, {"/particles/edge_mm="}).at("/particles/edge_mm").what == "must be a number");
  CHECK(refusal(kDisc, {"/particles/edge_mm=1e999"}).at("/particles/edge_mm").value == "1e999");
  CHECK(refusal(kDisc, {R"(/particles={"seed": 1, "seed": 2})"}).at("/particles/seed").what == "is given twice");
  CHECK(refusal(kDisc, {"/particles/edge_mm=500"}).at("/particles/edge_mm").value == "500");
}

TEST_CASE("arrays are overridden as a whole") {
  const Refusal r = refusal(kDisc, {"/output/fields/0=damage", "/measurement/modulus_window/99999999999=0.5"});
  CHECK(r.faults.size() == 2);
  CHECK(contains(r.at("/output/fields/0").hint, "set /output/fields instead"));
  CHECK(contains(r.at("/measurement/modulus_window/99999999999").what, "inside an array"));
  const Refusal deep = refusal(kDisc, {"/joint/profile/0/angle_deg=45"});
  REQUIRE(deep.faults.size() == 1);
  CHECK(contains(deep.at("/joint/profile/0/angle_deg").hint, "set /joint/profile instead"));
}

TEST_CASE("an override below something that is no object leaves that fault to the schema") {
  const Refusal r = refusal(R"({"experiment": {"type": "brazilian"}, "particles": 5})", {"/particles/seed=3"});
  REQUIRE(r.faults.size() == 1);
  CHECK(r.at("/particles").what == "must be an object");
}

TEST_CASE("malformed overrides are usage errors, all named, whatever the file") {
  const std::vector<std::string> malformed{"particles/edge_mm=2", "/particles/edge_mm", "=3", "/a~2b=1", ""};
  const Refusal r = refusal("not JSON at all", malformed);
  CHECK(r.kind == ErrorKind::usage);
  REQUIRE(r.faults.size() == malformed.size());
  for (std::size_t i = 0; i < malformed.size(); ++i) CHECK(r.faults[i].value == malformed[i]);
  CHECK(r.faults[0].allowed == "/json/pointer=value");
  CHECK_THROWS_AS(read_run_config("no/such/file.json", {"x"}), Error);
  try {
    read_run_config("no/such/file.json", {"x"});
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::usage);
  }
}

TEST_CASE("an unknown pointer is named beside a syntax error of the file") {
  const Refusal r = refusal("{", {"/experiment/diametre_mm=54", "/particles/edge_mm=2"});
  CHECK(r.faults.size() == 2);
  CHECK(r.at("/experiment/diametre_mm").hint == "did you mean diameter_mm?");
}

TEST_CASE("bytes that are no UTF-8 do not break the messages") {
  const Refusal r = refusal(kDisc, {"/particles/edge_mm=\xff\xfe"});
  CHECK(r.at("/particles/edge_mm").what == "must be a number");
}
