#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "core/config/run_config.hpp"
#include "core/output/run_identity.hpp"

namespace asperity {

/// The files of one run in a store, named by the first 16 hexadecimal digits of its configuration's hash.
struct StoredRun {
  std::string id;                 ///< Those digits.
  RunIdentity identity;           ///< Of the run as this executable would make it.
  std::filesystem::path config;   ///< ID.json
  std::filesystem::path folder;   ///< ID, the run folder.
  std::filesystem::path log;      ///< ID.log: what the run's processes printed.
  std::filesystem::path failure;  ///< ID.failure.json: how the run failed last.
};

/// Names the files; touches none.
StoredRun stored_run(const std::filesystem::path& store, const RunConfig& config);

/// Writes ID.json unless it lies there with the same bytes; name and description, which identify no run, are left out.
/// Throws Error(output).
void write_config(const StoredRun& run, RunConfig config);

/// How a run ended that did not finish.
struct Failure {
  int exit_code = 0;
  std::string reason;    ///< One line.
  bool resumed = false;  ///< Whether the process that failed had gone on from a checkpoint.
};

/// Exit codes of failures that come again as long as configuration and code are the same: config, numerical, tolerance.
bool comes_again(int exit_code);

/// Notes the failure beside the run folder, with the code that failed. Throws Error(output).
void write_failure(const StoredRun& run, const Failure& failure);

/// The failure noted last by the same code; nothing where there is none or it cannot be read.
std::optional<Failure> find_failure(const StoredRun& run);

/// Removes the note. Throws Error(output).
void clear_failure(const StoredRun& run);

/// What is to be done about a run.
enum class RunStand {
  finished,  ///< A finished run of the same code lies there.
  failed,    ///< It failed by the same code, and would fail again.
  refused,   ///< The folder holds something else, which is kept.
  busy,      ///< Another process writes there.
  start,     ///< To be computed from its start.
  resume     ///< To be computed from what an earlier process left.
};

struct RunView {
  RunStand stand = RunStand::start;
  Failure failure;  ///< Of a failed or refused run.
};

/// Looks what lies in the store, by reading alone.
RunView look_at(const StoredRun& run);

/// What the run folder's manifest says of its run.
struct RunEnd {
  std::string reason;
  double compute_s = 0;
};

/// Empty where there is no manifest of this configuration.
RunEnd stored_end(const StoredRun& run);

}  // namespace asperity
