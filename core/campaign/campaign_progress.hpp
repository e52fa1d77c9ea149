#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "core/config/run_config.hpp"

namespace asperity {

/// Where a campaign stands, over all its runs.
struct CampaignProgress {
  std::size_t runs = 0;
  std::size_t done = 0;          ///< Finished or failed.
  std::size_t running = 0;       ///< Processes at work.
  std::size_t failed = 0;        ///< Part of `done`.
  std::size_t reused = 0;        ///< Part of `done`.
  double fraction = 0;           ///< Share of the expected cost that is done, 0 to 1.
  std::optional<double> left_s;  ///< Eq. (Q2); unset before anything was measured.
};

/// Expected cost of a run in particle steps, Eq. (Q1): enough to compare runs with one another before any is made.
double expected_cost(const RunConfig& config);

/// Keeps account of the runs of a campaign. Times are in s since any fixed instant.
class ProgressLedger {
 public:
  /// Adds a job that stands for so many runs of the list.
  void add_job(double cost, std::size_t runs);

  /// The job's result lay in the store. `compute_s`: what it took when it was computed; 0: not known.
  void reuse(std::size_t job, double compute_s, bool failed);
  void start(std::size_t job, double now);
  /// The job's process has ended and the job is done.
  void finish(std::size_t job, double compute_s, bool failed);
  /// The job's process has ended, but the job is not done: it was interrupted or lost.
  void stop(std::size_t job);

  CampaignProgress at(double now) const;

 private:
  enum class Stage { waiting, running, done };
  struct Job {
    double cost;
    std::size_t runs;
    Stage stage = Stage::waiting;
    bool reused = false;
    bool failed = false;
    double started = 0;
  };
  void measure(const Job& job, double compute_s);
  std::optional<double> time_left(double now) const;
  std::vector<Job> jobs_;
  double measured_s_ = 0;
  double measured_cost_ = 0;
};

}  // namespace asperity
