#include "core/confrontation/feature_source.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/base/random.hpp"
#include "core/base/sha256.hpp"
#include "core/config/read_config.hpp"
#include "core/confrontation/gathered_features.hpp"
#include "core/confrontation/run_curve.hpp"
#include "core/measurement/features.hpp"

namespace asperity {
namespace {

/// All digits, of a finished run.
FeatureValues exact_values(const CampaignOutcome& outcome) {
  const RunCurve run = read_run_curve(outcome.folder);
  FeatureValues values;
  for (const FeatureValue& feature : read_features(run.curve, reading_of_run(run.config)))
    values.push_back(feature.value);
  return values;
}

void require_end(const std::vector<CampaignOutcome>& outcomes) {
  const auto interrupted = [](const CampaignOutcome& o) { return o.status == RunStatus::interrupted; };
  if (std::any_of(outcomes.begin(), outcomes.end(), interrupted)) throw CalibrationInterrupted{};
}

std::vector<CampaignRun> golden_runs(const std::vector<RunConfig>& configs) {
  std::vector<CampaignRun> runs;
  for (std::size_t i = 0; i < configs.size(); ++i) runs.push_back({"golden run " + std::to_string(i + 1), configs[i]});
  return runs;
}

/// Whether a run belongs to the share, whatever the order in which runs are asked for.
bool is_drawn(const FeatureSourceOptions& options, const std::string& key) {
  return options.check_share > 0.0 && RandomStream(options.check_seed, key).uniform() < options.check_share;
}

[[noreturn]] void throw_mismatch(const CampaignRun& run, const std::string& key, const std::string& what) {
  throw Error(ErrorKind::tolerance,
              {{run.label, "does not give the bank's features when it is computed again: " + what, key,
                "the same to 9 digits", "the bank is stale or was changed: have it written again"}});
}

/// What differs; empty where nothing does.
std::string difference(ExperimentType type, const FeatureValues& bank, const FeatureValues& computed) {
  const auto text = [](const std::optional<double>& v) { return v ? std::to_string(*v) : std::string("absent"); };
  for (std::size_t i = 0; i < bank.size(); ++i) {
    if (i < computed.size() && bank[i] == computed[i]) continue;
    return std::string(feature_kinds(type)[i].name) + " " + (i < computed.size() ? text(computed[i]) : "absent") +
           " in place of " + text(bank[i]);
  }
  return "";
}

}  // namespace

FeatureSource::FeatureSource(FeatureSourceOptions options, Simulator simulate)
    : options_(std::move(options)), simulate_(std::move(simulate)), own_(read_gathered(options_.store)) {
  if (!options_.bank) return;
  shipped_ = read_bank(*options_.bank);
  const std::string sha256 = sha256_hex(read_config_text(*options_.bank));
  if (golden_noted(options_.store, sha256)) return;
  bank_refused_ = golden_fault();
  if (bank_refused_.empty()) {
    note_golden(options_.store, sha256);
  } else {
    shipped_ = {};
  }
}

std::string FeatureSource::golden_fault() {
  if (shipped_.golden.empty()) return "the bank has no golden run to know its code by";
  std::vector<RunConfig> configs;
  for (const GoldenRun& run : shipped_.golden) configs.push_back(run.config);
  const std::vector<FeatureValues> values = golden_values(configs);
  for (std::size_t i = 0; i < configs.size(); ++i) {
    if (values[i].empty()) return "golden run " + std::to_string(i + 1) + " fails in this build";
    const std::string what = difference(configs[i].experiment.type, shipped_.golden[i].values, values[i]);
    if (!what.empty())
      return "this build gives other results than the bank's: golden run " + std::to_string(i + 1) + ", " + what;
  }
  return "";
}

std::vector<FeatureValues> FeatureSource::golden_values(const std::vector<RunConfig>& configs) {
  const std::vector<CampaignOutcome> outcomes = simulate_("golden runs", golden_runs(configs));
  require_end(outcomes);
  std::vector<FeatureValues> values;
  for (const CampaignOutcome& outcome : outcomes) {
    cost_.compute_s += outcome.compute_s;
    values.push_back(outcome.status == RunStatus::finished ? exact_values(outcome) : FeatureValues{});
  }
  return values;
}

std::vector<FeatureSource::Request> FeatureSource::look_up(const std::vector<CampaignRun>& runs) const {
  std::vector<Request> requests;
  for (const CampaignRun& run : runs) {
    Request request{bank_key(run.config)};
    if (find_run(shipped_, request.key)) {
      request.from = Request::From::bank;
    } else if (find_run(own_, request.key)) {
      request.from = Request::From::store;
    }
    requests.push_back(std::move(request));
  }
  return requests;
}

RunFeatures FeatureSource::take(const CampaignOutcome& outcome) {
  if (!outcome.reused) cost_.compute_s += outcome.compute_s;
  if (outcome.status != RunStatus::finished) return {{}, outcome.reason.empty() ? "failed" : outcome.reason};
  return {rounded(exact_values(outcome)), ""};
}

void FeatureSource::check(const std::string& stage, const std::vector<CampaignRun>& runs,
                          const std::vector<Request>& requests) {
  std::vector<CampaignRun> drawn;
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool from_bank = requests[i].from == Request::From::bank;
    if (!from_bank || !is_drawn(options_, requests[i].key) || !checked_.insert(requests[i].key).second) continue;
    drawn.push_back(runs[i]);
    keys.push_back(requests[i].key);
  }
  if (drawn.empty()) return;
  const std::vector<CampaignOutcome> outcomes = simulate_(stage + ", checked", drawn);
  require_end(outcomes);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const RunFeatures again = take(outcomes[i]);
    if (again.values.empty()) throw_mismatch(drawn[i], keys[i], "it failed: " + again.reason);
    const std::string what =
        difference(drawn[i].config.experiment.type, find_run(shipped_, keys[i])->values, again.values);
    if (!what.empty()) throw_mismatch(drawn[i], keys[i], what);
    ++cost_.checked;
  }
}

std::map<std::string, RunFeatures> FeatureSource::compute(const std::string& stage,
                                                          const std::vector<CampaignRun>& runs,
                                                          const std::vector<Request>& requests) {
  std::vector<CampaignRun> missing;
  std::map<std::string, RunFeatures> computed;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool known = requests[i].from != Request::From::campaign;
    if (!known && computed.emplace(requests[i].key, RunFeatures{}).second) missing.push_back(runs[i]);
  }
  if (missing.empty()) return computed;
  const std::vector<CampaignOutcome> outcomes = simulate_(stage, missing);
  require_end(outcomes);
  FeatureBank fresh;
  for (std::size_t i = 0; i < missing.size(); ++i) {
    const std::string key = bank_key(missing[i].config);
    computed[key] = take(outcomes[i]);
    if (outcomes[i].reused) reused_.insert(key);
    if (computed[key].reason.empty()) fresh.runs[key] = {missing[i].config.experiment.type, computed[key].values};
  }
  add_gathered(options_.store, fresh);
  merge(own_, fresh);
  return computed;
}

std::vector<RunFeatures> FeatureSource::features(const std::string& stage, const std::vector<CampaignRun>& runs) {
  const std::vector<Request> requests = look_up(runs);
  check(stage, runs, requests);
  std::map<std::string, RunFeatures> computed = compute(stage, runs, requests);
  std::vector<RunFeatures> answers;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Request& request = requests[i];
    const bool bank = request.from == Request::From::bank, campaign = request.from == Request::From::campaign;
    const bool computed_now = campaign && !reused_.contains(request.key);
    cost_.from_bank += bank;
    cost_.computed += computed_now;
    cost_.from_store += !bank && !computed_now;
    answers.push_back(campaign ? computed.at(request.key)
                               : RunFeatures{find_run(bank ? shipped_ : own_, request.key)->values, ""});
    cost_.failed += !answers.back().reason.empty();
    if (answers.back().reason.empty())
      answered_.runs[request.key] = {runs[i].config.experiment.type, answers.back().values};
  }
  cost_.runs += runs.size();
  return answers;
}

FeatureBank FeatureSource::gathered(const std::vector<RunConfig>& golden) {
  const std::vector<FeatureValues> values = golden_values(golden);
  FeatureBank bank = answered_;
  for (std::size_t i = 0; i < golden.size(); ++i) {
    if (values[i].empty()) throw Error(ErrorKind::unexpected, "golden run " + std::to_string(i + 1) + " fails");
    bank.golden.push_back({golden[i], values[i]});
  }
  return bank;
}

}  // namespace asperity
