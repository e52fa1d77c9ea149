#include "core/campaign/stored_run.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/base/output_error.hpp"
#include "core/config/write_config.hpp"
#include "core/output/manifest.hpp"
#include "core/output/run_folder.hpp"
#include "core/output/shallow_json.hpp"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kIdDigits = 16;  // 64 bits: among a million runs two share them with a chance of 3e-8

/// Same code as a manifest's, of which only these parts count.
bool same_code(const RunIdentity& identity, const Json& note) {
  Manifest made_by;
  made_by.build.revision = note.at("revision");
  made_by.build.dirty = note.at("dirty");
  made_by.executable_sha256 = note.at("executable_sha256");
  return asperity::same_code(identity, made_by);
}

/// A run that goes on from a checkpoint is the same as one in one piece only if the same code began it.
bool can_be_resumed(const StoredRun& run) {
  const std::optional<Manifest> manifest = find_manifest(run.folder / "manifest.json");
  return manifest && same_config(run.identity, *manifest) && asperity::same_code(run.identity, *manifest) &&
         manifest->outcome != Outcome::finished;
}

/// A run whose resuming could not read or write is begun anew: its checkpoints may be what is wrong.
RunView unfinished_view(const StoredRun& run) {
  const std::optional<Failure> failure = find_failure(run);
  if (failure && comes_again(failure->exit_code)) return {RunStand::failed, *failure};
  const bool resuming_failed = failure && failure->resumed;
  return {can_be_resumed(run) && !resuming_failed ? RunStand::resume : RunStand::start, {}};
}

/// Replaces a file of the store that several campaigns may write at once: each writes beside it under a name of its
/// own.
void replace_in_store(const fs::path& path, const std::string& text) {
  const fs::path own = path.string() + "." + std::to_string(::getpid());
  write_file_atomically(own, text);
  if (std::rename(own.c_str(), path.c_str()) != 0) throw output_error(path, "cannot be replaced", errno);
}

}  // namespace

StoredRun stored_run(const fs::path& store, const RunConfig& config) {
  const std::string hash = config_hash(config);
  const std::string id = hash.substr(0, kIdDigits);
  return {id,         identity_of(hash),     store / (id + ".json"),
          store / id, store / (id + ".log"), store / (id + ".failure.json")};
}

void write_config(const StoredRun& run, RunConfig config) {
  config.name = run.id;
  config.description.clear();
  const std::string text = effective_json(config);
  if (fs::exists(run.config) && read_file(run.config) == text) return;
  replace_in_store(run.config, text);
}

bool comes_again(int exit_code) {
  return exit_code == static_cast<int>(ErrorKind::config) || exit_code == static_cast<int>(ErrorKind::numerical) ||
         exit_code == static_cast<int>(ErrorKind::tolerance);
}

void write_failure(const StoredRun& run, const Failure& failure) {
  const Json note = {{"config_hash", run.identity.config_hash},
                     {"revision", run.identity.revision},
                     {"dirty", run.identity.dirty},
                     {"executable_sha256", run.identity.executable_sha256},
                     {"exit_code", failure.exit_code},
                     {"reason", failure.reason},
                     {"resumed", failure.resumed}};
  replace_in_store(run.failure, note.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<Failure> find_failure(const StoredRun& run) try {
  if (!fs::exists(run.failure)) return std::nullopt;
  const Json note = parse_shallow_json(read_file(run.failure), run.failure);
  if (note.at("config_hash") != run.identity.config_hash || !same_code(run.identity, note)) return std::nullopt;
  return Failure{note.at("exit_code"), note.at("reason"), note.at("resumed")};
} catch (const nlohmann::json::exception&) {
  return std::nullopt;  // a torn note says nothing: the run is tried again
} catch (const Error&) {
  return std::nullopt;
}

void clear_failure(const StoredRun& run) {
  std::error_code error;
  fs::remove(run.failure, error);
  if (error) throw output_error(run.failure, "cannot be removed", error.value());
}

RunEnd stored_end(const StoredRun& run) {
  const std::optional<Manifest> manifest = find_manifest(run.folder / "manifest.json");
  if (!manifest || !same_config(run.identity, *manifest)) return {};
  const auto seconds = manifest->timings_s.find("compute_s");
  return {manifest->exit_reason, seconds == manifest->timings_s.end() ? 0.0 : seconds->second};
}

RunView look_at(const StoredRun& run) try {
  if (is_written(run.folder)) return {RunStand::busy, {}};
  const FolderUse use = decide_folder_use(run.folder, run.identity, ExistingRun::keep).use;
  return use == FolderUse::reuse ? RunView{RunStand::finished, {}} : unfinished_view(run);
} catch (const Error& refusal) {
  return {RunStand::refused, {static_cast<int>(refusal.kind()), refusal.what(), false}};
}

}  // namespace asperity
