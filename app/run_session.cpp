#include "app/run_session.hpp"

#include <chrono>
#include <fstream>
#include <iostream>
#include <memory>

#include "app/crack_tables.hpp"
#include "app/exit_code.hpp"
#include "app/interruption.hpp"
#include "app/libraries.hpp"
#include "app/measured_copy.hpp"
#include "app/pictures.hpp"
#include "app/progress.hpp"
#include "app/report/run_report.hpp"
#include "app/run_plots.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/base/log.hpp"
#include "core/config/read_config.hpp"
#include "core/config/write_config.hpp"
#include "core/experiment/checkpoint_pair.hpp"
#include "core/experiment/summarise.hpp"
#include "core/measurement/capture.hpp"
#include "core/output/csv.hpp"
#include "core/output/manifest.hpp"
#include "core/output/run_tables.hpp"
#include "render/series.hpp"

namespace asperity::app {
namespace {

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Adds the life time of the object to a sum of seconds.
class Timed {
 public:
  explicit Timed(double& sum) : sum_(sum) {}
  ~Timed() { sum_ += watch_.seconds(); }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  double& sum_;
  Stopwatch watch_;
};

/// Everything one run writes while it goes on.
struct Session {
  RunFolder folder;
  Model model;
  RunState state;
  CheckpointPair checkpoints;
  Manifest manifest;
  SessionOptions options;
};

struct Tables {
  CsvTable curves, energy;
  render::SeriesWriter series;
};

CurveLayout curve_layout(const Model& model) {
  const bool joint = model.config.experiment.type == ExperimentType::direct_shear;
  return {joint, model.joint.gauge.tooth_area_mm2.size()};
}

Tables open_tables(const Session& s) {
  const RunFolder& f = s.folder;
  const CurveLayout layout = curve_layout(s.model);
  const std::size_t rows = s.state.samples.size();
  if (rows == 0) {
    return {CsvTable::create(f.curves(), curve_columns(layout)), CsvTable::create(f.energy(), energy_columns(layout)),
            render::SeriesWriter(f.root())};
  }
  return {CsvTable::resume(f.curves(), curve_columns(layout), rows), CsvTable::resume(f.energy(), energy_columns(layout), rows),
          render::SeriesWriter(f.root(), s.state.frames)};
}

ProgressState progress_state(const RunProgress& p, const Model& model) {
  const Sample& s = *p.sample;
  ProgressState state{p.fraction, s.axial_strain, s.stress_mpa, s.cracks_tension + s.cracks_shear, p.step, {}};
  if (model.config.experiment.type == ExperimentType::direct_shear) state.shear_displacement_mm = s.closure_mm;
  return state;
}

/// The tables' rows first: a checkpoint on the disk must find there what it says was written.
void save(Session& s, const Tables& tables) {
  const Timed timed(s.state.cost.output_s);
  s.folder.require_in_place();
  tables.curves.sync();
  tables.energy.sync();
  s.checkpoints.write(s.model, s.state);
}

void compute(Session& s, const ParallelLoops& loops) {
  Tables tables = open_tables(s);
  const CurveLayout layout = curve_layout(s.model);
  RunCost& cost = s.state.cost;
  const RunCost before = cost;
  const Stopwatch watch;
  const auto save_with_cost = [&] {
    cost.compute_s = before.compute_s + watch.seconds() - (cost.output_s - before.output_s);
    save(s, tables);
  };
  const ProgressStyle style = s.options.quiet ? ProgressStyle::quiet : progress_style_of_stderr();
  Progress progress(experiment_name(s.model.config.experiment.type), style, std::cerr);
  Stopwatch since_checkpoint;
  RunObserver observer;
  observer.on_sample = [&](const Sample& sample) {
    const Timed timed(cost.output_s);
    tables.curves.append(curve_row(sample, layout));
    tables.energy.append(energy_row(sample, layout));
  };
  observer.on_frame = [&](const Frame& frame) {
    const Timed timed(cost.output_s);
    s.folder.require_in_place();
    tables.series.write(frame);
  };
  observer.on_progress = [&](const RunProgress& p) { progress.update(progress_state(p, s.model)); };
  observer.interrupted = [] { return interruption_requested(); };
  observer.checkpoint_due = [&] { return since_checkpoint.seconds() >= s.model.config.output.checkpoint_interval_s; };
  observer.write_checkpoint = [&] {
    save_with_cost();
    since_checkpoint = Stopwatch();
  };
  run_experiment(s.model, s.state, loops, observer);
  save_with_cost();
  if (!s.state.samples.empty()) progress.finish(progress_state({1.0, &s.state.samples.back(), s.model.system.step}, s.model));
}

void write_results(Session& s) {
  Summary summary = summarise(s.model, s.state);
  summary.cost["steps"] = s.model.system.step;
  summary.cost["threads"] = s.manifest.threads;
  summary.cost["mesh_s"] = s.manifest.timings_s["mesh_s"];
  summary.cost["compute_s"] = s.state.cost.compute_s;
  summary.cost["output_s"] = s.state.cost.output_s;
  write_summary(s.folder.summary(), summary);
  s.manifest.warnings = summary.warnings;
  for (const std::string& warning : summary.warnings) log_warning(warning);
}

void end(Session& s, Outcome outcome, const std::string& reason) {
  s.manifest.timings_s["compute_s"] = s.state.cost.compute_s;
  s.manifest.timings_s["output_s"] = s.state.cost.output_s;
  end_manifest(s.manifest, outcome, reason);
  s.folder.require_in_place();
  write_manifest(s.folder.manifest(), s.manifest);
  log_info(reason);
  close_log_file();
}

int interrupt(Session& s, const std::string& reason) {
  write_crack_tables(s.folder, s.model);
  end(s, Outcome::interrupted, reason);
  std::cerr << "interrupted; go on with: asperity resume " << s.folder.root().string() << "\n";
  return kExitInterrupted;
}

void print_results(const std::filesystem::path& root) {
  const Summary summary = read_summary(root / "summary.json");
  for (const auto& [key, value] : summary.results.items()) std::cout << key << " " << value << "\n";
  std::cout << root.string() << std::endl;
}

/// A run made with --no-render is finished, but has no pictures yet; one that was cut off behind its last picture has no
/// page. Returns false where a signal ended the drawing.
bool draw_if_missing(const RunConfig& config, const std::filesystem::path& root, const SessionOptions& options) {
  if (!options.render || config.output.frames == 0) return true;
  const std::vector<int> frames = frames_to_draw(root, config.output);
  if (frames.empty() && std::filesystem::exists(root / "report.html")) return true;
  const RunFolder folder = RunFolder::open(root);
  if (!frames.empty() && !draw_until_interrupted(folder, config.output, frames)) return false;
  draw_strip(folder, config);
  write_run_report(root);
  return true;
}

int reuse(const RunConfig& config, const std::string& original, const std::filesystem::path& root,
          const SessionOptions& options) {
  std::cerr << "this run is already there, made by the same code; --force runs it again\n";
  const MeasuredCopy measured = measured_copy(config);
  if (config.output.frames > 0 && !has_measured(config, root, measured)) renew_measured(config, original, root, measured);
  if (!draw_if_missing(config, root, options)) return kExitInterrupted;
  print_results(root);
  return 0;
}

/// Plots, and the pictures that are missing; neither where tables are all that is wanted: drawing takes as long as a
/// small run. Returns false where a signal ended the drawing.
bool draw(Session& s) {
  if (s.model.config.output.frames == 0) return true;
  const RunConfig& config = s.model.config;
  draw_plots(s.folder, config);
  if (!s.options.render) return true;
  const Timed timed(s.manifest.timings_s["render_s"]);
  draw_strip(s.folder, config);
  return draw_until_interrupted(s.folder, config.output, frames_to_draw(s.folder.root(), config.output));
}

/// The error with what is left of the run: only states that have passed the guards become checkpoints. What is left
/// stands on lines of its own: it depends on the clock, the error does not.
Error with_last_checkpoint(const Session& s, const Error& error) {
  const std::string root = s.folder.root().string();
  const auto saved = s.checkpoints.newest();
  const std::string last = saved ? "The last checkpoint, of step " + std::to_string(saved->step) + ", is " +
                                       saved->file.string() + "; `asperity resume " + root +
                                       "` goes on from it, and fails in the same way unless the code changes"
                                 : "There is no checkpoint yet: /output/checkpoint_interval_s is the time between them";
  return {error.kind(),
          std::string(error.what()) + ".\n" + last + ". " + root + "/fields.pvd and curves.csv show the way here"};
}

int carry_out(Session& s, const ParallelLoops& loops) {
  if (s.state.stop == StopReason::running) {
    clear_pictures(s.folder);  // drawn by hand of a shorter run, they have its ranges
    compute(s, loops);
  }
  if (s.state.stop == StopReason::interrupted) return interrupt(s, "interrupted; a checkpoint was written");
  write_crack_tables(s.folder, s.model);
  write_results(s);
  if (!draw(s)) return interrupt(s, "interrupted while pictures were drawn; all is computed");
  end(s, Outcome::finished, describe(s.state.stop));
  if (s.options.render && s.model.config.output.frames > 0) write_run_report(s.folder.root());
  s.checkpoints.remove();
  print_results(s.folder.root());
  return 0;
}

void end_as_failed(Session& s, const std::string& reason) {
  try {
    end(s, Outcome::failed, reason);
  } catch (const std::exception&) {  // e.g. the disk is full: the first failure is the one to tell
  }
}

int carry_out_or_fail(Session& s, const ParallelLoops& loops) {
  try {
    return carry_out(s, loops);
  } catch (const Error& error) {
    const Error told = error.kind() == ErrorKind::numerical ? with_last_checkpoint(s, error) : error;
    end_as_failed(s, told.what());
    throw told;
  } catch (const std::exception& error) {
    end_as_failed(s, error.what());
    throw;
  }
}

/// Builds the model, timed, with the threads that were asked for or that suit its size.
struct Build {
  std::unique_ptr<ParallelLoops> loops;
  Model model;
  double seconds = 0;
};

Build build(const RunConfig& config, const SessionOptions& options) {
  const Stopwatch watch;
  Build b;
  b.loops = std::make_unique<ParallelLoops>(std::max(1, options.threads));
  b.model = build_model(config, *b.loops);
  if (options.threads == 0) b.loops = std::make_unique<ParallelLoops>(default_threads(b.model.mesh.triangles.size()));
  b.seconds = watch.seconds();
  return b;
}

Manifest new_manifest(const Build& b, const std::string& hash) {
  Manifest m = started_manifest();
  m.libraries = library_versions();
  m.threads = b.loops->threads();
  m.seed = b.model.config.particles.seed;
  m.config_name = b.model.config.name;
  m.config_hash = hash;
  m.time_step_s = b.model.system.time_step;
  m.timings_s["mesh_s"] = b.seconds;
  m.mesh = mesh_quality_entries(measure_quality(b.model.mesh));
  return m;
}

/// A refused checkpoint does not matter as long as the other is whole.
void tell_refused(const std::vector<Fault>& refused, const CheckpointPair& checkpoints) {
  for (const Fault& fault : refused) {
    log_warning(fault.where + ": " + fault.what + "; goes on from the other checkpoint, " +
                checkpoints.newest()->file.string());
  }
}

/// `doubts` is what the log and stderr are to be told once there is a log.
int run_in(RunFolder folder, Build b, const std::string& hash, const SessionOptions& options,
           const std::vector<std::string>& doubts) {
  Manifest manifest = new_manifest(b, hash);
  CheckpointPair checkpoints(folder.checkpoint(), hash);
  RunState state = start_run(b.model);
  // Checkpoints that are refused must leave the folder as it was: they are read before anything is written.
  const bool resumed = checkpoints.any();
  std::vector<Fault> refused;
  if (resumed) refused = checkpoints.read(b.model, state);
  Session session{std::move(folder),      std::move(b.model),  std::move(state),
                  std::move(checkpoints), std::move(manifest), options};
  write_manifest(session.folder.manifest(), session.manifest);
  open_log_file(session.folder.log(), session.manifest.libraries);
  for (const std::string& doubt : doubts) log_warning(doubt);
  tell_refused(refused, session.checkpoints);
  if (resumed) log_info("resumed at step " + std::to_string(session.model.system.step));
  return carry_out_or_fail(session, *b.loops);
}

}  // namespace

int run_from_start(const RunConfig& config, const std::string& original, const std::filesystem::path& root,
                   ExistingRun existing, const SessionOptions& options) {
  const std::string hash = config_hash(config);
  const RunIdentity identity = identity_of(hash);
  if (decide_folder_use(root, identity, existing).use == FolderUse::reuse) {
    return reuse(config, original, root, options);
  }
  const MeasuredCopy measured = measured_copy(config);
  Build b = build(config, options);
  RunFolder folder = RunFolder::begin(root, identity, existing);
  write_configs(folder, config, original, measured);
  if (measured.given) b.model.config.output.measured_curve = folder.measured_curve().string();
  return run_in(std::move(folder), std::move(b), hash, options, {});
}

int resume_run(const std::filesystem::path& root, const SessionOptions& options) {
  if (cut_off_at_start(root)) {
    return run_from_start(read_run_config(root / "config.effective.json"), read_file(root / "config.original.json"),
                          root, ExistingRun::keep, options);
  }
  RunFolder folder = RunFolder::open(root);
  const Manifest old = read_manifest(folder.manifest());
  if (old.outcome == Outcome::finished) {
    std::cerr << "this run is finished\n";
    print_results(folder.root());
    return 0;
  }
  const RunConfig config = read_run_config(folder.effective_config());
  const std::string hash = config_hash(config);
  if (hash != old.config_hash) {
    throw Error(ErrorKind::output,
                {{folder.effective_config().string(), "is not the configuration this run was started with", hash,
                  old.config_hash, "start a new run with `asperity run`"}});
  }
  std::vector<std::string> doubts;
  if (!same_code(identity_of(hash), old)) {
    doubts.push_back("this run was begun by other code, revision " + old.build.revision +
                     ": the result may not be the one of a run in one piece");
  }
  return run_in(std::move(folder), build(config, options), hash, options, doubts);
}

}  // namespace asperity::app
