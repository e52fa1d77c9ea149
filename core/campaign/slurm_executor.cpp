#include "core/campaign/slurm_executor.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "core/base/error.hpp"
#include "core/base/log.hpp"
#include "core/campaign/slurm_folder.hpp"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Seconds = std::chrono::duration<double>;

constexpr std::chrono::milliseconds kBetweenTicks{50};
constexpr std::size_t kLargestArray = 1000;  // Slurm's MaxArraySize is 1001 unless the cluster says otherwise
constexpr int kMostRefusals = 20;            // of a resubmission, one after the other: then the cluster has changed
constexpr double kPatience = 60;             // s; tasks that do not end on SIGTERM are killed then
constexpr int kLost = 1;                     // exit code of a task that left none
constexpr int kSignalBase = 128;

double now() { return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count(); }

enum class Stage { waiting, queued, done };

/// One task of the queue on its way through Slurm.
struct Entry {
  Stage stage = Stage::waiting;
  SlurmTaskId id{};
  fs::path array;
  int submissions = 0;
  bool running = false;
  double absent_since = -1;  ///< s; below 0: squeue lists it.
};

class SlurmRun {
 public:
  SlurmRun(const TaskQueue& queue, const SlurmConfig& config, const fs::path& folder)
      : queue_(queue), config_(config), folder_(folder), entries_(queue.size) {}
  void carry_out();
  void cancel() const { cancel_tasks(folder_.name()); }

 private:
  std::vector<std::size_t> in_stage(Stage stage) const;
  void submit();
  void submit(const std::vector<std::size_t>& chosen, int at_once);
  void look();
  void look_at(std::size_t i, const std::map<SlurmTaskId, bool>& listed);
  void arrive(std::size_t i, int code);
  void lose(std::size_t i);
  void put_in_again(std::size_t i, const TaskEnd& if_too_often);
  void end(std::size_t i, const TaskEnd& end);
  void wind_up();

  const TaskQueue& queue_;
  const SlurmConfig& config_;
  SlurmFolder folder_;
  std::vector<Entry> entries_;
  int refusals_ = 0;
};

std::vector<std::size_t> SlurmRun::in_stage(Stage stage) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (entries_[i].stage == stage) found.push_back(i);
  return found;
}

/// False where the campaign is interrupted meanwhile.
bool wait_ticking(const TaskQueue& queue, double seconds) {
  for (const double end = now() + seconds; now() < end;) {
    if (queue.interrupted()) return false;
    queue.tick();
    std::this_thread::sleep_for(std::min<Seconds>(kBetweenTicks, Seconds(std::max(0.0, end - now()))));
  }
  return !queue.interrupted();
}

/// Puts in what waits: all arrays together stay below the limit of tasks at once, and are not throttled to a trickle.
void SlurmRun::submit() {
  std::vector<std::size_t> waiting = in_stage(Stage::waiting);
  const std::size_t queued = in_stage(Stage::queued).size();
  const std::size_t most = static_cast<std::size_t>(config_.max_tasks);
  const bool room = queued == 0 || (queued < kLargestArray && (most == 0 || 2 * queued <= most));
  if (waiting.empty() || !room) return;
  waiting.resize(std::min(waiting.size(), kLargestArray - queued));
  submit(waiting, most == 0 ? 0 : static_cast<int>(most - queued));
}

void SlurmRun::submit(const std::vector<std::size_t>& chosen, int at_once) try {
  std::vector<Task> tasks;
  for (const std::size_t i : chosen) tasks.push_back(queue_.task(i));
  const fs::path array = folder_.write_array(tasks);
  const std::int64_t job = submit_array({folder_.name(), array_script(array), array, tasks.size(), at_once}, config_);
  refusals_ = 0;
  for (int k = 0; k < static_cast<int>(chosen.size()); ++k) {
    Entry& entry = entries_[chosen[k]];
    entry = {Stage::queued, {job, k}, array, entry.submissions + 1};
  }
} catch (const Error& error) {
  // Slurm has taken these tasks before: its controller may be away for a while.
  const bool taken_before = entries_[chosen.front()].submissions > 0;
  if (!taken_before || error.kind() != ErrorKind::config || ++refusals_ == kMostRefusals) throw;
  log_warning(std::string(error.what()) + "; it is asked again");
}

void SlurmRun::end(std::size_t i, const TaskEnd& its_end) {
  entries_[i].stage = Stage::done;
  queue_.ended(i, its_end);
}

void SlurmRun::put_in_again(std::size_t i, const TaskEnd& if_too_often) {
  if (entries_[i].submissions > config_.resubmissions) return end(i, if_too_often);
  entries_[i].stage = Stage::waiting;
  queue_.stopped(i);
}

/// A run that ended early with a checkpoint though nobody interrupted the campaign met its time limit or was preempted.
void SlurmRun::arrive(std::size_t i, int code) {
  const std::string times = std::to_string(entries_[i].submissions) + " times";
  if (code == kInterrupted)
    return put_in_again(i, {code, "ended early by Slurm " + times + ": time limit or preemption"});
  const bool killed = code > kSignalBase;
  end(i, {code, killed ? "killed by signal " + std::to_string(code - kSignalBase) : ""});
}

void SlurmRun::lose(std::size_t i) {
  const std::string state = accounted_state(entries_[i].id);
  const std::string told = state.empty() ? "" : ", in state " + state;
  if (state.starts_with("OUT_OF_MEMORY"))
    return end(i, {kLost, "ended by Slurm" + told + ": /slurm/memory_mb is too low"});
  put_in_again(i, {kLost, "lost by Slurm " + std::to_string(entries_[i].submissions) + " times" + told});
}

void SlurmRun::look_at(std::size_t i, const std::map<SlurmTaskId, bool>& listed) {
  Entry& entry = entries_[i];
  const auto found = listed.find(entry.id);
  if (found == listed.end()) {
    if (entry.absent_since < 0) entry.absent_since = now();
    if (now() - entry.absent_since >= config_.lost_after_s) lose(i);
    return;
  }
  entry.absent_since = -1;
  if (found->second && !std::exchange(entry.running, true)) queue_.started(i);
}

/// The queue first: a task that ends between the two looks has left its exit code by the second.
void SlurmRun::look() {
  const auto listed = queued_tasks(folder_.name());
  for (const std::size_t i : in_stage(Stage::queued)) {
    if (const auto code = left_exit_code(entries_[i].array, entries_[i].id.index)) {
      arrive(i, *code);
    } else if (listed) {
      look_at(i, *listed);
    }
  }
}

/// Tells the jobs of this name to end, until none is in the queue or the queue gives no answer any more.
void empty_the_queue(const TaskQueue& queue, const std::string& name) {
  constexpr double kBetween = 0.5;  // s
  int unanswered = 0;
  for (const double begin = now(); unanswered < 10;) {
    now() - begin < kPatience ? cancel_tasks(name) : kill_tasks(name);
    const auto listed = queued_tasks(name);
    if (listed && listed->empty()) return;
    unanswered = listed ? 0 : unanswered + 1;
    queue.tick();
    std::this_thread::sleep_for(Seconds(kBetween));
  }
}

/// After an interruption: tasks that were at work without an exit code have lost no more than what a kill loses.
void SlurmRun::wind_up() {
  empty_the_queue(queue_, folder_.name());
  for (const std::size_t i : in_stage(Stage::queued)) {
    const auto code = left_exit_code(entries_[i].array, entries_[i].id.index);
    if (code || entries_[i].running) end(i, {code.value_or(kInterrupted), ""});
  }
}

void SlurmRun::carry_out() {
  while (in_stage(Stage::done).size() < entries_.size()) {
    if (!queue_.interrupted()) submit();
    if (!wait_ticking(queue_, config_.poll_interval_s)) return wind_up();
    look();
  }
}

void end_abandoned_jobs(const TaskQueue& queue, const fs::path& folder) {
  for (const fs::path& abandoned : abandoned_folders(folder)) {
    empty_the_queue(queue, abandoned.filename().string());
    std::error_code ignored;  // it is looked at again by the next campaign
    fs::remove_all(abandoned, ignored);
  }
}

}  // namespace

void run_on_slurm(const TaskQueue& queue, const SlurmConfig& config, const fs::path& folder) {
  end_abandoned_jobs(queue, folder);
  SlurmRun run(queue, config, folder);
  try {
    run.carry_out();
  } catch (...) {
    run.cancel();
    throw;
  }
}

}  // namespace asperity
