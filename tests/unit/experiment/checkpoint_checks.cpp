#include "core/experiment/checkpoint_checks.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/error.hpp"
#include "core/experiment/checkpoint.hpp"
#include "tests/unit/experiment/small_models.hpp"

using namespace asperity;
using namespace asperity::testing;

/// States that no run can have, each written with a checksum that holds. What was not refused before led out of a list,
/// on for ever, or into a value its type does not have; found by tests/fuzz.
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kHuge = 1e300;
const std::string kHash(64, 'a');

struct Run {
  Model model;
  RunState state;
};

/// A specimen under pressure, crushed until its pieces touch and hand over.
const Run& crushed() {
  static const Run run = [] {
    Run r{small_model(crushed_triaxial()), {}};
    r.state = start_run(r.model);
    RunObserver observer;
    observer.interrupted = [&] { return r.model.system.step >= 6000; };
    run_experiment(r.model, r.state, ParallelLoops(), observer);
    return r;
  }();
  return run;
}

using Change = std::function<void(System&, RunState&)>;

/// What reading a checkpoint of the changed state says; empty where it is accepted.
std::string refusal(const Change& change) {
  static const Model fresh = small_model(crushed_triaxial());
  Run changed = crushed();
  change(changed.model.system, changed.state);
  const std::string bytes = checkpoint_bytes(changed.model, changed.state, kHash);
  Model model = fresh;
  RunState state;
  try {
    read_checkpoint_bytes(bytes, "state.bin", model, state, kHash);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::output);
    return error.what();
  }
  return "";
}

void check_all(const std::string& word, const std::vector<Change>& changes) {
  for (std::size_t i = 0; i < changes.size(); ++i) {
    CAPTURE(i);
    CHECK_THAT(refusal(changes[i]), Catch::StartsWith("state.bin: " + word));
  }
}

}  // namespace

TEST_CASE("a state among touches and hand-overs is accepted") {
  const GeneralContacts& general = crushed().model.system.general;
  REQUIRE(general.touches.size() > 3);
  REQUIRE(general.handing_over.size() > 1);
  REQUIRE(general.chain_contacts.size() > 1);
  REQUIRE(crushed().state.samples.size() > 3);
  CHECK(refusal([](System&, RunState&) {}).empty());
}

TEST_CASE("a checkpoint whose lists have other sizes than the mesh is refused") {
  check_all("belongs to another mesh", {
                                           [](System& s, RunState&) { s.particles.position.pop_back(); },
                                           [](System& s, RunState&) { s.particles.velocity.pop_back(); },
                                           [](System& s, RunState&) { s.platen_shear.push_back(0.0); },
                                           [](System& s, RunState&) { s.contacts.memory.packed.pop_back(); },
                                           [](System& s, RunState&) { s.contacts.broken_index.push_back(0); },
                                           [](System& s, RunState&) { s.contacts.memory.literal.resize(1); },
                                           [](System& s, RunState&) { s.contacts.broken_index.pop_back(); },
                                       });
}

TEST_CASE("platens that are none are refused") {
  check_all("holds no state of the platens",
            {
                [](System& s, RunState&) { std::memset(&s.platens.present, 7, 1); },  // no bool
                [](System& s, RunState&) { s.platens.present = false; },
                [](System& s, RunState&) { s.platens.friction = 0.5; },
                [](System& s, RunState&) { s.platens.jaw.radius = 40.0; },
                [](System& s, RunState&) { s.platens.y[1] = -kHuge; },  // pictures without end
                [](System& s, RunState&) { s.platens.y[0] = kNan; },
                [](System& s, RunState&) { s.platens.last_velocity[1] = kNan; },
            });
}

TEST_CASE("a motion that is none is refused") {
  check_all("holds no state of motion",
            {
                [](System& s, RunState&) { s.step = -1; },
                [](System& s, RunState&) { s.step = std::numeric_limits<std::int64_t>::max(); },  // overflows
                [](System& s, RunState&) { s.time = kNan; },
                [](System& s, RunState&) { s.particles.position[3].x = kNan; },  // sorted by CGAL
                [](System& s, RunState&) { s.particles.position[3].y = kHuge; },
                [](System& s, RunState&) { s.particles.velocity[0].y = kNan; },
                [](System& s, RunState&) { s.sums.reaction[0] = kNan; },
                [](System& s, RunState&) { s.external_work = kNan; },
            });
}

TEST_CASE("a confining pressure on edges that are none is refused") {
  check_all("holds no state of the confining pressure",
            {
                [](System& s, RunState&) { s.flank.edges.at(0).nodes[0] = -1; },
                [](System& s, RunState&) { s.flank.edges.at(0).nodes[1] = static_cast<int>(s.particles.node_count()); },
                [](System& s, RunState&) { s.flank.edges.at(0).share = kNan; },
                [](System& s, RunState&) { s.flank.pressure = -1; },
            });
}

TEST_CASE("bonded contacts in a state that is none are refused") {
  check_all("holds no state of the bonded contacts",
            {
                [](System& s, RunState&) { s.contacts.broken.at(0).points[0] = static_cast<BreakMode>(9); },
                [](System& s, RunState&) { s.contacts.broken.at(0).break_time = kNan; },
                [](System& s, RunState&) { s.contacts.broken.at(0).break_time = s.time + 1; },
                [](System& s, RunState&) {
                  // broken, but at no time
                  const auto c = static_cast<std::size_t>(s.general.handing_over.at(0));
                  s.contacts.broken_edge(c).break_time = -1;
                },
                [](System& s, RunState&) { s.contacts.broken.at(0).hand_over.weight = 2; },
            });
}

TEST_CASE("members of general contact that are none are refused") {
  check_all("holds no state of the general contacts",
            {
                [](System& s, RunState&) { s.general.members.back().triangle = 1 << 30; },
                [](System& s, RunState&) { s.general.members[1].triangle = s.general.members[0].triangle; },
                [](System& s, RunState&) { s.general.members[0].surface[1] = 2; },
                [](System& s, RunState&) { s.general.members[0].next[0] = -2; },
                [](System& s, RunState&) { s.general.members[0].previous[2] = 1 << 30; },
                [](System& s, RunState&) { s.general.members.clear(); },
                [](System& s, RunState&) { s.general.travel = kNan; },
                [](System& s, RunState&) { s.general.searches = std::numeric_limits<std::int64_t>::max(); },
            });
}

TEST_CASE("pairs, touches and chains that lead nowhere are refused") {
  check_all("holds no state of the general contacts",
            {
                [](System& s, RunState&) { s.general.pairs.at(0).a = -1; },
                [](System& s, RunState&) { s.general.pairs.at(0).b = 1 << 30; },
                [](System& s, RunState&) { s.general.pairs.at(0).chain_begin = -1; },
                [](System& s, RunState&) { s.general.pairs.at(0).chain_size = std::numeric_limits<int>::max(); },
                [](System& s, RunState&) { s.general.pairs.at(0).touch = 1 << 30; },
                [](System& s, RunState&) { s.general.touches.at(0).pair = -1; },
                [](System& s, RunState&) { s.general.touches.at(0).pair = s.general.touches.at(1).pair; },
                [](System& s, RunState&) { s.general.touches.pop_back(); },
                [](System& s, RunState&) { s.general.chain_contacts.at(0) = -1; },
                [](System& s, RunState&) { s.general.handing_over.at(0) = static_cast<int>(s.contacts.size()); },
            });
}

TEST_CASE("a loading that is none is refused") {
  check_all("holds no state of the loading",
            {
                [](System&, RunState& r) { r.loading.phase = static_cast<LoadingPhase>(3); },
                [](System&, RunState& r) { r.loading.zero_distance_mm = kHuge; },
                [](System&, RunState& r) { r.loading.phase_start_s = kNan; },
            });
}

TEST_CASE("a progress that no run can have made is refused") {
  check_all("holds no progress of a run",
            {
                [](System&, RunState& r) { r.next_frame_strain = -kHuge; },  // pictures without end
                [](System&, RunState& r) { r.next_frame_strain = kNan; },
                [](System&, RunState& r) { r.frames = -1; },
                [](System&, RunState& r) { r.loading.stages = std::numeric_limits<int>::max(); },  // overflows
                [](System&, RunState& r) { r.steps_in_sample = std::numeric_limits<std::int64_t>::max(); },
                [](System&, RunState& r) { r.samples_below = -1; },
                [](System&, RunState& r) { r.reaction_sum.reaction[1] = kNan; },
                [](System&, RunState& r) { r.stop = static_cast<StopReason>(9); },
                [](System&, RunState& r) {
                  r.stop = StopReason::strain;  // finished, but without a sample to tell of
                  r.samples.clear();
                },
            });
}
