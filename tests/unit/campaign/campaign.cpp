#include "core/campaign/campaign.hpp"

#include <sys/file.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <memory>
#include <thread>

#include "core/base/error.hpp"
#include "core/base/file_descriptor.hpp"
#include "tests/unit/campaign/fake_asperity.hpp"

using namespace asperity;
using asperity::testing::FakeAsperity;
using asperity::testing::run_of_seed;

namespace fs = std::filesystem;

namespace {

std::vector<int> exit_codes(const std::vector<CampaignOutcome>& outcomes) {
  std::vector<int> codes;
  for (const CampaignOutcome& outcome : outcomes) codes.push_back(outcome.exit_code);
  return codes;
}

std::vector<RunStatus> statuses(const std::vector<CampaignOutcome>& outcomes) {
  std::vector<RunStatus> list;
  for (const CampaignOutcome& outcome : outcomes) list.push_back(outcome.status);
  return list;
}

constexpr auto kFinished = RunStatus::finished, kFailed = RunStatus::failed, kInterruptedRun = RunStatus::interrupted;

}  // namespace

TEST_CASE("each configuration is computed once, and outcomes stand in the order of the runs") {
  const FakeAsperity fake("once");
  std::vector<CampaignRun> runs = fake.runs(3);
  runs.push_back(run_of_seed(2));
  runs.back().label = "again";
  runs.back().config.name = "another name makes no other run";
  const std::vector<CampaignOutcome> outcomes = run_campaign(runs, fake.options());
  REQUIRE(outcomes.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(outcomes[i].label == runs[i].label);
    CHECK(outcomes[i].status == kFinished);
    CHECK(outcomes[i].reused == (i == 3));
    CHECK(outcomes[i].reason == "the fake's reason: finished");
    CHECK(outcomes[i].compute_s == 2.0);
  }
  CHECK(outcomes[3].folder == outcomes[1].folder);
  CHECK(outcomes[1].folder == fake.store() / fake.files(2).id);
  const std::string call = "run " + fake.files(2).config.string() + " --out " + fake.files(2).folder.string() +
                           " --threads 1 --no-render --quiet";
  CHECK(fake.calls(2) == std::vector{call});
}

TEST_CASE("a finished run is re-used by the next campaign and by any other of the store") {
  const FakeAsperity fake("reuse");
  run_campaign(fake.runs(2), fake.options());
  const std::vector<CampaignOutcome> outcomes = run_campaign(fake.runs(3), fake.options());
  CHECK(outcomes[0].reused);
  CHECK(outcomes[1].reused);
  CHECK_FALSE(outcomes[2].reused);
  for (std::uint64_t seed : {1, 2, 3}) CHECK(fake.calls(seed).size() == 1);
}

TEST_CASE("a run made by other code is computed again") {
  const FakeAsperity fake("other_code");
  const std::vector<CampaignRun> runs = fake.runs(1);
  run_campaign(runs, fake.options());
  Manifest manifest = read_manifest(fake.files(1).folder / "manifest.json");
  manifest.build.revision = "0123abc";
  write_manifest(fake.files(1).folder / "manifest.json", manifest);
  CHECK_FALSE(run_campaign(runs, fake.options())[0].reused);
  CHECK(fake.calls(1).size() == 2);
}

TEST_CASE("a failed run keeps its reason, does not stop the rest, and is not repeated where it would fail again") {
  const FakeAsperity fake("failure");
  const std::vector<CampaignRun> runs = fake.runs(3);
  fake.let(2,
           "echo 'warning: x'; echo \"error: step 7: $folder/curves.csv is not finite\" >&2; echo 'more' >&2; exit 4");
  const std::vector<CampaignOutcome> outcomes = run_campaign(runs, fake.options(1));
  CHECK(statuses(outcomes) == std::vector{kFinished, kFailed, kFinished});
  CHECK(outcomes[1].exit_code == 4);
  CHECK(outcomes[1].reason == "step 7: " + fake.files(2).id + "/curves.csv is not finite");
  CHECK_FALSE(outcomes[1].reused);
  const CampaignOutcome again = run_campaign(runs, fake.options())[1];
  CHECK(again.status == kFailed);
  CHECK(again.reused);
  CHECK(again.exit_code == 4);
  CHECK(again.reason == outcomes[1].reason);
  CHECK(fake.calls(2).size() == 1);
}

TEST_CASE("a failure by other code is tried again") {
  const FakeAsperity fake("failure_other_code");
  const std::vector<CampaignRun> runs = fake.runs(1);
  fake.let(1, "exit 3");
  CHECK(run_campaign(runs, fake.options())[0].reason == "ended with exit code 3");
  StoredRun older = fake.files(1);
  older.identity.revision = "0123abc";
  write_failure(older, {3, "then", false});
  fake.let(1, "finish");
  CHECK(run_campaign(runs, fake.options())[0].status == kFinished);
  CHECK_FALSE(fs::exists(fake.files(1).failure));
}

TEST_CASE("what may go well another time is tried again: output errors and kills") {
  const FakeAsperity fake("again");
  const std::vector<CampaignRun> runs = fake.runs(3);
  fake.let(1, "echo 'error: the disk is full'; exit 5");
  fake.let(2, "kill -9 $$");
  fake.let(3, "exit 0");  // finished nothing
  const std::vector<CampaignOutcome> outcomes = run_campaign(runs, fake.options());
  CHECK(exit_codes(outcomes) == std::vector{5, 128 + 9, 1});
  CHECK(outcomes[0].reason == "the disk is full");
  CHECK(outcomes[1].reason == "killed by signal SIGKILL");
  CHECK_THAT(outcomes[2].reason, Catch::Contains("left no finished run of this code"));
  for (std::uint64_t seed : {1, 2, 3}) fake.let(seed, "finish");
  CHECK(statuses(run_campaign(runs, fake.options())) == std::vector{kFinished, kFinished, kFinished});
}

TEST_CASE("an unfinished run is resumed, and begun anew where resuming failed") {
  const FakeAsperity fake("resume");
  const std::vector<CampaignRun> runs = fake.runs(1);
  fake.let(1, "leave interrupted; exit 130");
  CHECK(run_campaign(runs, fake.options())[0].status == kInterruptedRun);
  fake.let(1, "echo 'error: the checkpoints are damaged'; exit 5");
  CHECK(run_campaign(runs, fake.options())[0].status == kFailed);
  fake.let(1, "finish");
  CHECK(run_campaign(runs, fake.options())[0].status == kFinished);
  const std::vector<std::string> calls = fake.calls(1);
  REQUIRE(calls.size() == 3);
  CHECK(calls[1] == "resume " + fake.files(1).folder.string() + " --threads 1 --no-render --quiet");
  CHECK_THAT(calls[2], Catch::StartsWith("run "));
}

TEST_CASE("interrupted, runs at work are told once, the others do not start, and the next call goes on") {
  const FakeAsperity fake("interrupted");
  const std::vector<CampaignRun> runs = fake.runs(4);
  const std::string wait =
      "trap 'echo told >> \"$here/told\"; leave interrupted; exit 130' TERM; : > \"$here/up.$id\"; "
      "while :; do sleep 0.02; done";
  for (std::uint64_t seed : {1, 2, 3, 4}) fake.let(seed, wait);
  CampaignOptions options = fake.options(2);
  const auto up = [&](std::uint64_t seed) { return fs::exists(fake.root() / ("up." + fake.files(seed).id)); };
  options.interrupted = [&] { return up(1) && up(2); };
  const std::vector<CampaignOutcome> outcomes = run_campaign(runs, options);
  CHECK(statuses(outcomes) == std::vector(4, kInterruptedRun));
  CHECK(exit_codes(outcomes) == std::vector(4, 130));
  CHECK(outcomes[3].reason == "not started");
  CHECK(read_file(fake.root() / "told") == "told\ntold\n");
  for (std::uint64_t seed : {1, 2, 3, 4}) fake.let(seed, "finish");
  CHECK(statuses(run_campaign(runs, fake.options())) == std::vector(4, kFinished));
  CHECK_THAT(fake.calls(1)[1], Catch::StartsWith("resume "));
  CHECK(fake.calls(4).size() == 1);
}

TEST_CASE("no more than the jobs asked for run at once, and all of them do") {
  const FakeAsperity fake("jobs");
  const std::vector<CampaignRun> runs = fake.runs(5);
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    fake.let(seed,
             ": > \"$here/at_work.$id\"; sleep 0.1; ls \"$here\" | grep -c at_work >> \"$here/counts\"; "
             "rm \"$here/at_work.$id\"");
  run_campaign(runs, fake.options(2));
  const std::string counts = read_file(fake.root() / "counts");
  CHECK(counts.find('2') != std::string::npos);
  CHECK(counts.find_first_of("345") == std::string::npos);
}

TEST_CASE("the runs that are expected to take longest start first") {
  const FakeAsperity fake("longest_first");
  std::vector<CampaignRun> runs = fake.runs(3);
  for (std::size_t i = 0; i < 3; ++i) runs[i].expected_cost = i == 1 ? 5 : static_cast<double>(i + 1);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) fake.let(seed, "echo $id >> \"$here/order\"");
  run_campaign(runs, fake.options(1));
  CHECK(read_file(fake.root() / "order") ==
        fake.files(2).id + "\n" + fake.files(3).id + "\n" + fake.files(1).id + "\n");
}

TEST_CASE("a run that another process writes is waited for and taken") {
  const FakeAsperity fake("busy");
  const std::vector<CampaignRun> runs = fake.runs(1);
  const StoredRun files = fake.files(1);
  fs::create_directories(files.folder);
  auto lock = std::make_unique<FileDescriptor>(files.folder / kLockName, O_RDWR | O_CREAT);
  REQUIRE(::flock(lock->get(), LOCK_EX) == 0);
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    fs::copy_file(fake.root() / "manifests" / (files.id + ".finished"), files.folder / "manifest.json");
    lock.reset();
  });
  const std::vector<CampaignOutcome> outcomes = run_campaign(runs, fake.options());
  other.join();
  CHECK(outcomes[0].status == kFinished);
  CHECK(outcomes[0].reused);
  CHECK(fake.calls(1).empty());
}

TEST_CASE("a process that finds another at its run is no failure") {
  const FakeAsperity fake("overtaken");
  const std::vector<CampaignRun> runs = fake.runs(1);
  fake.let(1, "leave finished; echo 'error: another run writes there'; exit 5");
  const std::vector<CampaignOutcome> outcomes = run_campaign(runs, fake.options());
  CHECK(outcomes[0].status == kFinished);
  CHECK(outcomes[0].reused);
  CHECK(fake.calls(1).size() == 1);
}

TEST_CASE("a folder with strangers' files is a failed run and stays as it is") {
  const FakeAsperity fake("strangers");
  const std::vector<CampaignRun> runs = fake.runs(1);
  fs::create_directories(fake.files(1).folder);
  write_file_atomically(fake.files(1).folder / "thesis.tex", "do not lose me");
  const CampaignOutcome outcome = run_campaign(runs, fake.options())[0];
  CHECK(outcome.status == kFailed);
  CHECK(outcome.exit_code == 5);
  CHECK_THAT(outcome.reason, Catch::Contains("holds files that are no run"));
  CHECK(read_file(fake.files(1).folder / "thesis.tex") == "do not lose me");
}

TEST_CASE("progress counts every run of the list and ends at the whole") {
  const FakeAsperity fake("progress");
  std::vector<CampaignRun> runs = fake.runs(3);
  runs.push_back(run_of_seed(3));
  fake.let(2, "exit 4");
  run_campaign({runs[0]}, fake.options());
  CampaignOptions options = fake.options(1);
  std::vector<CampaignProgress> seen;
  options.on_progress = [&](const CampaignProgress& p) { seen.push_back(p); };
  run_campaign(runs, options);
  CHECK(seen.front().runs == 4);
  CHECK(seen.front().reused == 1);
  CHECK(seen.front().running == 1);
  CHECK(seen.back().done == 4);
  CHECK(seen.back().failed == 1);
  CHECK(seen.back().fraction == 1.0);
  for (std::size_t i = 1; i < seen.size(); ++i) CHECK(seen[i].done >= seen[i - 1].done);
}

TEST_CASE("an executable that is not there is one clear error") {
  const FakeAsperity fake("no_executable");
  CampaignOptions options = fake.options();
  options.executable = "no/such/asperity";
  CHECK_THROWS_WITH(run_campaign(fake.runs(1), options), Catch::Contains("no/such/asperity: is no program"));
}
