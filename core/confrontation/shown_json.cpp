#include "core/confrontation/shown_json.hpp"

#include <algorithm>
#include <cmath>

#include "core/config/enum_words.hpp"
#include "core/confrontation/instrument_json.hpp"
#include "core/confrontation/run_curve.hpp"
#include "core/confrontation/significant_digits.hpp"
#include "core/confrontation/test_features.hpp"
#include "core/confrontation/virtual_test.hpp"
#include "core/measurement/telling_rows.hpp"
#include "core/output/summary.hpp"

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using nlohmann::ordered_json;

constexpr std::size_t kStretches = 150;  // of a curve, two rows each
constexpr int kDigits = 6;               // of a curve's numbers

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(rounded_to(value, kDigits)) : ordered_json(nullptr);
}

ordered_json numbers(const VectorXd& values) {
  ordered_json list = ordered_json::array();
  for (const double v : values) list.push_back(number(v));
  return list;
}

template <class T>
ordered_json optional_json(const std::optional<T>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json curve_json(const std::vector<double>& path, const std::vector<double>& load) {
  ordered_json x = ordered_json::array(), y = ordered_json::array();
  for (const std::size_t row : telling_rows(load, kStretches)) {
    x.push_back(number(path[row]));
    y.push_back(number(load[row]));
  }
  return {{"path", std::move(x)}, {"load", std::move(y)}};
}

ordered_json measured_json(const MeasuredTest& test) {
  ordered_json list = ordered_json::array();
  for (const SpecimenCurve& s : test.curves) {
    ordered_json entry = {{"specimen", s.specimen}};
    entry.update(curve_json(s.curve.path, s.curve.load));
    list.push_back(std::move(entry));
  }
  return list;
}

ordered_json specimen_features(const MeasuredTest& test) {
  ordered_json json = ordered_json::object();
  for (const TestFeature& feature : features_of(test)) {
    if (feature.count == 0) continue;
    ordered_json values = ordered_json::array();
    for (const SpecimenValue& s : feature.specimens)
      values.push_back(s.value ? number(*s.value) : ordered_json(nullptr));
    json[std::string(feature.kind->name)] = std::move(values);
  }
  return json;
}

/// The curve over what the laboratory recorded: the platens' path, or that of a gauge on the specimen.
ordered_json finished_json(const CampaignOutcome& outcome, bool path_is_gauge) {
  const RunCurve run = read_run_curve(outcome.folder);
  const bool gauge = path_is_gauge && !run.curve.gauge_strain.empty();
  ordered_json entry = curve_json(gauge ? run.curve.gauge_strain : run.curve.path, run.curve.load);
  ordered_json features = ordered_json::object();
  const std::span<const FeatureKind> kinds = feature_kinds(run.config.experiment.type);
  const std::vector<FeatureValue> values = read_features(run.curve, reading_of_run(run.config));
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (values[i].value) features[std::string(kinds[i].name)] = number(*values[i].value);
  }
  entry["features"] = std::move(features);
  entry["kinetic_over_stored"] =
      read_summary(outcome.folder / "summary.json").energy.at("kinetic_over_stored_before_peak");
  return entry;
}

ordered_json runs_json(const std::vector<ShownRuns>& shown, const MeasuredTest& test, FinalModel model) {
  ordered_json list = ordered_json::array();
  for (const ShownRuns& part : shown) {
    if (part.test != test.id || part.model != model) continue;
    for (std::size_t i = 0; i < part.outcomes.size(); ++i) {
      const CampaignOutcome& outcome = part.outcomes[i];
      const bool finished = outcome.status == RunStatus::finished;
      ordered_json entry = {{"seed", part.runs[i].config.particles.seed},
                            {"folder", outcome.folder.string()},
                            {"finished", finished},
                            {"reason", outcome.reason}};
      if (finished) entry.update(finished_json(outcome, path_is_gauge(test)));
      list.push_back(std::move(entry));
    }
  }
  return list;
}

/// How the laboratory made the test, and how it is repeated.
ordered_json conditions_json(const ConfrontationConfig& config, const MeasuredTest& test) {
  const RunConfig run = virtual_test(config, test);
  const ExperimentConfig& e = run.experiment;
  const bool disc = e.type == ExperimentType::brazilian, joint = e.type == ExperimentType::direct_shear;
  ordered_json size = {e.width_mm, e.height_mm};
  if (disc) size = {e.diameter_mm};
  if (joint) size = ordered_json::array();
  return {{"size_mm", std::move(size)},
          {"edge_mm", run.particles.edge_mm},
          {"plane", word(e.plane)},
          {"core_angle_deg", test.preparation.core_angle_deg},
          {"lubricated_platens", test.preparation.lubricated_platens},
          {"rate_mm_per_s", joint ? e.loading.shear_rate_mm_per_s : e.loading.closing_rate_mm_per_s},
          {"laboratory_rate_mm_per_s", optional_json(joint ? test.shear_rate_mm_per_s : test.closing_rate_mm_per_s)}};
}

ordered_json tests_json(const ConfrontationConfig& config, const std::vector<ShownRuns>& shown) {
  ordered_json list = ordered_json::array();
  for (const MeasuredTest& test : config.measured.tests) {
    list.push_back({{"id", test.id},
                    {"experiment", word(test.experiment)},
                    {"use", test.use == TestUse::hold_out ? "hold_out" : "fit"},
                    {"confining_pressure_mpa", optional_json(test.confining_pressure_mpa)},
                    {"normal_stress_mpa", optional_json(test.normal_stress_mpa)},
                    {"path_is_gauge", path_is_gauge(test)},
                    {"conditions", conditions_json(config, test)},
                    {"instrument", instrument_json(test.instrument)},
                    {"instrument_by_default", test.instrument == Instrument{}},
                    {"specimens", specimens_of(test).size()},
                    {"features", specimen_features(test)},
                    {"measured", measured_json(test)},
                    {"base", runs_json(shown, test, FinalModel::base)},
                    {"extension", runs_json(shown, test, FinalModel::extension)}});
  }
  return list;
}

ordered_json declared_json(const ConfrontationConfig& config) {
  ordered_json list = ordered_json::array();
  for (const DeclaredValue& d : config.declared) list.push_back({{"what", d.what}, {"value", d.value}, {"why", d.why}});
  return list;
}

ordered_json setting_json(const ConfrontationConfig& config) {
  const AssumedGeometry& assumed = config.assumed;
  return {{"name", config.name},
          {"description", config.description},
          {"measured", config.measured.name},
          {"material", config.measured.material},
          {"source", config.measured.source},
          {"licence", config.measured.licence},
          {"split_proposed", config.split_proposed},
          {"declared", declared_json(config)},
          {"assumed",
           {{"width_mm", optional_json(assumed.width_mm)},
            {"height_mm", optional_json(assumed.height_mm)},
            {"diameter_mm", optional_json(assumed.diameter_mm)},
            {"teeth", assumed.profile.size()},
            {"why", assumed.why}}},
          {"linearised_at", config.linearise_at == LineariseAt::reference ? "reference" : "calibrated"},
          {"meshes",
           {{"noise", config.meshes.noise},
            {"common", config.meshes.common},
            {"screen", config.meshes.screen},
            {"fresh", config.meshes.fresh}}},
          {"draws", config.draws},
          {"alarm_level", config.alarm_level},
          {"bank", config.bank ? ordered_json(config.bank->filename().string()) : ordered_json(nullptr)}};
}

/// The slots in the order of all vectors here; `extended` over the deviations of its slot.
ordered_json slots_json(const Confrontation& c) {
  const WhitenedFrame frame(c.scatter.covariance, c.base.absorbing);
  const VectorXd residual = frame.project(c.base.difference);
  ordered_json list = ordered_json::array();
  for (const ComparedTest& part : c.fitted.tests) {
    for (std::size_t i = 0; i < part.columns.size(); ++i) {
      const Index at = part.first + static_cast<Index>(i);
      const double deviation = std::sqrt(c.scatter.covariance(at, at));
      ordered_json entry = {{"test", part.test->id},
                            {"feature", c.fitted.slots[static_cast<std::size_t>(at)]->kind->name},
                            {"projected", number(residual(at))},
                            {"z_base", number(c.base.difference(at) / deviation)},
                            {"z_extension", nullptr}};
      if (!c.conclusion.kept.empty()) entry["z_extension"] = number(c.conclusion.kept.front().residual(at) / deviation);
      list.push_back(std::move(entry));
    }
  }
  return list;
}

ordered_json candidates_json(const Confrontation& c) {
  const WhitenedFrame frame(c.scatter.covariance, c.base.absorbing);
  const Eigen::MatrixXd projected = projected_fingerprints(frame, c.base.difference, c.fitted);
  ordered_json list = ordered_json::array();
  for (std::size_t k = 0; k < c.evidence.candidates.size(); ++k) {
    const Candidate& candidate = c.evidence.candidates[k];
    const auto at = static_cast<Index>(k);
    list.push_back({{"id", candidate.id},
                    {"suspect", candidate.suspect},
                    {"two_sided", candidate.two_sided},
                    {"whole", candidate.whole},
                    {"most", candidate.most},
                    {"explained", number(c.gate.pattern.explained(at))},
                    {"absorbed_share", number(c.gate.hidden_share(at))},
                    {"detectable", number(c.gate.detectable(at))},
                    {"projected", numbers(projected.col(at))}});
  }
  return list;
}

/// The single causes that a second one was sought to: the one kept, or the best where none was.
std::vector<HypothesisFit> first_causes(const Confrontation& c) {
  std::vector<HypothesisFit> kept;
  for (const HypothesisFit& fit : c.conclusion.singles) {
    if (fit.kept) kept.push_back(fit);
  }
  return kept.empty() ? c.conclusion.singles : kept;
}

ordered_json seconds_json(const Confrontation& c) {
  ordered_json list = ordered_json::array();
  const std::vector<HypothesisFit> firsts = first_causes(c);
  const auto id = [&](Index k) { return c.evidence.candidates[static_cast<std::size_t>(k)].id; };
  for (std::size_t i = 0; i < c.conclusion.seconds.size() && i < firsts.size(); ++i) {
    const SecondCause& second = c.conclusion.seconds[i];
    if (second.candidate < 0) continue;
    list.push_back({{"first", id(firsts[i].causes.front())},
                    {"second", id(second.candidate)},
                    {"explained", number(second.explained)},
                    {"p", number(second.p)}});
  }
  return list;
}

ordered_json extension_json(const Confrontation& c) {
  ordered_json causes = ordered_json::array();
  if (!c.conclusion.kept.empty()) {
    for (const Index k : c.conclusion.kept.front().causes)
      causes.push_back(c.evidence.candidates[static_cast<std::size_t>(k)].id);
  }
  return causes;
}

}  // namespace

ordered_json shown_json(const ConfrontationConfig& config, const Confrontation& confrontation,
                        const std::vector<ShownRuns>& shown, const FeatureCost& cost) {
  return {{"setting", setting_json(config)},
          {"extension", extension_json(confrontation)},
          {"tests", tests_json(config, shown)},
          {"slots", slots_json(confrontation)},
          {"candidates", candidates_json(confrontation)},
          {"seconds", seconds_json(confrontation)},
          {"cost",
           {{"runs", cost.runs},
            {"from_bank", cost.from_bank},
            {"from_store", cost.from_store},
            {"computed", cost.computed},
            {"failed", cost.failed},
            {"checked", cost.checked},
            {"compute_s", number(cost.compute_s)}}}};
}

}  // namespace asperity
