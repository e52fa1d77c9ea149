#include "core/campaign/campaign.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <thread>

#include "core/base/error.hpp"
#include "core/base/output_error.hpp"
#include "core/campaign/failure_reason.hpp"
#include "core/campaign/local_executor.hpp"
#include "core/campaign/slurm_executor.hpp"
#include "core/campaign/stored_run.hpp"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kBetweenLooks{200};  // at a run that another process writes

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// One configuration to be computed, for all the runs of the list that have it.
struct Job {
  StoredRun files;
  const RunConfig* config;
  std::vector<std::size_t> runs;
  double cost;
  bool done = false;
  bool begun = false;            ///< A process was started for it.
  bool resumed = false;          ///< Its latest process was to go on from a checkpoint.
  std::uintmax_t log_begin = 0;  ///< Bytes in the log before its latest process.
  CampaignOutcome outcome{};
};

class Campaign {
 public:
  Campaign(const std::vector<CampaignRun>& runs, const CampaignOptions& options);
  void carry_out();
  std::vector<CampaignOutcome> outcomes() const;

 private:
  void add(const CampaignRun& run, std::size_t number, std::map<std::string, std::size_t>& known);
  std::vector<std::size_t> open_jobs(bool& busy);
  void settle(std::size_t j, const RunView& view);
  TaskQueue queue_of(const std::vector<std::size_t>& open);
  Task task_of(Job& job) const;
  void end(std::size_t j, const TaskEnd& end);
  void conclude(std::size_t j, RunStatus status, const std::string& reason, int exit_code);
  void fail(std::size_t j, const TaskEnd& end);
  void execute(const std::vector<std::size_t>& open);
  bool interrupted() const { return options_.interrupted && options_.interrupted(); }
  void tell() const;

  const std::vector<CampaignRun>& runs_;
  const CampaignOptions& options_;
  fs::path store_;
  std::vector<Job> jobs_;
  ProgressLedger ledger_;
};

Campaign::Campaign(const std::vector<CampaignRun>& runs, const CampaignOptions& options)
    : runs_(runs), options_(options), store_(fs::absolute(options.store).lexically_normal()) {
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < runs.size(); ++i) add(runs[i], i, known);
  for (const Job& job : jobs_) ledger_.add_job(job.cost, job.runs.size());
}

void Campaign::add(const CampaignRun& run, std::size_t number, std::map<std::string, std::size_t>& known) {
  StoredRun files = stored_run(store_, run.config);
  const auto [found, fresh] = known.emplace(files.identity.config_hash, jobs_.size());
  if (fresh) {
    const double cost = run.expected_cost > 0 ? run.expected_cost : expected_cost(run.config);
    jobs_.push_back({std::move(files), &run.config, {}, cost});
  }
  jobs_[found->second].runs.push_back(number);
}

void Campaign::tell() const {
  if (options_.on_progress) options_.on_progress(ledger_.at(steady_seconds()));
}

void Campaign::conclude(std::size_t j, RunStatus status, const std::string& reason, int exit_code) {
  Job& job = jobs_[j];
  const double compute_s = stored_end(job.files).compute_s;
  const bool reused = !job.begun;
  job.done = true;
  job.outcome = {"", options_.store / job.files.id, status, reused, reason, exit_code, compute_s};
  if (status == RunStatus::interrupted) return ledger_.stop(j);
  const bool failed = status == RunStatus::failed;
  reused ? ledger_.reuse(j, compute_s, failed) : ledger_.finish(j, compute_s, failed);
}

/// What the store already says of the job.
void Campaign::settle(std::size_t j, const RunView& view) {
  const Job& job = jobs_[j];
  if (view.stand == RunStand::finished) return conclude(j, RunStatus::finished, stored_end(job.files).reason, 0);
  conclude(j, RunStatus::failed, one_line(view.failure.reason, store_), view.failure.exit_code);
}

/// The jobs that can be computed now, the longest first: so the last to end leaves the least idle.
std::vector<std::size_t> Campaign::open_jobs(bool& busy) {
  std::vector<std::size_t> open;
  busy = false;
  for (std::size_t j = 0; j < jobs_.size(); ++j) {
    if (jobs_[j].done) continue;
    const RunView view = look_at(jobs_[j].files);
    const bool to_compute = view.stand == RunStand::start || view.stand == RunStand::resume;
    if (to_compute) open.push_back(j);
    if (view.stand == RunStand::busy) busy = true;
    if (!to_compute && view.stand != RunStand::busy) settle(j, view);
  }
  std::stable_sort(open.begin(), open.end(), [&](auto a, auto b) { return jobs_[a].cost > jobs_[b].cost; });
  return open;
}

Task Campaign::task_of(Job& job) const {
  job.begun = true;
  job.resumed = look_at(job.files).stand == RunStand::resume;
  job.log_begin = fs::exists(job.files.log) ? fs::file_size(job.files.log) : 0;
  write_config(job.files, *job.config);
  std::vector<std::string> command{fs::absolute(options_.executable).string()};
  if (job.resumed) {
    command.insert(command.end(), {"resume", job.files.folder.string()});
  } else {
    command.insert(command.end(), {"run", job.files.config.string(), "--out", job.files.folder.string()});
  }
  command.insert(command.end(), {"--threads", "1", "--no-render", "--quiet"});
  return {std::move(command), job.files.log};
}

void Campaign::fail(std::size_t j, const TaskEnd& end) {
  Job& job = jobs_[j];
  const std::string printed = text_from(job.files.log, job.log_begin);
  const std::string reason = one_line(end.reason.empty() ? last_error(printed, end.exit_code) : end.reason, store_);
  write_failure(job.files, {end.exit_code, reason, job.resumed});
  conclude(j, RunStatus::failed, reason, end.exit_code);
}

void Campaign::end(std::size_t j, const TaskEnd& end) {
  Job& job = jobs_[j];
  if (end.exit_code == kInterrupted)
    return conclude(j, RunStatus::interrupted, end.reason.empty() ? "interrupted" : end.reason, kInterrupted);
  const RunStand stand = look_at(job.files).stand;
  if (end.exit_code == 0 && stand == RunStand::finished) {
    clear_failure(job.files);
    return conclude(j, RunStatus::finished, stored_end(job.files).reason, 0);
  }
  // Another campaign that shares the store was quicker: wait for it, or take what it has made.
  const bool overtaken =
      end.exit_code == static_cast<int>(ErrorKind::output) && (stand == RunStand::busy || stand == RunStand::finished);
  if (overtaken) {
    job.begun = false;
    return ledger_.stop(j);
  }
  if (end.exit_code != 0) return fail(j, end);
  fail(j, {static_cast<int>(ErrorKind::unexpected),
           "ended without an error but left no finished run of this code: was the executable replaced?"});
}

TaskQueue Campaign::queue_of(const std::vector<std::size_t>& open) {
  TaskQueue queue;
  queue.size = open.size();
  queue.task = [&](std::size_t i) { return task_of(jobs_[open[i]]); };
  queue.started = [&](std::size_t i) { ledger_.start(open[i], steady_seconds()); };
  queue.stopped = [&](std::size_t i) { ledger_.stop(open[i]); };
  queue.ended = [&](std::size_t i, const TaskEnd& its_end) { end(open[i], its_end); };
  queue.interrupted = [this] { return interrupted(); };
  queue.tick = [this] { tell(); };
  return queue;
}

void Campaign::execute(const std::vector<std::size_t>& open) {
  const TaskQueue queue = queue_of(open);
  if (options_.executor == Executor::local) return run_locally(queue, options_.jobs);
  run_on_slurm(queue, options_.slurm, store_ / "slurm");
}

void Campaign::carry_out() {
  for (bool busy = true; busy;) {
    const std::vector<std::size_t> open = open_jobs(busy);
    if (interrupted()) return;
    if (!open.empty()) {
      execute(open);
      busy = true;  // a run in which another process was quicker has to be looked at again
      continue;
    }
    tell();
    if (busy) std::this_thread::sleep_for(kBetweenLooks);
  }
}

std::vector<CampaignOutcome> Campaign::outcomes() const {
  std::vector<CampaignOutcome> outcomes(runs_.size());
  for (const Job& job : jobs_) {
    for (const std::size_t run : job.runs) {
      CampaignOutcome& outcome = outcomes[run];
      outcome = job.outcome;
      if (!job.done) {
        outcome.folder = options_.store / job.files.id;
        outcome.reason = "not started";
        outcome.exit_code = kInterrupted;
      }
      outcome.label = runs_[run].label;
      const bool ended = outcome.status != RunStatus::interrupted;
      outcome.reused = ended && (outcome.reused || run != job.runs.front());
    }
  }
  return outcomes;
}

void require_executable(const fs::path& executable) {
  if (::access(executable.c_str(), X_OK) == 0) return;
  throw Error(ErrorKind::config, {{executable.string(), "is no program that can be run", "", "the program asperity",
                                   "a campaign starts a process for each run"}});
}

void make_store(const fs::path& store) {
  std::error_code error;
  fs::create_directories(store, error);
  if (error) throw output_error(store, "cannot be created", error.value());
}

}  // namespace

std::vector<CampaignOutcome> run_campaign(const std::vector<CampaignRun>& runs, const CampaignOptions& options) {
  require_executable(options.executable);
  if (options.executor == Executor::slurm) require_slurm();
  make_store(options.store);
  Campaign campaign(runs, options);
  campaign.carry_out();
  return campaign.outcomes();
}

}  // namespace asperity
