#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/config/run_config.hpp"

/// Features of runs in a text file, so that a verdict needs no run that was computed before.
namespace asperity {

/// In the order of feature_kinds; nothing where the curve does not reach the feature.
using FeatureValues = std::vector<std::optional<double>>;

/// One run of a bank, with 9 significant digits.
struct BankedRun {
  ExperimentType experiment = ExperimentType::uniaxial;
  FeatureValues values;
  bool operator==(const BankedRun&) const = default;
};

/// A run with its configuration and exact features: if this build gives the same ones, it would give the whole bank's.
struct GoldenRun {
  RunConfig config;
  FeatureValues values;
};

struct FeatureBank {
  std::map<std::string, BankedRun> runs;  ///< By bank_key().
  std::vector<GoldenRun> golden;
};

/// First 32 hexadecimal digits of config_hash.
std::string bank_key(const RunConfig& config);

/// To 9 significant digits, as a bank holds them.
double rounded(double value);
FeatureValues rounded(FeatureValues values);

/// Throws Error(config) at FILE:LINE where the file is damaged, of another format, or has other features than this
/// build.
FeatureBank read_bank(const std::filesystem::path& path);

/// Atomically. Throws Error(output).
void write_bank(const std::filesystem::path& path, const FeatureBank& bank);

/// The bank as text, and back; `origin` names it in faults.
std::string bank_text(const FeatureBank& bank);
FeatureBank parse_bank(const std::string& text, const std::string& origin);

/// The run of this key; nullptr where there is none.
const BankedRun* find_run(const FeatureBank& bank, const std::string& key);

/// Adds the runs of `more` that `bank` does not have.
void merge(FeatureBank& bank, const FeatureBank& more);

}  // namespace asperity
