#include "core/confrontation/gathered_features.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/base/file_descriptor.hpp"
#include "core/base/log.hpp"
#include "core/base/output_error.hpp"
#include "core/base/sha256.hpp"
#include "core/output/run_identity.hpp"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNameDigits = 16;

fs::path gathered_file(const fs::path& store) { return store / ("features_" + code_key() + ".txt"); }

fs::path golden_file(const fs::path& store, const std::string& bank_sha256) {
  return store / ("golden_" + code_key() + "_" + bank_sha256.substr(0, kNameDigits) + ".txt");
}

/// One process at a time changes these files; the lock is held until the descriptor is closed.
FileDescriptor locked(const fs::path& store) {
  std::error_code error;
  fs::create_directories(store, error);
  if (error) throw output_error(store, "cannot be created", error.value());
  FileDescriptor lock(store / "features.lock", O_RDWR | O_CREAT);
  if (::flock(lock.get(), LOCK_EX) != 0) throw output_error(lock.path(), "cannot be locked", errno);
  return lock;
}

}  // namespace

std::string code_key() {
  const RunIdentity code = identity_of("");
  const std::string dirty = code.dirty ? "changed" : "clean";
  return sha256_hex(code.revision + " " + dirty + " " + code.executable_sha256).substr(0, kNameDigits);
}

FeatureBank read_gathered(const fs::path& store) {
  const fs::path file = gathered_file(store);
  if (!fs::exists(file)) return {};
  try {
    return read_bank(file);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::config) throw;
    log_warning(file.string() + " is damaged: features are read anew from the store's runs");
    return {};
  }
}

void add_gathered(const fs::path& store, const FeatureBank& more) {
  const FileDescriptor lock = locked(store);
  FeatureBank all = read_gathered(store);
  merge(all, more);
  write_bank(gathered_file(store), all);
}

bool golden_noted(const fs::path& store, const std::string& bank_sha256) {
  return fs::exists(golden_file(store, bank_sha256));
}

void note_golden(const fs::path& store, const std::string& bank_sha256) {
  const FileDescriptor lock = locked(store);
  write_file_atomically(golden_file(store, bank_sha256),
                        "this code gives the golden features of bank " + bank_sha256 + "\n");
}

}  // namespace asperity
