#include "core/output/run_folder.hpp"

#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "core/base/atomic_file.hpp"
#include "core/base/output_error.hpp"
#include "core/output/manifest.hpp"
#include "core/output/run_files.hpp"

namespace asperity {
namespace {

namespace fs = std::filesystem;

Error refusal(const fs::path& root, const std::string& what, const std::string& value, const std::string& hint) {
  return {ErrorKind::output, {{root.string(), what, value, "", hint}}};
}

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::finished:
      return "finished";
    case Outcome::interrupted:
      return "interrupted";
    case Outcome::failed:
      return "failed";
    case Outcome::running:
      break;
  }
  return "broken off";
}

/// A folder without a manifest of ours: empty, cut off before its manifest was written, or a stranger's.
FolderDecision decide_without_manifest(const fs::path& root) {
  const FolderContent content = content_of(root);
  if (content == FolderContent::vacant) return {FolderUse::create, "the folder is empty"};
  if (content == FolderContent::run_files && fs::exists(root / kLockName)) {
    return {FolderUse::restart, "the run in it was cut off at its start"};
  }
  throw refusal(root, "holds files that are no run of Asperity", "", "choose another folder with --out");
}

FolderDecision decide_with_manifest(const fs::path& root, const RunIdentity& identity, const Manifest& manifest) {
  if (!same_config(identity, manifest)) {
    throw refusal(root, "holds a run of another configuration", manifest.config_name,
                  "choose another folder with --out, or replace that run with --force");
  }
  if (manifest.outcome != Outcome::finished) {
    return {FolderUse::restart, std::string("the run in it was ") + name_of(manifest.outcome)};
  }
  if (!same_code(identity, manifest)) {
    return {FolderUse::restart, "the run in it was made by other code, revision " + manifest.build.revision};
  }
  return {FolderUse::reuse, "a finished run of the same configuration and code lies there"};
}

std::string host_and_process() {
  char host[256] = "";
  ::gethostname(host, sizeof host - 1);
  return "process " + std::to_string(::getpid()) + " on " + host;
}

FileDescriptor lock_folder(const fs::path& root) {
  FileDescriptor lock(root / kLockName, O_RDWR | O_CREAT);
  if (::flock(lock.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) throw output_error(lock.path(), "cannot be locked", errno);
    throw refusal(root, "another run writes there", read_file(lock.path()),
                  "wait for it, or choose another folder with --out");
  }
  if (::ftruncate(lock.get(), 0) != 0) throw output_error(lock.path(), "cannot be written", errno);
  lock.write_all(host_and_process());
  return lock;
}

/// A run whose files are being cleared must not be taken for finished if the clearing is cut off.
void mark_as_cut_off(const fs::path& manifest_file) {
  std::optional<Manifest> manifest = find_manifest(manifest_file);
  if (!manifest) return;
  manifest->outcome = Outcome::running;
  write_manifest(manifest_file, *manifest);
}

void create_folder(const fs::path& root) try {
  fs::create_directories(root);
} catch (const fs::filesystem_error& failure) {
  throw output_error(root, "cannot be created", failure.code().value());
}

}  // namespace

fs::path default_run_folder(const std::string& config_name) {
  if (config_name.empty() || config_name.front() == '.' || config_name.find('/') != std::string::npos) {
    throw Error(ErrorKind::config, {{"/name", "is no folder name", config_name,
                                     "a name without \"/\" that does not begin with \".\"", ""}});
  }
  return fs::path("outputs") / config_name;
}

FolderDecision decide_folder_use(const fs::path& root, const RunIdentity& identity, ExistingRun existing) try {
  if (!fs::exists(root)) return {FolderUse::create, "the folder is new"};
  if (!fs::is_directory(root)) throw refusal(root, "is no folder", "", "choose another folder with --out");
  const std::optional<Manifest> manifest = find_manifest(root / "manifest.json");
  if (!manifest) return decide_without_manifest(root);
  if (existing == ExistingRun::replace) return {FolderUse::restart, "the run in it is replaced (--force)"};
  return decide_with_manifest(root, identity, *manifest);
} catch (const fs::filesystem_error& failure) {
  throw output_error(root, "cannot be read", failure.code().value());
}

bool cut_off_at_start(const fs::path& root) {
  return fs::exists(root / kLockName) && fs::exists(root / "config.effective.json") &&
         !fs::exists(root / "manifest.json");
}

bool is_written(const fs::path& root) {
  std::error_code unreadable;  // then nothing is known to write there, and what comes next says why
  if (!fs::exists(root / kLockName, unreadable)) return false;
  const FileDescriptor lock(root / kLockName, O_RDWR);
  return ::flock(lock.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

RunFolder::RunFolder(fs::path root, FolderDecision decision, std::optional<FileDescriptor> lock)
    : root_(std::move(root)), decision_(std::move(decision)), lock_(std::move(lock)) {}

RunFolder RunFolder::begin(const fs::path& root, const RunIdentity& identity, ExistingRun existing) {
  FolderDecision decision = decide_folder_use(root, identity, existing);
  if (decision.use == FolderUse::reuse) return {root, std::move(decision), std::nullopt};
  create_folder(root);
  FileDescriptor lock = lock_folder(root);
  // Another process may have run between the decision and the lock.
  decision = decide_folder_use(root, identity, existing);
  if (decision.use == FolderUse::reuse) return {root, std::move(decision), std::nullopt};
  mark_as_cut_off(root / "manifest.json");
  clear_run_files(root);
  create_run_subfolders(root);
  return {root, std::move(decision), std::move(lock)};
}

void RunFolder::require_in_place() const {
  struct stat locked {
  }, named{};
  const bool same = lock_ && ::fstat(lock_->get(), &locked) == 0 && ::stat((root_ / kLockName).c_str(), &named) == 0 &&
                    locked.st_dev == named.st_dev && locked.st_ino == named.st_ino;
  if (same) return;
  throw refusal(root_, "was removed, moved or replaced while the run went on", "",
                "where it was moved, `asperity resume` goes on from its last checkpoint there");
}

RunFolder RunFolder::open(const fs::path& root) {
  if (!find_manifest(root / "manifest.json")) {
    throw refusal(root, "is no run folder of Asperity", "",
                  "a run cut off before its start is begun with `asperity run`");
  }
  return {root, {FolderUse::open, "opened as it lies there"}, lock_folder(root)};
}

}  // namespace asperity
