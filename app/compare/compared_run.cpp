#include "app/compare/compared_run.hpp"

#include "app/report/run_report.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/config/enum_words.hpp"
#include "core/config/read_config.hpp"
#include "core/output/shallow_json.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

Error refusal(const fs::path& folder, const std::string& what, const std::string& allowed, const std::string& hint) {
  return Error(ErrorKind::config, {{folder.string(), what, "", allowed, hint}});
}

/// The folder's name also where the path ends in "/" or is ".".
std::string name_of(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

void require_run(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw refusal(folder, "is no folder", "a folder that `asperity run` has written", "");
  if (!is_run_folder(folder)) {
    throw refusal(folder, "holds no run: manifest.json or config.effective.json is missing",
                  "a folder that `asperity run` has written", "");
  }
  for (const char* table : {"curves.csv", "energy.csv", "cracks.csv"}) {
    if (fs::exists(folder / table)) continue;
    throw refusal(folder, std::string("the run has no ") + table, "a run that has come to its end or was interrupted",
                  "`asperity resume " + folder.string() + "` goes on with it");
  }
}

}  // namespace

ComparedRun read_compared_run(const fs::path& folder) {
  require_run(folder);
  ComparedRun run{folder,
                  "",
                  name_of(folder),
                  read_run_config(folder / "config.effective.json"),
                  parse_shallow_json(read_file(folder / "config.effective.json"), folder / "config.effective.json"),
                  read_manifest(folder / "manifest.json"),
                  read_csv(folder / "curves.csv"),
                  read_csv(folder / "energy.csv"),
                  read_csv(folder / "cracks.csv"),
                  {}};
  run.frames = run_frames(folder, run.curves, run.config.experiment.type);
  if (run.frames.empty()) {
    throw refusal(folder, "the run has no frames, so it has no patterns", "a run with /output/frames above 0",
                  "run it again with --set /output/frames=20");
  }
  return run;
}

std::vector<ComparedRun> read_compared_runs(const std::vector<fs::path>& folders) {
  if (folders.size() < kFewestCompared || folders.size() > kMostCompared) {
    throw Error(ErrorKind::usage,
                {{"RUN_DIR", "is given " + std::to_string(folders.size()) + (folders.size() == 1 ? " time" : " times"),
                  "", "2 to 12 run folders",
                  folders.size() == 1 ? "--montage shows one run through time" : "compare them in groups"}});
  }
  std::vector<ComparedRun> runs;
  for (const fs::path& folder : folders) {
    runs.push_back(read_compared_run(folder));
    runs.back().letter = std::string(1, static_cast<char>('A' + runs.size() - 1));
    const ExperimentType first = runs.front().config.experiment.type, own = runs.back().config.experiment.type;
    if (own == first) continue;
    throw Error(ErrorKind::config, {{folder.string(), "is a run of another experiment than " + folders.front().string(),
                                     std::string(word(own)), std::string(word(first)),
                                     "patterns of different experiments have no common scale; compare each kind by "
                                     "itself"}});
  }
  return runs;
}

}  // namespace asperity::app
