#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/run_frames.hpp"
#include "core/config/run_config.hpp"
#include "core/output/csv.hpp"
#include "core/output/manifest.hpp"

/// `asperity compare`: failure patterns of several runs, or of one run through time, at one scale.
namespace asperity::app {

/// How many runs, or frames of one run, a picture may show.
inline constexpr std::size_t kFewestCompared = 2, kMostCompared = 12;

/// A run folder as a comparison reads it.
struct ComparedRun {
  std::filesystem::path folder;
  std::string letter;  ///< "A", "B", ...: how pictures and tables call it.
  std::string name;    ///< The folder's.
  RunConfig config;
  nlohmann::ordered_json effective;  ///< config.effective.json.
  Manifest manifest;
  CsvData curves, energy, cracks;
  std::vector<RunFrame> frames;  ///< At least one.
};

/// Throws Error(config) where the folder is no run, or a run without frames or tables.
ComparedRun read_compared_run(const std::filesystem::path& folder);

/// Two to twelve runs of one experiment, lettered. Throws Error(usage) for another number, Error(config) as
/// read_compared_run and where experiments differ.
std::vector<ComparedRun> read_compared_runs(const std::vector<std::filesystem::path>& folders);

}  // namespace asperity::app
