#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/build_info.hpp"

namespace asperity {

struct MeshQuality;

/// How a run stands: "running" also remains after a crash.
enum class Outcome { running, finished, interrupted, failed };

/// The processor a run was made on.
struct Host {
  std::string cpu_model;  ///< "unknown" where the system does not say.
  unsigned cores = 0;     ///< Logical processors.
};

/// Where a result comes from: manifest.json of a run folder. Times are UTC, ISO 8601.
struct Manifest {
  BuildInfo build;
  std::string executable_sha256;                 ///< Of a build that no revision identifies; else empty.
  std::map<std::string, std::string> libraries;  ///< "VTK" -> "9.1.0".
  Host host;
  int threads = 1;
  std::uint64_t seed = 0;
  std::string config_name;
  std::string config_hash;  ///< Of the effective configuration.
  std::string started_utc;
  std::string ended_utc;                    ///< Empty while it runs.
  double time_step_s = 0;                   ///< 0 before it is known.
  std::map<std::string, double> timings_s;  ///< "mesh_s", "compute_s", "output_s", "render_s".
  std::map<std::string, double> mesh;       ///< mesh_quality_entries().
  std::vector<std::string> warnings;
  Outcome outcome = Outcome::running;
  std::string exit_reason;  ///< Why it ended: stop rule, signal, error.
};

/// A manifest of this executable on this machine that starts now.
Manifest started_manifest();

/// Sets outcome, reason and end time.
void end_manifest(Manifest& manifest, Outcome outcome, const std::string& exit_reason);

/// MeshQuality by name, each with its unit: "edge_mean_mm", "angle_min_deg", ...
std::map<std::string, double> mesh_quality_entries(const MeshQuality& quality);

/// Replaces the file atomically. Throws Error(output).
void write_manifest(const std::filesystem::path& path, const Manifest& manifest);

/// Throws Error(output) where the file is missing or no manifest of Asperity.
Manifest read_manifest(const std::filesystem::path& path);

/// The same for a text that is already there; `name` stands for the file in errors.
Manifest parse_manifest(std::string_view text, const std::filesystem::path& name);

/// The manifest, or nothing where the file is missing or not Asperity's.
std::optional<Manifest> find_manifest(const std::filesystem::path& path);

/// The present time, "2024-05-01T12:34:56Z".
std::string utc_now();

}  // namespace asperity
