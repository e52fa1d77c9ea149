#include <catch2/catch.hpp>

#include "core/config/applicability.hpp"
#include "core/config/bindings.hpp"
#include "core/config/cross_checks.hpp"
#include "core/config/estimates.hpp"
#include "core/config/schema_lookup.hpp"
#include "fault_finder.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

/// The only fault of a text with one override; an empty one if there is none or more than one.
Fault only_fault(const std::string& text, const std::string& override_text) {
  const Refusal r = refusal(text, {override_text});
  return r.faults.size() == 1 && r.kind == ErrorKind::config ? r.faults.front() : Fault{};
}

const std::string kVoronoi = R"({"experiment": {"type": "uniaxial"}, "particles": {"kind": "voronoi"}})";

}  // namespace

TEST_CASE("a disc has no confining pressure, width, height, confinement time, gauges or modulus") {
  for (const char* item :
       {"/experiment/confining_pressure_mpa=0.5", "/experiment/confining_pressure_mpa=0", "/experiment/width_mm=54",
        "/experiment/height_mm=130", "/experiment/loading/confinement_time_s=0.001", "/measurement/axial_gauge_mm=60",
        "/measurement/lateral_gauge_mm=20", "/measurement/modulus_window=[0.2, 0.5]"}) {
    INFO(item);
    const Fault fault = only_fault(kDisc, item);
    CHECK(fault.where + "=" == std::string(item).substr(0, fault.where.size() + 1));
    CHECK(fault.what == "has no meaning when /experiment/type is \"brazilian\"");
    CHECK_FALSE(fault.value.empty());
    CHECK_FALSE(fault.allowed.empty());
    CHECK_FALSE(fault.hint.empty());
  }
  const Fault pressure = only_fault(kDisc, "/experiment/confining_pressure_mpa=0.5");
  CHECK(pressure.value == "0.5");
  CHECK(pressure.allowed == "only in a triaxial test");
  CHECK(contains(pressure.hint, "set /experiment/type to \"triaxial\""));
}

TEST_CASE("uniaxial compression has no confining pressure, diameter or ramp") {
  CHECK(only_fault(kUniaxial, "/experiment/confining_pressure_mpa=1").where == "/experiment/confining_pressure_mpa");
  CHECK(only_fault(kUniaxial, "/experiment/diameter_mm=54").hint == "compression has width_mm and height_mm");
  CHECK(only_fault(kTriaxial, "/experiment/diameter_mm=54").allowed == "only for a Brazilian disc");
  CHECK(only_fault(kUniaxial, "/experiment/loading/ramp_time_s=0.001").where == "/experiment/loading/ramp_time_s");
  CHECK(only_fault(kUniaxial, "/experiment/loading/confinement_time_s=0.001").allowed ==
        "only in triaxial tests and direct shear");
}

TEST_CASE("stages have no rate control and no elastic start") {
  for (const char* item :
       {"/experiment/loading/rate_control/enabled=true", "/experiment/loading/rate_control/fastest_rate_factor=8",
        "/experiment/loading/elastic_start_fraction=0.5"}) {
    INFO(item);
    const Refusal r = refusal(kDisc, {"/experiment/loading/mode=staged", item});
    REQUIRE(r.faults.size() == 1);
    CHECK(r.faults.front().where + "=" == std::string(item).substr(0, r.faults.front().where.size() + 1));
    CHECK(r.faults.front().allowed == "only in continuous loading");
    CHECK(contains(r.faults.front().hint, "continuous"));
    CHECK(refusal(kDisc, {item}).faults.empty());
  }
}

TEST_CASE("an elastic start has frictionless platens") {
  const std::string start = "/experiment/loading/elastic_start_fraction=0.5";
  const Refusal r = refusal(kUniaxial, {start, "/experiment/platens/friction_coefficient=0.2"});
  REQUIRE(r.faults.size() == 1);
  CHECK(r.faults.front().where == "/experiment/loading/elastic_start_fraction");
  CHECK(r.faults.front().value == "0.5");
  CHECK(refusal(kUniaxial, {start}).faults.empty());
  CHECK(only_fault(kUniaxial, "/experiment/loading/elastic_start_fraction=0.95").where ==
        "/experiment/loading/elastic_start_fraction");
}

TEST_CASE("only a disc has jaws, only jaws have a radius, and it is above the disc's") {
  const std::string curved = "/experiment/platens/shape=curved", radius = "/experiment/platens/jaw_radius_mm=";
  CHECK_FALSE(refusal(kDisc, {curved}).kind);
  CHECK_FALSE(refusal(kDisc, {curved, radius + "27.1"}).kind);
  CHECK(only_fault(kUniaxial, curved).allowed == "only for a Brazilian disc");
  CHECK(only_fault(kUniaxial, "/experiment/platens/shape=flat").where == "/experiment/platens/shape");
  const Fault flat = only_fault(kDisc, radius + "40");
  CHECK(flat.what == "has no meaning when /experiment/platens/shape is \"flat\"");
  CHECK(contains(flat.hint, "curved"));
  const Refusal narrow = refusal(kDisc, {curved, radius + "27"});
  REQUIRE(narrow.faults.size() == 1);
  CHECK(narrow.faults[0].where == "/experiment/platens/jaw_radius_mm");
  CHECK(narrow.faults[0].value == "27");
  CHECK(narrow.faults[0].allowed == "above the disc's radius, 27 mm");
  CHECK(parse_run_config(kDisc, "x.json", {curved}).experiment.jaw_radius() == 40.5);
}

TEST_CASE("masses are scaled to a given step or to a uniform one, not both") {
  const Refusal r =
      refusal(kUniaxial, {"/integration/mass_scaling/uniform=true", "/integration/mass_scaling_time_step_s=5e-7"});
  REQUIRE(r.faults.size() == 1);
  CHECK(r.faults.front().where == "/integration/mass_scaling_time_step_s");
  CHECK(refusal(kUniaxial, {"/integration/mass_scaling/uniform=true"}).faults.empty());
}

TEST_CASE("a triaxial test needs a confining pressure") {
  const Fault fault = only_fault(kTriaxial, "/experiment/confining_pressure_mpa=0");
  CHECK(fault.where == "/experiment/confining_pressure_mpa");
  CHECK(fault.allowed == "above 0 MPa");
  CHECK(fault.value == "0");
  CHECK(refusal(R"({"experiment": {"type": "triaxial"}})").at("/experiment/confining_pressure_mpa").allowed ==
        "above 0 MPa");
  CHECK_FALSE(refusal(kTriaxial).kind);
}

TEST_CASE("staged keys need staged loading, and the ramp continuous loading") {
  for (const char* item : {"/experiment/loading/stage_displacement_mm=0.01",
                           "/experiment/loading/hold_kinetic_ratio=1e-3", "/experiment/loading/hold_time_s=1e-3"}) {
    INFO(item);
    CHECK(only_fault(kDisc, item).what == "has no meaning when /experiment/loading/mode is \"continuous\"");
    CHECK_FALSE(refusal(kDisc, {item, "/experiment/loading/mode=staged"}).kind);
  }
  CHECK_FALSE(refusal(kTriaxial, {"/experiment/loading/hold_kinetic_ratio=1e-3"}).kind);  // its confinement holds, too
  CHECK(only_fault(kTriaxial, "/experiment/loading/hold_time_s=1e-3").allowed == "only in staged loading");
  CHECK_FALSE(refusal(kDisc, {"/experiment/loading/ramp_time_s=1e-3"}).kind);
  const Refusal ramp = refusal(kDisc, {"/experiment/loading/ramp_time_s=1e-3", "/experiment/loading/mode=staged"});
  CHECK(ramp.at("/experiment/loading/ramp_time_s").what ==
        "has no meaning when /experiment/loading/mode is \"staged\"");
  CHECK(refusal(kUniaxial, {"/experiment/loading/ramp_time_s=1e-3", "/experiment/loading/mode=staged"}).faults.size() ==
        1);
}

TEST_CASE("the edge is at most a fifth of the specimen's smallest dimension") {
  const Fault fault = only_fault(kDisc, "/particles/edge_mm=500");
  CHECK(fault.where == "/particles/edge_mm");
  CHECK(fault.what == "is too long for the specimen");
  CHECK(fault.value == "500");
  CHECK(contains(fault.allowed, "at most 10.8 mm"));
  CHECK_FALSE(refusal(kDisc, {"/particles/edge_mm=10.8"}).kind);
  CHECK(only_fault(kDisc, "/particles/edge_mm=10.81").where == "/particles/edge_mm");
  CHECK_FALSE(refusal(kUniaxial, {"/experiment/width_mm=10", "/particles/edge_mm=2"}).kind);
  CHECK(refusal(kUniaxial, {"/experiment/width_mm=9.9"}).at("/particles/edge_mm").value == "2");
  CHECK(refusal(kUniaxial,
                {"/experiment/height_mm=9.9", "/measurement/axial_gauge_mm=5", "/measurement/lateral_gauge_mm=5"})
            .at("/particles/edge_mm")
            .value == "2");
}

TEST_CASE("more triangles than a machine holds are refused") {
  const Refusal r = refusal(kDisc, {"/particles/edge_mm=0.001", "/particles/edge_deviation_mm=0.0001"});
  REQUIRE(r.faults.size() == 1);
  CHECK(contains(r.faults[0].what, "makes about 5.29e+09 triangles"));  // pi/4 54^2 / (0.433 * 1e-6)
  CHECK(r.faults[0].where == "/particles/edge_mm");
}

TEST_CASE("edges scatter by less than 30 % of their length") {
  CHECK_FALSE(refusal(kDisc, {"/particles/edge_deviation_mm=0.59"}).kind);
  const Fault fault = only_fault(kDisc, "/particles/edge_deviation_mm=0.6");
  CHECK(fault.where == "/particles/edge_deviation_mm");
  CHECK(contains(fault.allowed, "below 0.6 mm"));
}

TEST_CASE("Voronoi grains hold several triangles and the specimen several grains; triangles have no grain size") {
  CHECK_FALSE(refusal(kVoronoi, {"/particles/grain_size_mm=3"}).kind);
  CHECK(contains(only_fault(kVoronoi, "/particles/grain_size_mm=2.9").allowed, "at least 3 mm"));
  CHECK_FALSE(refusal(kVoronoi, {"/particles/grain_size_mm=18"}).kind);
  CHECK(contains(only_fault(kVoronoi, "/particles/grain_size_mm=18.1").allowed, "at most 18 mm"));
  const Fault fault = only_fault(kUniaxial, "/particles/grain_size_mm=5");
  CHECK(fault.what == "has no meaning when /particles/kind is \"triangle\"");
  CHECK(contains(fault.hint, "voronoi"));
}

TEST_CASE("only the default law has forms") {
  CHECK_FALSE(refusal(kDisc, {"/contacts/law/form=cohesive_frictional"}).kind);
  const Fault fault = only_fault(kDisc, R"(/contacts/law={"reading": "literal", "form": "cohesive_frictional"})");
  CHECK(fault.where == "/contacts/law/form");
  CHECK(fault.what == "has no meaning when /contacts/law/reading is \"literal\"");
  CHECK(contains(fault.hint, "default"));
}

TEST_CASE("the modulus window has its low end below its high end") {
  const Fault fault = only_fault(kUniaxial, "/measurement/modulus_window=[0.5, 0.5]");
  CHECK(fault.where == "/measurement/modulus_window");
  CHECK(fault.value == "[0.5,0.5]");
  CHECK_FALSE(refusal(kUniaxial, {"/measurement/modulus_window=[0.1, 0.5]"}).kind);
}

TEST_CASE("gauges fit on the specimen") {
  CHECK_FALSE(refusal(kUniaxial, {"/measurement/axial_gauge_mm=130", "/measurement/lateral_gauge_mm=130"}).kind);
  CHECK(only_fault(kUniaxial, "/measurement/axial_gauge_mm=130.5").allowed == "at most height_mm 130 mm");
  CHECK(only_fault(kUniaxial, "/measurement/lateral_gauge_mm=131").where == "/measurement/lateral_gauge_mm");
}

TEST_CASE("the fracture energy covers the hardening branch") {
  const Fault given = only_fault(kDisc, "/contacts/fracture_energy_n_per_mm=0.03");
  CHECK(given.where == "/contacts/fracture_energy_n_per_mm");
  CHECK(given.value == "0.03");
  CHECK(contains(given.allowed, "at least 0.037 N/mm"));  // e (e - 2) 6.89^2 / 2503.7
  CHECK_FALSE(refusal(kDisc, {"/contacts/fracture_energy_n_per_mm=0.038"}).kind);
  const Fault derived = only_fault(kDisc, "/contacts/tensile_strength_mpa=40");
  CHECK(derived.where == "/contacts/fracture_energy_n_per_mm");
  CHECK(derived.value == "0.623 from the material (Eq 34)");
}

TEST_CASE("a time step above twice the estimated critical one is refused") {
  CHECK_FALSE(refusal(kUniaxial, {"/integration/time_step_s=4e-7"}).kind);
  const Fault fault = only_fault(kUniaxial, "/integration/time_step_s=1e-6");
  CHECK(fault.where == "/integration/time_step_s");
  CHECK(fault.what == "is above the stable time step");
  CHECK(fault.value == "1e-06");
  CHECK(contains(fault.allowed, "up to about 4.8"));
  CHECK_FALSE(refusal(kUniaxial, {"/integration/time_step_s=1e-6", "/integration/mass_scaling_time_step_s=1e-6"}).kind);
  CHECK_FALSE(refusal(kUniaxial, {"/integration/time_step_s=1e-6", "/particles/density_kg_per_m3=4800"}).kind);
}

TEST_CASE("the estimates have the paper's stiffnesses and the audit's time step") {
  RunConfig config;
  CHECK(estimated_tensile_stiffness(config) == Approx(2503.7).epsilon(1e-4));  // Eq 12 at beta = 0.25, recomputed
  CHECK(estimated_fracture_energy(config) == Approx(0.62308).epsilon(1e-4));   // 0.9^2 * 1000 / 1300
  config.experiment.plane = PlaneCondition::strain;
  CHECK(estimated_tensile_stiffness(config) == Approx(2608.0).epsilon(1e-4));  // Eq 13
  CHECK(estimated_critical_step(config) == Approx(4.9e-7).epsilon(0.03));  // the audit's power iteration, two digits
  config.contacts.shear_stiffness_mpa_per_mm = 4 * 2608.0;
  CHECK(estimated_critical_step(config) == Approx(4.9e-7 / 2).epsilon(0.06));
  config.contacts.tensile_stiffness_mpa_per_mm = 100.0;
  config.contacts.fracture_energy_n_per_mm = 0.5;
  CHECK(estimated_tensile_stiffness(config) == 100.0);
  CHECK(estimated_fracture_energy(config) == 0.5);
}

TEST_CASE("a RunConfig made in code is checked without notes") {
  RunConfig config;
  CHECK(cross_check(config).empty());
  config.experiment.width_mm = 40.0;
  CHECK(cross_check(config).at(0).where == "/experiment/width_mm");
  config = {};
  config.measurement.modulus_window_low = 0.9;
  config.experiment.type = ExperimentType::uniaxial;
  CHECK(cross_check(config).at(0).value == "[0.9,0.5]");
}

TEST_CASE("conditional keys and their deciders are keys") {
  for (const ConditionalKey& key : conditional_keys()) {
    CHECK(schema_at(parsed_schema("run"), std::string(key.pointer)));
    CHECK(schema_at(parsed_schema("run"), std::string(key.decided_by)));
    const auto bound = [&](const Binding& binding) { return binding.pointer == key.pointer; };
    CHECK(std::any_of(bindings().begin(), bindings().end(), bound));
  }
}

TEST_CASE("pointers overlap at whole tokens") {
  CHECK(pointers_overlap("/a/b", "/a/b"));
  CHECK(pointers_overlap("/a", "/a/b"));
  CHECK(pointers_overlap("/a/b", "/a"));
  CHECK_FALSE(pointers_overlap("/a/b", "/a/bc"));
  CHECK_FALSE(pointers_overlap("/a/b", "/a/c"));
}

TEST_CASE("edges too equal for an irregular arrangement are refused, and left out they are a tenth of the edge") {
  CHECK_FALSE(refusal(kDisc, {"/particles/edge_mm=5"}).kind);
  const Fault fault = only_fault(kDisc, "/particles/edge_deviation_mm=0.1");
  CHECK(fault.where == "/particles/edge_deviation_mm");
  CHECK_THAT(fault.allowed, Catch::Contains("7 %"));
}
