#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace asperity {

inline constexpr const char* kSeedPointer = "/particles/seed";

/// One run of a campaign file before its configuration is read.
struct GridRun {
  std::string label;
  std::filesystem::path config;
  std::vector<std::string> overrides;  ///< "/json/pointer=value", later ones win.
};

struct Grid {
  std::vector<GridRun> runs;
  std::vector<std::string> varied;  ///< Pointers of "vary" and of each run's "set", each once.
};

/// The runs of a campaign document that holds to its schema: base (slowest), each entry of "vary", the seed (fastest),
/// then "runs" with their seeds. Paths are relative to `folder`. Throws Error(config) with every fault: no run at all,
/// "vary" without "base", a key varied twice, a key of "set" that is no pointer, a label given twice, too many runs.
Grid make_grid(const nlohmann::json& document, const std::filesystem::path& folder);

}  // namespace asperity
