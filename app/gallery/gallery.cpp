#include "app/gallery/gallery.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/config/enum_words.hpp"
#include "core/config/read_config.hpp"
#include "core/confrontation/run_curve.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

GalleryRuns runs_of(const RunConfig& base, const std::string& mechanism, const std::vector<std::uint64_t>& seeds) {
  GalleryRuns part{base.experiment.type, mechanism, {}, {}, {}};
  for (const std::uint64_t seed : seeds) {
    RunConfig config = base;
    config.particles.seed = seed;
    if (!mechanism.empty()) config.mechanisms.push_back({mechanism, std::nullopt, {}});
    const std::string name = mechanism.empty() ? "base" : mechanism;
    const double strips = with_mechanisms(config).extensions.strips;
    part.runs.push_back({std::string(word(base.experiment.type)) + " " + name + " seed=" + std::to_string(seed), config,
                         strips > 1.0 ? strips : 0.0});
  }
  return part;
}

/// Two bases of one experiment, or a base with mechanisms of its own, would make no gallery.
std::vector<RunConfig> read_bases(const std::vector<fs::path>& paths) {
  std::vector<RunConfig> bases;
  for (const fs::path& path : paths) {
    RunConfig config = read_run_config(path);
    const auto same = [&](const RunConfig& other) { return other.experiment.type == config.experiment.type; };
    if (std::any_of(bases.begin(), bases.end(), same)) {
      throw Error(ErrorKind::config, {{path.string() + ": /experiment/type", "is that of another base too",
                                       std::string(word(config.experiment.type)), "each experiment once", ""}});
    }
    if (!config.mechanisms.empty()) {
      throw Error(ErrorKind::config, {{path.string() + ": /mechanisms", "is not empty", "", "a base without mechanisms",
                                       "the gallery adds them one by one"}});
    }
    bases.push_back(std::move(config));
  }
  return bases;
}

bool finished(const GalleryRuns& part, std::size_t mesh) {
  return mesh < part.outcomes.size() && part.outcomes[mesh].status == RunStatus::finished;
}

std::vector<FeatureValue> features_of_run(const fs::path& folder) {
  const RunCurve run = read_run_curve(folder);
  return read_features(run.curve, reading_of_run(run.config));
}

}  // namespace

Gallery plan_gallery(const std::vector<fs::path>& paths, const std::vector<MechanismDeclaration>& mechanisms,
                     const std::vector<std::uint64_t>& seeds) {
  Gallery gallery{seeds, mechanisms, {}};
  const std::vector<RunConfig> bases = read_bases(paths);
  for (const RunConfig& base : bases) gallery.parts.push_back(runs_of(base, "", seeds));
  for (const MechanismDeclaration& m : mechanisms) {
    for (const RunConfig& base : bases) {
      if (acts_in(m, base.experiment.type)) gallery.parts.push_back(runs_of(base, m.id, seeds));
    }
  }
  return gallery;
}

const GalleryRuns* base_of(const Gallery& gallery, ExperimentType experiment) {
  for (const GalleryRuns& part : gallery.parts) {
    if (part.mechanism.empty() && part.experiment == experiment) return &part;
  }
  return nullptr;
}

void compare_features(Gallery& gallery) {
  for (GalleryRuns& part : gallery.parts) {
    if (part.mechanism.empty()) continue;
    const GalleryRuns& base = *base_of(gallery, part.experiment);
    std::vector<std::vector<FeatureValue>> before, with;
    for (std::size_t mesh = 0; mesh < gallery.seeds.size(); ++mesh) {
      if (!finished(base, mesh) || !finished(part, mesh)) continue;
      before.push_back(features_of_run(base.outcomes[mesh].folder));
      with.push_back(features_of_run(part.outcomes[mesh].folder));
    }
    part.changes = feature_changes(part.experiment, before, with);
  }
}

}  // namespace asperity::app
