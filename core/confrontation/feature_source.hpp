#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/test_suite.hpp"
#include "core/confrontation/feature_bank.hpp"

namespace asperity {

/// Features of one run, rounded to 9 significant digits wherever they come from.
struct RunFeatures {
  FeatureValues values;  ///< In the order of feature_kinds; empty where the run failed.
  std::string reason;    ///< Why it failed.
};

struct FeatureSourceOptions {
  std::filesystem::path store;                ///< Of the campaigns; features gathered by this code are kept there too.
  std::optional<std::filesystem::path> bank;  ///< A bank that others made.
  double check_share = 0;                     ///< Of the runs taken from that bank, computed again and compared.
  std::uint64_t check_seed = 1;               ///< Which ones.
};

/// What the features cost so far. A run that was asked for twice counts twice.
struct FeatureCost {
  std::size_t runs = 0, from_bank = 0, from_store = 0, computed = 0, failed = 0, checked = 0;
  double compute_s = 0;  ///< Of computed runs.
};

/// Answers for features of runs: from a bank, from what the store has gathered, else by campaign.
class FeatureSource {
 public:
  /// Reads the bank and has its golden runs computed, once for each code and bank. Throws Error(config) where the bank
  /// is damaged, or where this code gives other features than it holds; CalibrationInterrupted.
  FeatureSource(FeatureSourceOptions options, Simulator simulate);

  /// Features in the order of the runs. Throws CalibrationInterrupted; Error(tolerance) naming the run where one that
  /// was checked differs from the bank.
  std::vector<RunFeatures> features(const std::string& stage, const std::vector<CampaignRun>& runs);

  const FeatureCost& cost() const { return cost_; }

  /// Every run answered so far as a bank of its own, with golden runs computed for it. Throws CalibrationInterrupted,
  /// Error(unexpected) where a golden run fails.
  FeatureBank gathered(const std::vector<RunConfig>& golden);

 private:
  void require_golden_runs(const std::string& bank_sha256);
  void check(const std::string& stage, const std::vector<CampaignRun>& runs);
  void compute(const std::string& stage, const std::vector<CampaignRun>& runs, std::vector<RunFeatures>& answers,
               const std::vector<std::size_t>& missing);
  FeatureSourceOptions options_;
  Simulator simulate_;
  FeatureBank shipped_, own_, answered_;
  FeatureCost cost_;
};

}  // namespace asperity
