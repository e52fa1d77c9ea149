#include "app/run_session.hpp"

#include <chrono>
#include <fstream>
#include <iostream>
#include <memory>

#include "app/interruption.hpp"
#include "app/libraries.hpp"
#include "app/pictures.hpp"
#include "app/progress.hpp"
#include "core/base/error.hpp"
#include "core/base/log.hpp"
#include "core/config/read_config.hpp"
#include "core/config/write_config.hpp"
#include "core/experiment/checkpoint.hpp"
#include "core/experiment/summarise.hpp"
#include "core/measurement/acoustic.hpp"
#include "core/measurement/capture.hpp"
#include "core/measurement/crack_network.hpp"
#include "core/base/atomic_file.hpp"
#include "core/output/csv.hpp"
#include "core/output/manifest.hpp"
#include "core/output/run_tables.hpp"
#include "render/series.hpp"

namespace asperity::app {
namespace {

constexpr double kCheckpointInterval = 60.0;  // s of wall time

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
  std::string hash;
  Manifest manifest;
  SessionOptions options;
  double output_s = 0;
  double compute_s = 0;

  std::filesystem::path checkpoint_file() const { return folder.checkpoint() / "state.bin"; }
};

struct Tables {
  CsvTable curves, energy;
  render::SeriesWriter series;
};

Tables open_tables(const Session& s) {
  const RunFolder& f = s.folder;
  const std::size_t rows = s.state.samples.size();
  if (rows == 0) {
    return {CsvTable::create(f.curves(), curve_columns()), CsvTable::create(f.energy(), energy_columns()),
            render::SeriesWriter(f.root())};
  }
  return {CsvTable::resume(f.curves(), curve_columns(), rows), CsvTable::resume(f.energy(), energy_columns(), rows),
          render::SeriesWriter(f.root(), s.state.frames)};
}

ProgressState progress_state(const RunProgress& p) {
  const Sample& s = *p.sample;
  return {p.fraction, s.axial_strain, s.stress_mpa, s.cracks_tension + s.cracks_shear, p.step};
}

void compute(Session& s, const ParallelLoops& loops) {
  Tables tables = open_tables(s);
  const ProgressStyle style = s.options.quiet ? ProgressStyle::quiet : progress_style_of_stderr();
  Progress progress(experiment_name(s.model.config.experiment.type), style, std::cerr);
  Stopwatch since_checkpoint;
  RunObserver observer;
  observer.on_sample = [&](const Sample& sample) {
    const Timed timed(s.output_s);
    tables.curves.append(curve_row(sample));
    tables.energy.append(energy_row(sample));
  };
  observer.on_frame = [&](const Frame& frame) {
    const Timed timed(s.output_s);
    tables.series.write(frame);
  };
  observer.on_progress = [&](const RunProgress& p) { progress.update(progress_state(p)); };
  observer.interrupted = [] { return interruption_requested(); };
  observer.between_steps = [&] {
    if (since_checkpoint.seconds() < kCheckpointInterval) return;
    const Timed timed(s.output_s);
    write_checkpoint(s.checkpoint_file(), s.model, s.state, s.hash);
    since_checkpoint = Stopwatch();
  };
  const Stopwatch watch;
  const double output_before = s.output_s;
  run_experiment(s.model, s.state, loops, observer);
  s.compute_s += watch.seconds() - (s.output_s - output_before);
  if (!s.state.samples.empty()) progress.finish(progress_state({1.0, &s.state.samples.back(), s.model.system.step}));
}

void write_crack_tables(const Session& s) {
  std::vector<Crack> cracks = list_cracks(s.model.system.contacts, s.model.system.particles);
  for (Crack& crack : cracks) crack.energy_n_mm *= s.model.config.experiment.thickness_mm;
  CsvTable table = CsvTable::create(s.folder.crack_table(), crack_columns());
  for (const Crack& crack : cracks) table.append(crack_row(crack));
  CsvTable events = CsvTable::create(s.folder.events(), event_columns());
  for (const AcousticEvent& event : group_events(cracks, s.model.config)) events.append(event_row(event));
}

void write_results(Session& s) {
  Summary summary = summarise(s.model, s.state);
  summary.cost["steps"] = s.model.system.step;
  summary.cost["threads"] = s.manifest.threads;
  summary.cost["mesh_s"] = s.manifest.timings_s["mesh_s"];
  summary.cost["compute_s"] = s.compute_s;
  summary.cost["output_s"] = s.output_s;
  write_summary(s.folder.summary(), summary);
  s.manifest.warnings = summary.warnings;
  for (const std::string& warning : summary.warnings) log_warning(warning);
}

void end(Session& s, Outcome outcome, const std::string& reason) {
  s.manifest.timings_s["compute_s"] = s.compute_s;
  s.manifest.timings_s["output_s"] = s.output_s;
  end_manifest(s.manifest, outcome, reason);
  write_manifest(s.folder.manifest(), s.manifest);
  log_info(reason);
  close_log_file();
}

int interrupt(Session& s) {
  write_checkpoint(s.checkpoint_file(), s.model, s.state, s.hash);
  write_crack_tables(s);
  end(s, Outcome::interrupted, "interrupted; a checkpoint was written");
  std::cerr << "interrupted; go on with: asperity resume " << s.folder.root().string() << "\n";
  return 130;
}

void print_results(const std::filesystem::path& root) {
  const Summary summary = read_summary(root / "summary.json");
  for (const auto& [key, value] : summary.results.items()) std::cout << key << " " << value << "\n";
  std::cout << root.string() << std::endl;
}

/// A run made with --no-render is finished, but has no pictures yet.
void draw_if_missing(const RunConfig& config, const std::filesystem::path& root, const SessionOptions& options) {
  if (!options.render || !std::filesystem::is_empty(root / "frames")) return;
  draw_frames(RunFolder::open(root), config.output, {}, "all");
}

int carry_out(Session& s, const ParallelLoops& loops) {
  try {
    compute(s, loops);
    if (s.state.stop == StopReason::interrupted) return interrupt(s);
    write_crack_tables(s);
    write_results(s);
    draw_plots(s.folder, s.model.config.experiment.type);
    if (s.options.render) {
      double render_s = 0;
      {
        const Timed timed(render_s);
        draw_frames(s.folder, s.model.config.output, {}, "all");
      }
      s.manifest.timings_s["render_s"] = render_s;
    }
  } catch (const std::exception& error) {
    try {
      end(s, Outcome::failed, error.what());
    } catch (const std::exception&) {  // e.g. the disk is full: the first failure is the one to tell
    }
    throw;
  }
  end(s, Outcome::finished, describe(s.state.stop));
  print_results(s.folder.root());
  return 0;
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

/// Computing and writing times of an interrupted run that is gone on with.
struct EarlierCost {
  double compute_s = 0, output_s = 0;
};

int run_in(RunFolder folder, Build b, const std::string& hash, const SessionOptions& options,
           const std::optional<EarlierCost>& earlier) {
  Manifest manifest = new_manifest(b, hash);
  Session session{std::move(folder), std::move(b.model), {}, hash, std::move(manifest), options};
  // A checkpoint that is refused must leave the folder as it was: it is read before anything is written.
  if (earlier) {
    read_checkpoint(session.checkpoint_file(), session.model, session.state, hash);
    session.compute_s = earlier->compute_s;
    session.output_s = earlier->output_s;
  } else {
    session.state = start_run(session.model);
  }
  write_manifest(session.folder.manifest(), session.manifest);
  open_log_file(session.folder.log(), session.manifest.libraries);
  if (earlier) log_info("resumed at step " + std::to_string(session.model.system.step));
  return carry_out(session, *b.loops);
}

}  // namespace

int run_from_start(const RunConfig& config, const std::string& original, const std::filesystem::path& root,
                   ExistingRun existing, const SessionOptions& options) {
  const std::string hash = config_hash(config);
  const RunIdentity identity = identity_of(hash);
  if (decide_folder_use(root, identity, existing).use == FolderUse::reuse) {
    std::cerr << "this run is already there, made by the same code; --force runs it again\n";
    draw_if_missing(config, root, options);
    print_results(root);
    return 0;
  }
  Build b = build(config, options);
  RunFolder folder = RunFolder::begin(root, identity, existing);
  write_file_atomically(folder.original_config(), original);
  write_file_atomically(folder.effective_config(), effective_json(config));
  return run_in(std::move(folder), std::move(b), hash, options, std::nullopt);
}

int resume_run(const std::filesystem::path& root, const SessionOptions& options) {
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
  std::optional<EarlierCost> earlier;
  if (std::filesystem::exists(folder.checkpoint() / "state.bin")) {
    earlier = EarlierCost{old.timings_s.contains("compute_s") ? old.timings_s.at("compute_s") : 0.0,
                          old.timings_s.contains("output_s") ? old.timings_s.at("output_s") : 0.0};
  }
  return run_in(std::move(folder), build(config, options), hash, options, earlier);
}

}  // namespace asperity::app
