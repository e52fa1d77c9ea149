#include "core/output/run_identity.hpp"

#include "core/base/atomic_file.hpp"
#include "core/base/build_info.hpp"
#include "core/base/sha256.hpp"
#include "core/output/manifest.hpp"

namespace asperity {
namespace {

bool names_the_code(const std::string& revision, bool dirty) { return !dirty && revision != "unknown"; }

}  // namespace

std::string this_executable_sha256_if_unnamed() {
  const BuildInfo& build = build_info();
  static const std::string hash =
      names_the_code(build.revision, build.dirty) ? "" : sha256_hex(read_file("/proc/self/exe"));
  return hash;
}

RunIdentity identity_of(const std::string& config_hash) {
  const BuildInfo& build = build_info();
  return {config_hash, build.revision, build.dirty, this_executable_sha256_if_unnamed()};
}

bool same_config(const RunIdentity& identity, const Manifest& manifest) {
  return identity.config_hash == manifest.config_hash;
}

bool same_code(const RunIdentity& identity, const Manifest& manifest) {
  if (identity.revision != manifest.build.revision || identity.dirty != manifest.build.dirty) return false;
  return names_the_code(identity.revision, identity.dirty) ||
         (!identity.executable_sha256.empty() && identity.executable_sha256 == manifest.executable_sha256);
}

}  // namespace asperity
