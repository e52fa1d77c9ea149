#include "core/experiment/checkpoint_pair.hpp"

#include <catch2/catch.hpp>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "tests/unit/experiment/small_models.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace fs = std::filesystem;

namespace {

const std::string kHash(64, 'a');

fs::path fresh_pair_folder(const std::string& name) {
  const fs::path folder = fs::path(ASPERITY_TEST_SCRATCH) / "experiment" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/// A test whose steps are only counted: what a step changes does not matter here.
struct Counted {
  Model model = small_model(weak_disc());
  RunState state = start_run(model);

  void save_at(CheckpointPair& pair, std::int64_t step) {
    model.system.step = step;
    pair.write(model, state);
  }
  /// The step of the checkpoint that a new session finds.
  std::int64_t found_in(const fs::path& folder, std::vector<Fault>* refused = nullptr) {
    CheckpointPair pair(folder, kHash);
    const std::vector<Fault> faults = pair.read(model, state);
    if (refused) *refused = faults;
    CHECK(pair.newest()->step == model.system.step);
    return model.system.step;
  }
};

void tear(const fs::path& file) { write_file_atomically(file, read_file(file).substr(0, 1000)); }

}  // namespace

TEST_CASE("checkpoints are written in turn, and the newest is found") {
  const fs::path folder = fresh_pair_folder("pair_turns");
  CheckpointPair pair(folder, kHash);
  CHECK_FALSE(pair.any());
  CHECK_FALSE(pair.newest());
  Counted run;
  for (const std::int64_t step : {10, 20, 30, 40}) {
    run.save_at(pair, step);
    CHECK(run.found_in(folder) == step);
  }
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator()) == 2);
  CHECK(pair.any());
  pair.remove();
  CHECK(fs::is_empty(folder));
}

TEST_CASE("a torn checkpoint leaves the one before it, and is the next to be written over") {
  const fs::path folder = fresh_pair_folder("pair_torn");
  Counted run;
  CheckpointPair pair(folder, kHash);
  for (const std::int64_t step : {10, 20, 30}) run.save_at(pair, step);
  const fs::path newest = pair.newest()->file;
  tear(newest);
  std::vector<Fault> refused;
  CHECK(run.found_in(folder, &refused) == 20);
  REQUIRE(refused.size() == 1);
  CHECK(refused[0].where == newest.string());
  CheckpointPair next_session(folder, kHash);
  next_session.read(run.model, run.state);
  run.save_at(next_session, 25);
  CHECK(next_session.newest()->file == newest);
  CHECK(run.found_in(folder, &refused) == 25);
  CHECK(refused.empty());
}

TEST_CASE("where neither checkpoint can be used both are named, and nothing is changed") {
  const fs::path folder = fresh_pair_folder("pair_unusable");
  Counted run;
  CheckpointPair pair(folder, kHash);
  for (const std::int64_t step : {10, 20}) run.save_at(pair, step);
  tear(folder / "state_0.bin");
  write_file_atomically(folder / "state_1.bin", checkpoint_bytes(run.model, run.state, std::string(64, 'b')));
  run.model.system.step = 7;
  CheckpointPair next_session(folder, kHash);
  try {
    next_session.read(run.model, run.state);
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::output);
    CHECK_THAT(error.what(), Catch::Contains("state_0.bin: is damaged") &&
                                 Catch::Contains("state_1.bin: belongs to another configuration") &&
                                 Catch::Contains("Hint: "));
  }
  CHECK(run.model.system.step == 7);
  CHECK_FALSE(next_session.newest());
}

TEST_CASE("a checkpoint that cannot be written leaves both") {
  const fs::path folder = fresh_pair_folder("pair_full");
  Counted run;
  CheckpointPair pair(folder, kHash);
  for (const std::int64_t step : {10, 20}) run.save_at(pair, step);
  fs::create_symlink("/dev/full", folder / "state_0.bin.tmp");
  CHECK_THROWS_WITH(run.save_at(pair, 30), Catch::Contains("No space left on device"));
  CHECK(run.found_in(folder) == 20);
  run.save_at(pair, 31);
  CHECK(run.found_in(folder) == 31);
}
