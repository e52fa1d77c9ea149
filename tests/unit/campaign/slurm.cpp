#include <stdlib.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/base/error.hpp"
#include "core/campaign/campaign.hpp"
#include "tests/unit/campaign/fake_asperity.hpp"

using namespace asperity;
using asperity::testing::FakeAsperity;

namespace fs = std::filesystem;

namespace {

/// Slurm's commands as shell scripts on the PATH: tasks run at once on this machine, each array is a folder jobs/N with
/// the process of each task. tests/cli/test_slurm.py has the real one.
class FakeSlurm {
 public:
  explicit FakeSlurm(const std::string& name) : asperity(name), path_(::getenv("PATH")) {
    const fs::path bin = asperity.root() / "bin";
    fs::create_directories(asperity.root() / "jobs");
    asperity.write_program(bin / "sbatch", R"(echo "$*" >> 'FOLDER/sbatch.calls'
job=$(($(ls FOLDER/jobs | wc -l) + 1))
for a; do case $a in --array=*) range=${a#--array=0-};; --job-name=*) name=${a#--job-name=};; esac; script=$a; done
mkdir FOLDER/jobs/$job; echo $name > FOLDER/jobs/$job/name
for i in $(seq 0 ${range%%%*}); do
  SLURM_ARRAY_TASK_ID=$i /bin/sh "$script" > /dev/null 2>&1 & echo $! > FOLDER/jobs/$job/task.$i
done
echo $job
)");
    asperity.write_program(bin / "squeue", R"([ ! -e FOLDER/away ] || { rm FOLDER/away; exit 1; }
for t in FOLDER/jobs/*/task.*; do
  job=$(basename $(dirname $t))
  # By its command: the number of a process that has ended may soon be another's.
  tr '\0' ' ' < /proc/$(cat $t)/cmdline 2> /dev/null | grep -q 'FOLDER/.*task_' && echo "$job ${t##*.} R"
done
exit 0
)");
    asperity.write_program(bin / "scancel", R"(echo "$*" >> 'FOLDER/scancel.calls'
case "$*" in *PENDING*) exit 0;; esac
for t in FOLDER/jobs/*/task.*; do
  tr '\0' ' ' < /proc/$(cat $t)/cmdline 2> /dev/null | grep -q 'FOLDER/.*task_' && kill -TERM $(cat $t)
done
exit 0
)");
    ::setenv("PATH", (bin.string() + ":" + path_).c_str(), 1);
  }
  ~FakeSlurm() { ::setenv("PATH", path_.c_str(), 1); }

  CampaignOptions options() const {
    CampaignOptions o = asperity.options();
    o.executor = Executor::slurm;
    o.slurm.poll_interval_s = 0.05;
    o.slurm.lost_after_s = 0.1;
    o.slurm.resubmissions = 2;
    return o;
  }

  /// The arguments of each call of the command.
  std::string calls(const std::string& command) const {
    const fs::path file = asperity.root() / (command + ".calls");
    return fs::exists(file) ? read_file(file) : "";
  }

  const FakeAsperity asperity;

 private:
  std::string path_;
};

/// The run's shell and its task script end without a word, as when their node dies.
constexpr const char* kNodeDies = "kill -9 $PPID; kill -9 $$";

std::size_t count_lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

}  // namespace

TEST_CASE("Slurm: one array over all runs, with what the configuration asks for") {
  const FakeSlurm slurm("slurm_array");
  CampaignOptions options = slurm.options();
  options.slurm.partition = "short";
  options.slurm.account = "rock";
  options.slurm.time_limit_min = 30;
  options.slurm.memory_mb = 500;
  options.slurm.max_tasks = 2;
  options.slurm.extra_arguments = {"--qos=low"};
  const std::vector<CampaignRun> runs = slurm.asperity.runs(3);
  slurm.asperity.let(2, "echo 'error: it crumbled'; exit 4");
  const std::vector<CampaignOutcome> outcomes = run_campaign(runs, options);
  CHECK(outcomes[0].status == RunStatus::finished);
  CHECK(outcomes[1].reason == "it crumbled");
  CHECK(outcomes[1].exit_code == 4);
  CHECK(outcomes[2].status == RunStatus::finished);
  const std::string call = slurm.calls("sbatch");
  CHECK(count_lines(call) == 1);
  for (const char* part : {"--array=0-2%2 ", "--partition=short ", "--account=rock ", "--time=30 ", "--mem=500 ",
                           "--signal=B:TERM@60 ", "--no-requeue ", "--qos=low "})
    CHECK_THAT(call, Catch::Contains(part));
  CHECK(fs::is_empty(slurm.asperity.store() / "slurm"));
  run_campaign(runs, options);
  CHECK(count_lines(slurm.calls("sbatch")) == 1);  // all is there: nothing to submit
}

TEST_CASE("Slurm: a lost task is put in again and resumes; a queue without an answer loses none") {
  const FakeSlurm slurm("slurm_lost");
  const std::vector<CampaignRun> runs = slurm.asperity.runs(2);
  slurm.asperity.let(
      1, std::string("[ $verb = resume ] || { leave interrupted; : > \"$here/away\"; ") + kNodeDies + "; }");
  const std::vector<CampaignOutcome> outcomes = run_campaign(runs, slurm.options());
  CHECK(outcomes[0].status == RunStatus::finished);
  CHECK(outcomes[1].status == RunStatus::finished);
  REQUIRE(slurm.asperity.calls(1).size() == 2);
  CHECK_THAT(slurm.asperity.calls(1)[1], Catch::StartsWith("resume "));
  CHECK(slurm.asperity.calls(2).size() == 1);
}

TEST_CASE("Slurm: a task that is lost time and again is given up after the stated number of times") {
  const FakeSlurm slurm("slurm_given_up");
  const std::vector<CampaignRun> runs = slurm.asperity.runs(1);
  slurm.asperity.let(1, kNodeDies);
  const CampaignOutcome outcome = run_campaign(runs, slurm.options())[0];
  CHECK(outcome.status == RunStatus::failed);
  CHECK_THAT(outcome.reason, Catch::Contains("lost by Slurm 3 times"));
  CHECK(slurm.asperity.calls(1).size() == 3);
  slurm.asperity.let(1, "finish");
  CHECK(run_campaign(runs, slurm.options())[0].status == RunStatus::finished);
}

TEST_CASE("Slurm: where accounting answers, a task out of memory is not tried again") {
  const FakeSlurm slurm("slurm_memory");
  slurm.asperity.write_program(slurm.asperity.root() / "bin/sacct", "echo OUT_OF_MEMORY\n");
  const std::vector<CampaignRun> runs = slurm.asperity.runs(1);
  slurm.asperity.let(1, kNodeDies);
  const CampaignOutcome outcome = run_campaign(runs, slurm.options())[0];
  CHECK(outcome.status == RunStatus::failed);
  CHECK_THAT(outcome.reason, Catch::Contains("OUT_OF_MEMORY") && Catch::Contains("/slurm/memory_mb"));
  CHECK(slurm.asperity.calls(1).size() == 1);
}

TEST_CASE("Slurm: a run that meets its time limit goes on from its checkpoint") {
  const FakeSlurm slurm("slurm_time_limit");
  const std::vector<CampaignRun> runs = slurm.asperity.runs(1);
  slurm.asperity.let(1, "[ $verb = resume ] || { leave interrupted; exit 130; }");
  CHECK(run_campaign(runs, slurm.options())[0].status == RunStatus::finished);
  CHECK(slurm.asperity.calls(1).size() == 2);
}

TEST_CASE("Slurm: interrupted, the tasks are told to end and leave checkpoints") {
  const FakeSlurm slurm("slurm_interrupted");
  const std::vector<CampaignRun> runs = slurm.asperity.runs(2);
  for (std::uint64_t seed : {1, 2})
    slurm.asperity.let(seed,
                       "trap 'leave interrupted; exit 130' TERM; : > \"$here/up.$id\"; while :; do sleep 0.02; done");
  CampaignOptions options = slurm.options();
  options.interrupted = [&] {
    const auto up = [&](std::uint64_t seed) {
      return fs::exists(slurm.asperity.root() / ("up." + slurm.asperity.files(seed).id));
    };
    return up(1) && up(2);
  };
  for (const CampaignOutcome& outcome : run_campaign(runs, options)) {
    CHECK(outcome.status == RunStatus::interrupted);
    CHECK(fs::exists(outcome.folder / "manifest.json"));
  }
  CHECK_THAT(slurm.calls("scancel"), Catch::Contains("--state=PENDING") && Catch::Contains("--batch --signal=TERM"));
  for (std::uint64_t seed : {1, 2}) slurm.asperity.let(seed, "finish");
  CHECK(run_campaign(runs, slurm.options())[1].status == RunStatus::finished);
  CHECK_THAT(slurm.asperity.calls(1)[1], Catch::StartsWith("resume "));
}

TEST_CASE("Slurm: jobs of a campaign that was killed are told to end before others are submitted") {
  const FakeSlurm slurm("slurm_abandoned");
  const fs::path left = slurm.asperity.store() / "slurm/asperity_0123456789ab";
  fs::create_directories(left);
  write_file_atomically(left / "lock", "");
  run_campaign(slurm.asperity.runs(1), slurm.options());
  CHECK_FALSE(fs::exists(left));
  CHECK_THAT(slurm.calls("scancel"), Catch::Contains("--name=asperity_0123456789ab"));
}

TEST_CASE("Slurm: a refusal is one clear error with Slurm's words, and so is a machine without Slurm") {
  const FakeSlurm slurm("slurm_refused");
  const std::vector<CampaignRun> runs = slurm.asperity.runs(1);
  const auto message = [&] {
    try {
      run_campaign(runs, slurm.options());
      return std::string();
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::config);
      return std::string(error.what());
    }
  };
  slurm.asperity.write_program(slurm.asperity.root() / "bin/sbatch",
                               "echo 'sbatch: error: invalid partition' >&2; exit 1\n");
  CHECK_THAT(message(), Catch::StartsWith("/slurm: sbatch refuses the campaign: sbatch: error: invalid partition"));
  ::setenv("PATH", slurm.asperity.root().c_str(), 1);
  CHECK_THAT(message(), Catch::StartsWith("--executor: needs sbatch, which is not on the PATH (found slurm") &&
                            Catch::Contains("Hint: "));
}
