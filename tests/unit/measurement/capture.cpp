#include "core/measurement/capture.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/measurement/small_specimen.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

/// Two squares, the right one moved away and the upright contact between them broken.
struct Scene {
  RunConfig config;
  System system;
  std::vector<Sample> samples;

  Scene() {
    SmallSpecimen s = small_specimen(2, 1, 2.0);
    break_contact(s.contacts, contact_between(s.contacts, 0, 3), BreakMode::tension, 0.5, 0.125);
    for (int t : {2, 3}) {
      for (int node : s.particles.triangles[t]) s.particles.position[node] += {0.5, 0.0};
    }
    s.particles.position[s.particles.triangles[0][0]] += {0.01, 0.02};  // some stress in the first triangle
    s.particles.velocity[3] = {1.0, 2.0};
    config.name = "scene";
    config.experiment.type = ExperimentType::triaxial;
    config.experiment.thickness_mm = 10.0;
    system.particles = std::move(s.particles);
    system.contacts = std::move(s.contacts);
    system.time = 0.75;
    system.flank.pressure = 0.5;
    system.platens.y = {0.25, 1.75};
    system.platens.jaw = {3.0, 0.5, 1.0, 0.2};
    for (int i = 0; i < 3; ++i) add_sample(0.001 * i, 2.0 * i);
  }

  void add_sample(double strain, double stress) {
    Sample s;
    s.axial_strain = strain;
    s.lateral_strain = 0.25 * strain;
    s.stress_mpa = stress;
    samples.push_back(s);
  }

  Frame frame() const { return capture_frame(system, config, samples, 7); }
};

}  // namespace

TEST_CASE("a frame names its instant and the curve up to it") {
  const Frame f = Scene().frame();
  CHECK(f.index == 7);
  CHECK(f.time_s == 0.75);
  CHECK(f.experiment == "triaxial");
  CHECK(f.name == "scene");
  CHECK(f.axial_strain == 0.002);
  CHECK(f.stress_mpa == 4.0);
  CHECK(f.confining_pressure_mpa == 0.5);
  CHECK(f.platen_y == std::array<double, 2>{0.25, 1.75});
  CHECK(f.jaws == FrameJaws{3.0, 0.5, 1.0});
  CHECK(f.curve.axial_strain == std::vector<double>{0, 0.001, 0.002});
  CHECK(f.curve.lateral_strain == std::vector<double>{0, 0.00025, 0.0005});
  CHECK(f.curve.stress_mpa == std::vector<double>{0, 2, 4});
}

TEST_CASE("a frame's arrays have an entry for every node and triangle") {
  const Scene scene;
  const Frame f = scene.frame();
  const std::size_t nodes = scene.system.particles.node_count();
  const std::size_t triangles = scene.system.particles.triangle_count();
  CHECK(f.position.size() == nodes);
  CHECK(f.displacement.size() == nodes);
  CHECK(f.velocity.size() == nodes);
  CHECK(f.triangles.size() == triangles);
  CHECK(f.stress.size() == triangles);
  CHECK(f.damage.size() == triangles);
  CHECK(f.grain.size() == triangles);
  CHECK(f.fragment.size() == triangles);
}

TEST_CASE("displacement leads from the present position back to the reference") {
  const Scene scene;
  const Frame f = scene.frame();
  for (std::size_t i = 0; i < f.position.size(); ++i) {
    CHECK(norm(f.position[i] - f.displacement[i] - scene.system.particles.reference(i)) < 1e-15);  // rounding at 2 mm
  }
  CHECK(f.velocity[3] == Vec2{1.0, 2.0});
}

TEST_CASE("a frame shows the particles' stresses, fragments and damage") {
  const Scene scene;
  const Frame f = scene.frame();
  for (std::size_t t = 0; t < f.stress.size(); ++t) CHECK(f.stress[t] == triangle_stress(scene.system.particles, t));
  CHECK(f.stress[0] != std::array<double, 4>{0, 0, 0, 0});
  CHECK(f.fragment == std::vector<int>{0, 0, 1, 1});
  // The broken edge is one of two around the lower left triangle and one of two around the upper right one.
  CHECK(f.damage == std::vector<double>{0.5, 0.0, 0.0, 0.5});
}

TEST_CASE("a frame's cracks lie at their present place, with the energy of the whole thickness") {
  const Frame f = Scene().frame();
  REQUIRE(f.cracks.size() == 1);
  CHECK(f.cracks[0].mode == CrackMode::tension);
  CHECK(f.cracks[0].break_time_s == 0.5);
  CHECK(0.5 * (f.cracks[0].a + f.cracks[0].b) == Vec2{0.25, 1.0});
  CHECK(f.cracks[0].energy_n_mm == 0.125 * 2.0 * 10.0);
}

TEST_CASE("before the first sample a frame has no curve and no load") {
  const Scene scene;
  const Frame f = capture_frame(scene.system, scene.config, {}, 0);
  CHECK(f.curve.stress_mpa.empty());
  CHECK(f.stress_mpa == 0.0);
}

TEST_CASE("experiments have the names of the configuration") {
  CHECK(std::string(experiment_name(ExperimentType::uniaxial)) == "uniaxial");
  CHECK(std::string(experiment_name(ExperimentType::triaxial)) == "triaxial");
  CHECK(std::string(experiment_name(ExperimentType::brazilian)) == "brazilian");
}
