#pragma once
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/atomic_file.hpp"
#include "core/campaign/campaign.hpp"
#include "core/campaign/stored_run.hpp"
#include "core/output/manifest.hpp"
#include "core/output/run_files.hpp"

namespace asperity::testing {

namespace fs = std::filesystem;

inline RunConfig config_of_seed(std::uint64_t seed) {
  RunConfig config;
  config.particles.seed = seed;
  return config;
}

inline CampaignRun run_of_seed(std::uint64_t seed) { return {"seed " + std::to_string(seed), config_of_seed(seed)}; }

/// What the fake does unless it is told otherwise, in the shell's words: $folder is the run folder, $verb how it was
/// called, `finish` and `leave` end a run as Asperity would.
inline constexpr const char* kFinish = "finish";

/// A shell script in the place of the executable, in a scratch folder with a store of its own. It leaves manifests of
/// this test's own code, so that the engine takes its runs for runs of the same build.
class FakeAsperity {
 public:
  explicit FakeAsperity(const std::string& name) : root_(fs::path(ASPERITY_TEST_SCRATCH) / "campaign" / name) {
    fs::remove_all(root_);
    for (const char* folder : {"do", "calls", "manifests"}) fs::create_directories(root_ / folder);
    write_program(root_ / "asperity", R"(here='FOLDER'
verb=$1
if [ "$verb" = run ]; then folder=$4; else folder=$2; fi
id=$(basename "$folder")
echo "$*" >> "$here/calls/$id"
leave() { mkdir -p "$folder"; : > "$folder/.asperity.lock"; cp "$here/manifests/$id.$1" "$folder/manifest.json"; }
finish() { leave finished; exit 0; }
if [ -e "$here/do/$id" ]; then . "$here/do/$id"; fi
finish
)");
  }

  const fs::path& root() const { return root_; }
  fs::path store() const { return root_ / "store"; }
  fs::path executable() const { return root_ / "asperity"; }
  StoredRun files(std::uint64_t seed) const { return stored_run(store(), config_of_seed(seed)); }

  /// A script that can be run; FOLDER in it becomes the scratch folder.
  void write_program(const fs::path& path, std::string text) const {
    const std::string mark = "FOLDER";
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
      text.replace(at, mark.size(), root_.string());
    fs::create_directories(path.parent_path());
    std::ofstream(path) << "#!/bin/sh\n" << text;
    fs::permissions(path, fs::perms::owner_all);
  }

  /// What the run of this seed does, in shell.
  void let(std::uint64_t seed, const std::string& shell) const {
    std::ofstream(root_ / "do" / files(seed).id) << shell << "\n";
  }

  /// How often the run of this seed was called, and how: "run ..." or "resume ...".
  std::vector<std::string> calls(std::uint64_t seed) const {
    std::ifstream file(root_ / "calls" / files(seed).id);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
  }

  /// Manifests for the fake to leave, and runs for the campaign, with seeds 1 to `count`.
  std::vector<CampaignRun> runs(std::uint64_t count) const {
    std::vector<CampaignRun> list;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
      list.push_back(run_of_seed(seed));
      write_manifests(seed);
    }
    return list;
  }

  CampaignOptions options(int jobs = 2) const {
    CampaignOptions o;
    o.store = store();
    o.executable = executable();
    o.jobs = jobs;
    return o;
  }

 private:
  void write_manifests(std::uint64_t seed) const {
    const StoredRun run = files(seed);
    for (const auto& [outcome, word] :
         {std::pair{Outcome::finished, "finished"}, {Outcome::interrupted, "interrupted"}}) {
      Manifest manifest = started_manifest();
      manifest.config_hash = run.identity.config_hash;
      manifest.timings_s["compute_s"] = 2.0;
      end_manifest(manifest, outcome, std::string("the fake's reason: ") + word);
      write_manifest(root_ / "manifests" / (run.id + "." + word), manifest);
    }
  }

  fs::path root_;
};

}  // namespace asperity::testing
