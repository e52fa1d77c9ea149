#include "core/campaign/slurm_commands.hpp"

#include <charconv>
#include <sstream>

#include "core/base/error.hpp"
#include "core/campaign/child_process.hpp"

namespace asperity {
namespace {

constexpr double kAnswerWithin = 60;  // s; the commands themselves give a controller up to 10 s and ask again

/// A signal may come up to a minute early, and a run needs a moment to write its checkpoint.
constexpr int kShortestLimitWithWarning = 3;  // min
constexpr const char* kWarning = "--signal=B:TERM@60";

std::string trimmed(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

template <class Number>
std::optional<Number> number_of(const std::string& text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end == text.data()) return std::nullopt;
  return number;
}

std::vector<std::string> sbatch_command(const SlurmArray& array, const SlurmConfig& config) {
  const std::string range = "0-" + std::to_string(array.size - 1);
  const std::string at_once = array.at_once > 0 ? "%" + std::to_string(array.at_once) : "";
  std::vector<std::string> command{"sbatch", "--parsable", "--job-name=" + array.name, "--array=" + range + at_once,
                                   // What is lost is put in again by us, who look what there is to go on from.
                                   "--no-requeue", "--ntasks=1", "--cpus-per-task=1",
                                   "--output=" + (array.folder / "task_%a.out").string()};
  if (!config.partition.empty()) command.push_back("--partition=" + config.partition);
  if (!config.account.empty()) command.push_back("--account=" + config.account);
  if (config.time_limit_min > 0) command.push_back("--time=" + std::to_string(config.time_limit_min));
  if (config.time_limit_min >= kShortestLimitWithWarning) command.push_back(kWarning);
  if (config.memory_mb > 0) command.push_back("--mem=" + std::to_string(config.memory_mb));
  command.insert(command.end(), config.extra_arguments.begin(), config.extra_arguments.end());
  command.push_back(array.script.string());
  return command;
}

/// "123 4 R" of squeue as an entry; nothing for a line of another form.
std::optional<std::pair<SlurmTaskId, bool>> queue_entry(const std::string& line) {
  std::istringstream words(line);
  std::string job, index, state;
  words >> job >> index >> state;
  const auto job_number = number_of<std::int64_t>(job);
  const auto index_number = number_of<int>(index);
  if (!job_number || !index_number || state.empty()) return std::nullopt;
  return std::pair{SlurmTaskId{*job_number, *index_number}, state == "R"};
}

}  // namespace

void require_slurm() {
  for (const char* program : {"sbatch", "squeue", "scancel"}) {
    if (find_program(program)) continue;
    throw Error(ErrorKind::config, {{"--executor", std::string("needs ") + program + ", which is not on the PATH",
                                     "slurm", "local, or slurm where Slurm's commands are installed",
                                     "call it on a machine that submits to Slurm, or take --executor local"}});
  }
}

std::int64_t submit_array(const SlurmArray& array, const SlurmConfig& config) {
  const CommandResult result = run_command_to_end(sbatch_command(array, config), kAnswerWithin);
  // "123" or "123;cluster"
  const auto job = result.end.exit_code == 0 ? number_of<std::int64_t>(result.out) : std::nullopt;
  if (job) return *job;
  const std::string words = trimmed(result.err + result.out);
  throw Error(ErrorKind::config, {{"/slurm", "sbatch refuses the campaign: " + (words.empty() ? "no word" : words), "",
                                   "what the cluster allows",
                                   "see partition, account, limits and extra_arguments; `sinfo` lists partitions"}});
}

std::optional<std::map<SlurmTaskId, bool>> queued_tasks(const std::string& name) {
  const CommandResult result =
      run_command_to_end({"squeue", "--noheader", "--array", "--name=" + name, "--format=%F %K %t"}, kAnswerWithin);
  if (result.end.exit_code != 0) return std::nullopt;
  std::map<SlurmTaskId, bool> tasks;
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);)
    if (const auto entry = queue_entry(line)) tasks.insert(*entry);
  return tasks;
}

std::string accounted_state(const SlurmTaskId& task) {
  if (!find_program("sacct")) return "";
  const std::string id = std::to_string(task.job) + "_" + std::to_string(task.index);
  const CommandResult result = run_command_to_end(
      {"sacct", "--noheader", "--parsable2", "--allocations", "--jobs=" + id, "--format=State"}, kAnswerWithin);
  if (result.end.exit_code != 0) return "";
  return trimmed(result.out.substr(0, result.out.find('\n')));
}

void cancel_tasks(const std::string& name) {
  run_command_to_end({"scancel", "--quiet", "--name=" + name, "--state=PENDING"}, kAnswerWithin);
  run_command_to_end({"scancel", "--quiet", "--name=" + name, "--batch", "--signal=TERM"}, kAnswerWithin);
}

void kill_tasks(const std::string& name) {
  run_command_to_end({"scancel", "--quiet", "--name=" + name}, kAnswerWithin);
}

}  // namespace asperity
