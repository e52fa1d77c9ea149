#pragma once
#include <string>

namespace asperity {

struct Manifest;

/// What decides whether a finished run is the one asked for: the effective configuration and the code.
struct RunIdentity {
  std::string config_hash;
  std::string revision;
  bool dirty = false;
  std::string executable_sha256;  ///< Identifies the code where the revision cannot; else empty.
};

/// SHA-256 of the running executable if its revision does not name the code (changed files, or no revision known), else
/// empty: two dirty builds of one revision may differ, and the core is linked into the executable.
std::string this_executable_sha256_if_unnamed();

/// Identity of a run by this executable of the configuration with this hash; equal hashes mean equal results.
RunIdentity identity_of(const std::string& config_hash);

/// Whether the manifest's run was made from the same effective configuration.
bool same_config(const RunIdentity& identity, const Manifest& manifest);

/// Whether the manifest's run was made by the same code: same revision without changes, or else the same executable.
bool same_code(const RunIdentity& identity, const Manifest& manifest);

}  // namespace asperity
