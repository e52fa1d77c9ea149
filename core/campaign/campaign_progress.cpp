#include "core/campaign/campaign_progress.hpp"

#include <algorithm>

#include "core/config/estimates.hpp"

namespace asperity {

double expected_cost(const RunConfig& config) {
  const ExperimentConfig& e = config.experiment;
  const double height = e.type == ExperimentType::brazilian ? e.diameter_mm : e.height_mm;
  const double duration = e.type == ExperimentType::direct_shear
                              ? e.stop.shear_displacement_mm / e.loading.shear_rate_mm_per_s
                              : e.stop.axial_strain * height / e.loading.closing_rate_mm_per_s;
  const double step =
      config.integration.time_step_s.value_or(config.integration.safety_factor * estimated_critical_step(config));
  return estimated_triangles(config) * duration / step;
}

void ProgressLedger::add_job(double cost, std::size_t runs) { jobs_.push_back({cost, runs}); }

void ProgressLedger::measure(const Job& job, double compute_s) {
  if (compute_s <= 0) return;
  measured_s_ += compute_s;
  measured_cost_ += job.cost;
}

void ProgressLedger::reuse(std::size_t job, double compute_s, bool failed) {
  jobs_[job].reused = true;
  finish(job, compute_s, failed);
}

void ProgressLedger::start(std::size_t job, double now) {
  jobs_[job].stage = Stage::running;
  jobs_[job].started = now;
}

void ProgressLedger::finish(std::size_t job, double compute_s, bool failed) {
  jobs_[job].stage = Stage::done;
  jobs_[job].failed = failed;
  if (!failed) measure(jobs_[job], compute_s);  // a failed run has ended early: its time says nothing of the others'
}

void ProgressLedger::stop(std::size_t job) { jobs_[job].stage = Stage::waiting; }

/// Eq. (Q2).
std::optional<double> ProgressLedger::time_left(double now) const {
  if (measured_cost_ <= 0) return std::nullopt;
  const double seconds_per_cost = measured_s_ / measured_cost_;
  double work_s = 0, workers = 0;
  for (const Job& job : jobs_) {
    if (job.stage == Stage::done) continue;
    const bool running = job.stage == Stage::running;
    work_s += std::max(0.0, seconds_per_cost * job.cost - (running ? now - job.started : 0.0));
    workers += running ? 1 : 0;
  }
  return work_s / std::max(1.0, workers);
}

CampaignProgress ProgressLedger::at(double now) const {
  CampaignProgress p;
  double cost = 0, done_cost = 0;
  for (const Job& job : jobs_) {
    const bool done = job.stage == Stage::done;
    p.runs += job.runs;
    p.running += job.stage == Stage::running ? 1 : 0;
    p.done += done ? job.runs : 0;
    p.failed += job.failed ? job.runs : 0;
    p.reused += job.reused ? job.runs : 0;
    cost += job.cost;
    done_cost += done ? job.cost : 0;
  }
  p.fraction = p.done == p.runs || cost <= 0 ? 1.0 : done_cost / cost;
  p.left_s = time_left(now);
  return p;
}

}  // namespace asperity
