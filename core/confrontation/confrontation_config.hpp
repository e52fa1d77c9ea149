#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/campaign/slurm_config.hpp"
#include "core/confrontation/confrontation_parameter.hpp"
#include "core/confrontation/measured_data.hpp"

/// A confrontation of measured tests with a model (configs/schema/confrontation.schema.json).
namespace asperity {

/// The run configuration that the virtual tests of one experiment are made of.
struct ConfrontationBase {
  nlohmann::json document;       ///< Without keys that have no meaning in the experiment.
  std::filesystem::path origin;  ///< File that relative paths in it start from.
};

/// Sizes that the measured file leaves out, and why these stand in for them.
struct AssumedGeometry {
  std::optional<double> width_mm, height_mm, diameter_mm;
  std::vector<ToothConfig> profile;
  std::optional<double> end_gap_mm;
  std::string why;
};

/// For the report: what stands in for something that was not measured.
struct DeclaredValue {
  std::string what, value, why;
};

/// Parameters at which effects are linearised.
enum class LineariseAt { calibrated, reference };

/// How many meshes each purpose gets.
struct MeshCounts {
  std::size_t noise = 16;  ///< Of each test, for the scatter.
  std::size_t common = 8;  ///< For effects, and for the base beside them.
  std::size_t screen = 3;  ///< Of those, for a first look at a mechanism.
  std::size_t fresh = 16;  ///< Of each kept-back test, apart from the others.
  std::uint64_t first_seed = 1;
};

struct ConfrontationConfig {
  std::string name, description;
  std::filesystem::path path, measured_path;
  nlohmann::json document;  ///< As given, with the overrides.
  MeasuredData measured;    ///< Each test has its `use`.
  std::map<ExperimentType, ConfrontationBase> bases;
  nlohmann::json set = nlohmann::json::object();   ///< Over every virtual test: value by pointer.
  std::map<std::string, nlohmann::json> test_set;  ///< The same over one test, by its id.
  AssumedGeometry assumed;
  std::vector<DeclaredValue> declared;
  std::vector<ConfrontationParameter> parameters;  ///< Without those that act in no test.
  std::vector<std::string> idle_parameters;        ///< Names of those.
  bool split_proposed = false;                     ///< `use` follows from the tests' kinds, not from the user.
  std::map<ExperimentType, std::vector<std::string>> features;  ///< Compared ones, by each experiment of a test.
  std::vector<std::string> mechanisms;                          ///< Candidates' ids, in alphabetical order.
  std::vector<std::string> left_out_suspects;                   ///< The solver's settings that could be, but are not.
  LineariseAt linearise_at = LineariseAt::calibrated;
  MeshCounts meshes;
  std::size_t draws = 400;
  double alarm_level = 0.02;  ///< Of the gate's largest explained part, by chance alone.
  std::uint64_t seed = 1;
  std::optional<std::filesystem::path> bank;
  SlurmConfig slurm;
};

/// Reads the file with the overrides ("/json/pointer=value", of its own keys) and the measured file. Throws one
/// Error(config) with every fault at its pointer: keys, ranges, bases, sizes that nobody gives, parameters that a base
/// does not have or that two bases have otherwise, unknown tests, features and mechanisms, virtual tests that are no
/// run.
ConfrontationConfig read_confrontation(const std::filesystem::path& path,
                                       const std::vector<std::string>& overrides = {});

/// The measured test of that id; nullptr where there is none.
const MeasuredTest* find_test(const MeasuredData& data, const std::string& id);

}  // namespace asperity
