#include "core/experiment/checkpoint.hpp"

#include <catch2/catch.hpp>
#include <cstddef>
#include <cstring>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/base/sha256.hpp"
#include "tests/unit/experiment/small_models.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace fs = std::filesystem;

namespace {

const std::string kHash(32, 'a');

/// A test and where it stands.
struct Run {
  Model model;
  RunState state;

  explicit Run(const RunConfig& config) : model(small_model(config)) { state = start_run(model); }

  /// Goes on for so many steps, or to the end.
  void go_on(int steps = -1) {
    RunObserver observer;
    observer.interrupted = [&] { return --steps == 0; };
    run_experiment(model, state, ParallelLoops(), observer);
  }
};

fs::path scratch_file(const std::string& name) {
  const fs::path folder = fs::path(ASPERITY_TEST_SCRATCH) / "experiment";
  fs::create_directories(folder);
  return folder / name;
}

/// A run broken off in the middle, with its checkpoint.
Run broken_off(const RunConfig& config, int steps, const fs::path& file) {
  Run run(config);
  run.go_on(steps);
  REQUIRE(run.state.stop == StopReason::interrupted);
  write_checkpoint(file, run.model, run.state, kHash);
  return run;
}

Run restored(const RunConfig& config, const fs::path& file) {
  Run run(config);
  read_checkpoint(file, run.model, run.state, kHash);
  return run;
}

bool same_bits(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec2)) == 0;
}

/// Padding follows the last count.
bool same_bits(const Sample& a, const Sample& b) {
  const std::size_t counted = offsetof(Sample, contacts_softening) + sizeof a.contacts_softening;
  return std::memcmp(&a, &b, counted) == 0 && std::memcmp(&a.energy, &b.energy, sizeof a.energy) == 0;
}

void check_same_points(const BondedContacts& a, const BondedContacts& b) {
  for (std::size_t c = 0; c < a.size(); ++c) {
    for (int q = 0; q < 2; ++q) {
      const PointState s = a.points(c)[q], t = b.points(c)[q];
      REQUIRE(std::memcmp(&s, &t, offsetof(PointState, broken)) == 0);  // what follows is padding but for `broken`
      REQUIRE(s.broken == t.broken);
    }
  }
  CHECK(a.broken_index == b.broken_index);
  for (std::size_t c = 0; c < a.size(); ++c) CHECK(a.break_time(c) == b.break_time(c));
}

void check_same(const Run& a, const Run& b) {
  CHECK(a.model.system.step == b.model.system.step);
  CHECK(a.model.system.time == b.model.system.time);
  CHECK(same_bits(a.model.system.particles.position, b.model.system.particles.position));
  CHECK(same_bits(a.model.system.particles.velocity, b.model.system.particles.velocity));
  check_same_points(a.model.system.contacts, b.model.system.contacts);
  REQUIRE(a.state.samples.size() == b.state.samples.size());
  for (std::size_t i = 0; i < a.state.samples.size(); ++i) {
    REQUIRE(same_bits(a.state.samples[i], b.state.samples[i]));
  }
  CHECK(a.state.frames == b.state.frames);
  CHECK(a.state.loading.phase == b.state.loading.phase);
  CHECK(a.state.loading.stages == b.state.loading.stages);
}

void check_round_trip(const RunConfig& config, int steps, const std::string& name) {
  const fs::path file = scratch_file(name);
  const Run broken = broken_off(config, steps, file);
  Run resumed = restored(config, file);
  check_same(resumed, broken);
  resumed.go_on();
  Run whole(config);
  whole.go_on();
  CHECK(whole.model.system.step > steps);
  check_same(resumed, whole);
  CHECK(resumed.state.stop == whole.state.stop);
}

RunConfig short_disc() {
  RunConfig config = weak_disc();
  config.experiment.stop.axial_strain = 0.012;
  return config;
}

/// Expects that the file is refused with this word, and that model and state stay as they were.
void check_refused(const fs::path& file, const std::string& word, const std::string& hash = kHash) {
  Run run(short_disc());
  run.go_on(3);
  const Run before = run;
  try {
    read_checkpoint(file, run.model, run.state, hash);
    FAIL("accepted");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::output);
    CHECK(std::string(error.what()).find(word) != std::string::npos);
    CHECK(std::string(error.what()).find(file.string()) != std::string::npos);
  }
  check_same(run, before);
}

}  // namespace

TEST_CASE("a disc goes on from a checkpoint among cracks to the same bits") {
  const RunConfig config = short_disc();
  Run whole(config);
  whole.go_on();
  REQUIRE(whole.state.samples.back().cracks_tension + whole.state.samples.back().cracks_shear > 0);
  const int steps = static_cast<int>(0.9 * static_cast<double>(whole.model.system.step));
  check_round_trip(config, steps, "disc.bin");
}

TEST_CASE("a crushed specimen under pressure goes on from a checkpoint among general contacts to the same bits") {
  const RunConfig config = crushed_triaxial();
  const int steps = 8000;
  const fs::path file = scratch_file("crushed.bin");
  const Run broken = broken_off(config, steps, file);
  REQUIRE(broken.model.system.general.touches.size() > 3);
  REQUIRE_FALSE(broken.model.system.general.handing_over.empty());
  check_round_trip(config, steps, "crushed.bin");
}

TEST_CASE("a triaxial test goes on from a checkpoint in its hydrostatic stage to the same bits") {
  RunConfig config = small_config(ExperimentType::triaxial);
  config.experiment.confining_pressure_mpa = 0.5;
  config.experiment.loading.closing_rate_mm_per_s = 800;
  config.experiment.loading.confinement_time_s = 3e-4;
  config.experiment.stop.axial_strain = 0.004;
  check_round_trip(config, 200, "triaxial.bin");
}

TEST_CASE("a staged test goes on from a checkpoint in a hold to the same bits") {
  RunConfig config = weak_disc();
  config.experiment.loading.mode = LoadingMode::staged;
  config.experiment.loading.hold_time_s = 1e-4;
  config.experiment.stop.axial_strain = 0.1 / 54;
  check_round_trip(config, 150, "staged.bin");
}

TEST_CASE("a run goes on from a checkpoint after any step to the same bits") {
  RunConfig config = short_disc();
  config.experiment.stop.axial_strain = 0.0015;
  config.measurement.samples = 12;
  Run whole(config);
  std::vector<std::string> after_step;
  RunObserver observer;
  observer.checkpoint_due = [] { return true; };
  observer.write_checkpoint = [&] { after_step.push_back(checkpoint_bytes(whole.model, whole.state, kHash)); };
  run_experiment(whole.model, whole.state, ParallelLoops(), observer);
  REQUIRE(after_step.size() == static_cast<std::size_t>(whole.model.system.step));
  REQUIRE(after_step.size() > 100);
  Run resumed(config);
  for (const std::string& bytes : after_step) {
    read_checkpoint_bytes(bytes, "bytes", resumed.model, resumed.state, kHash);
    resumed.go_on();
    check_same(resumed, whole);
  }
}

TEST_CASE("a controlled test with an elastic start and scaled masses goes on from a checkpoint to the same bits") {
  RunConfig config = small_config(ExperimentType::triaxial);
  config.experiment.confining_pressure_mpa = 0.5;
  config.experiment.loading.closing_rate_mm_per_s = 200;
  config.experiment.loading.confinement_time_s = 3e-4;
  config.experiment.loading.rate_control.enabled = true;
  config.experiment.loading.elastic_start_fraction = 0.2;
  config.integration.mass_scaling.uniform = true;
  config.experiment.stop.axial_strain = 0.012;
  check_round_trip(config, 200, "before_start.bin");
  Run run(config);
  int steps = 0;
  RunObserver observer;
  observer.interrupted = [&] { return run.state.loading.elastic_start.increments > 0 && ++steps == 200; };
  run_experiment(run.model, run.state, ParallelLoops(), observer);
  REQUIRE(run.state.stop == StopReason::interrupted);
  check_round_trip(config, static_cast<int>(run.model.system.step), "after_start.bin");
}

TEST_CASE("a torn or changed checkpoint is refused and changes nothing") {
  const fs::path file = scratch_file("torn.bin");
  broken_off(short_disc(), 500, file);
  const std::string whole = read_file(file);
  for (std::size_t length : {std::size_t{0}, std::size_t{10}, whole.size() / 2, whole.size() - 1}) {
    write_file_atomically(file, whole.substr(0, length));
    check_refused(file, length < 60 ? "no checkpoint of this version" : "damaged");
  }
  std::string flipped = whole;
  flipped[whole.size() / 3] = static_cast<char>(flipped[whole.size() / 3] ^ 1);
  write_file_atomically(file, flipped);
  check_refused(file, "damaged");
}

TEST_CASE("another configuration's checkpoint is refused and changes nothing") {
  const fs::path file = scratch_file("foreign.bin");
  broken_off(short_disc(), 500, file);
  check_refused(file, "another configuration", std::string(32, 'b'));
}

TEST_CASE("another version's checkpoint is refused and changes nothing") {
  const fs::path file = scratch_file("version.bin");
  broken_off(short_disc(), 500, file);
  std::string text = read_file(file);
  const std::size_t version = text.find('\n') - 1;
  text[version] = text[version] == '0' ? '1' : '0';
  write_file_atomically(file, text);
  check_refused(file, "no checkpoint of this version");
}

TEST_CASE("a state of another layout or mesh is refused though its checksum holds") {
  const fs::path file = scratch_file("forged.bin");
  const Run run = broken_off(short_disc(), 500, file);
  const std::string whole = read_file(file);
  const std::size_t body = whole.find('\n') + 1 + 64;  // after the version's line and the checksum's hexadecimal digits
  const auto forge = [&](const std::string& changed) {
    write_file_atomically(file, whole.substr(0, body - 64) + sha256_hex(changed) + changed);
  };
  forge(whole.substr(body));
  CHECK(restored(short_disc(), file).model.system.step == run.model.system.step);
  forge(whole.substr(body, whole.size() - body - 1));
  check_refused(file, "ends early");
  forge(whole.substr(body) + "x");
  check_refused(file, "is longer than its state");
  std::string other_size = whole.substr(body);
  other_size[kHash.size()] = 4;  // the first value's size, 8 bytes
  forge(other_size);
  check_refused(file, "was written by other code");
  std::string huge = whole.substr(body);
  const std::size_t count = huge.rfind(std::string("\x08\0\0\0\0\0\0\0", 8));
  huge.replace(count + 8, 8, 8, '\xff');
  forge(huge);
  check_refused(file, "holds a list where one value is expected");
  RunConfig coarser = short_disc();
  coarser.particles.edge_mm = 6;
  broken_off(coarser, 100, file);
  check_refused(file, "belongs to another mesh");
}

TEST_CASE("a checkpoint keeps why a run ended and what it has cost") {
  RunConfig config = short_disc();
  config.experiment.stop.axial_strain = 0.001;
  Run run(config);
  run.go_on();
  REQUIRE(run.state.stop == StopReason::strain);
  run.state.cost = {1.5, 0.25};
  const fs::path file = scratch_file("ended.bin");
  write_checkpoint(file, run.model, run.state, kHash);
  Run resumed = restored(config, file);
  CHECK(resumed.state.stop == StopReason::strain);
  CHECK(resumed.state.cost.compute_s == 1.5);
  CHECK(resumed.state.cost.output_s == 0.25);
  resumed.go_on();
  check_same(resumed, run);
}

TEST_CASE("a checkpoint that is not there is an output error") {
  Run run(short_disc());
  CHECK_THROWS_AS(read_checkpoint(scratch_file("no_such_file.bin"), run.model, run.state, kHash), Error);
}

TEST_CASE("a new checkpoint replaces the old one") {
  const fs::path file = scratch_file("replaced.bin");
  broken_off(short_disc(), 100, file);
  const Run later = broken_off(short_disc(), 300, file);
  CHECK(restored(short_disc(), file).model.system.step == later.model.system.step);
}
