#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
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
  /// Reads the bank and has its golden runs computed, once for each code and bank; where this code gives other features
  /// than they have, the bank does not count. Throws Error(config) where it is damaged; CalibrationInterrupted.
  FeatureSource(FeatureSourceOptions options, Simulator simulate);

  /// Features in the order of the runs. Throws CalibrationInterrupted; Error(tolerance) naming the run where one that
  /// was checked differs from the bank.
  std::vector<RunFeatures> features(const std::string& stage, const std::vector<CampaignRun>& runs);

  const FeatureCost& cost() const { return cost_; }

  /// Why the bank does not count; empty where it does, or there is none.
  const std::string& bank_refused() const { return bank_refused_; }

  /// Every run answered so far as a bank of its own, with golden runs computed for it. Throws CalibrationInterrupted,
  /// Error(unexpected) where a golden run fails.
  FeatureBank gathered(const std::vector<RunConfig>& golden);

 private:
  /// A run that was asked for, and where its answer is from.
  struct Request {
    std::string key;
    enum class From { bank, store, campaign } from = From::campaign;
  };
  std::string golden_fault();
  std::vector<FeatureValues> golden_values(const std::vector<RunConfig>& configs);
  std::vector<Request> look_up(const std::vector<CampaignRun>& runs) const;
  void check(const std::string& stage, const std::vector<CampaignRun>& runs, const std::vector<Request>& requests);
  std::map<std::string, RunFeatures> compute(const std::string& stage, const std::vector<CampaignRun>& runs,
                                             const std::vector<Request>& requests);
  RunFeatures take(const CampaignOutcome& outcome);
  FeatureSourceOptions options_;
  Simulator simulate_;
  FeatureBank shipped_, own_, answered_;
  std::set<std::string> checked_;  ///< Keys of runs from the bank that were computed again.
  std::set<std::string> reused_;   ///< Keys of runs that were finished before this command.
  std::string bank_refused_;
  FeatureCost cost_;
};

}  // namespace asperity
