#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/report/document.hpp"
#include "core/config/run_config.hpp"

/// What a confrontation's report reads: verdict.json, shown.json and manifest.json of its folder.
namespace asperity::app {

/// One curve over what was recorded, in the core's units; a simulated one with its run.
struct ShownCurve {
  std::string name;  ///< Of the specimen; empty of a run.
  std::vector<double> path, load;
  std::filesystem::path folder;            ///< Of the run.
  std::map<std::string, double> features;  ///< Of the run.
  std::string reason;                      ///< Why a run has no curve.
  double kinetic = 0;                      ///< Of the run, over the stored energy before the peak.
};

struct ShownTest {
  std::string id;
  ExperimentType experiment = ExperimentType::uniaxial;
  bool kept_back = false, path_is_gauge = false;
  std::optional<double> confining_pressure_mpa, normal_stress_mpa;
  std::map<std::string, std::vector<double>> features;  ///< One value a specimen; NaN: none.
  std::vector<ShownCurve> measured, base, extension;
};

/// A compared feature: residuals in standard deviations.
struct ShownSlot {
  std::string test, feature;
  double projected = 0;                ///< Without what calibration absorbs; Eq. (N11) of core/confrontation.
  double z_base = 0, z_extension = 0;  ///< NaN without an extension.
};

struct ShownCandidate {
  std::string id;
  bool suspect = false, two_sided = false, whole = false;
  double most = 0;                                           ///< Largest amplitude its parameters' ranges allow.
  double explained = 0, absorbed_share = 0, detectable = 0;  ///< NaN: at no amplitude.
  std::vector<double> projected;                             ///< A unit of amplitude, slot by slot.
};

struct ConfrontationData {
  std::filesystem::path folder;
  Value verdict, shown, manifest;
  std::vector<ShownTest> tests;
  std::vector<ShownSlot> slots;
  std::vector<ShownCandidate> candidates;
  std::vector<std::string> extension;  ///< Causes of the model that is shown beside the base; empty: none.
};

/// Prepares the documents. Throws Error(config) where a value has another type than expected, or vectors another length
/// than there are slots.
ConfrontationData confrontation_data(const std::filesystem::path& folder, Value verdict, Value shown, Value manifest);

const ShownCandidate* find_candidate(const ConfrontationData& data, const std::string& id);

/// The refitted single causes in the verdict's order; without any, those that explain something, the most first. At
/// most so many.
std::vector<std::string> leading_candidates(const ConfrontationData& data, std::size_t most);

/// Amplitude at which a fingerprint explains most of the residual, not below 0 for a mechanism of one sign.
double explaining_amplitude(const ConfrontationData& data, const ShownCandidate& candidate);

/// Cosine between two projected fingerprints; NaN where one has no length.
double cosine(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace asperity::app
