#include "core/calibration/calibration_json.hpp"

#include <cmath>

namespace asperity {
namespace {

using nlohmann::ordered_json;

const char* word(PointKind kind) {
  switch (kind) {
    case PointKind::factorial:
      return "factorial";
    case PointKind::star:
      return "star";
    case PointKind::centre:
      break;
  }
  return "centre";
}

ordered_json number(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

template <class T>
ordered_json optional_number(const std::optional<T>& value) {
  return value ? number(static_cast<double>(*value)) : ordered_json(nullptr);
}

ordered_json factor_json(const Factor& factor) {
  return {
      {"name", factor.name},         {"pointer", factor.pointer},
      {"label", factor.label},       {"symbol", factor.symbol},
      {"unit", factor.unit},         {"centre", number(factor.centre)},
      {"step", number(factor.step)}, {"scale", factor.scale == FactorScale::logarithmic ? "logarithmic" : "linear"}};
}

ordered_json prediction_json(const Prediction& prediction) {
  return {{"value", number(prediction.value)},
          {"sd", number(prediction.sd_run)},
          {"sd_mean", number(prediction.sd_mean)},
          {"lower", number(prediction.lower)},
          {"upper", number(prediction.upper)}};
}

ordered_json direction_json(const ConfidenceRegion& region, std::size_t i) {
  return {{"singular_value", number(region.singular_values[i])},
          {"direction", region.directions[i]},
          {"determined", bool(region.direction_determined[i])}};
}

ordered_json bootstrap_json(const BootstrapRegion& bootstrap, const std::vector<Factor>& factors) {
  ordered_json json{{"draws", bootstrap.draws}, {"lost", bootstrap.lost}, {"lower", {}}, {"upper", {}}};
  for (std::size_t j = 0; j < factors.size(); ++j) {
    json["lower"][factors[j].pointer] = number(decode(factors[j], bootstrap.lower[j]));
    json["upper"][factors[j].pointer] = number(decode(factors[j], bootstrap.upper[j]));
  }
  return json;
}

ordered_json region_json(const Solution& solution, const std::vector<Factor>& factors) {
  const ConfidenceRegion& region = solution.region;
  ordered_json json{{"level", region.level},
                    {"lower", {}},
                    {"upper", {}},
                    {"determined", {}},
                    {"interval", {{"lower", {}}, {"upper", {}}}},
                    {"degrees_of_freedom", region.df},
                    {"directions", ordered_json::array()}};
  for (std::size_t j = 0; j < factors.size(); ++j) {
    const std::string& pointer = factors[j].pointer;
    const bool told = region.determined[j];
    const auto bound = [&](double coded) { return told ? number(decode(factors[j], coded)) : ordered_json(nullptr); };
    json["lower"][pointer] = bound(region.lower[j]);
    json["upper"][pointer] = bound(region.upper[j]);
    json["determined"][pointer] = told;
    json["interval"]["lower"][pointer] = bound(region.interval_lower[j]);
    json["interval"]["upper"][pointer] = bound(region.interval_upper[j]);
  }
  for (std::size_t i = 0; i < region.directions.size(); ++i) json["directions"].push_back(direction_json(region, i));
  if (solution.bootstrap) json["bootstrap"] = bootstrap_json(*solution.bootstrap, factors);
  return json;
}

ordered_json verification_of(const Verification& v) {
  return {{"target", number(v.target)}, {"mean", number(v.mean)},
          {"sd", number(v.sd)},         {"n", v.values.size()},
          {"bias", number(v.bias)},     {"tolerance", number(v.tolerance)},
          {"within", v.within},         {"predicted", optional_number(v.predicted)},
          {"values", v.values}};
}

}  // namespace

ordered_json targets_json(const std::vector<Target>& targets) {
  ordered_json json = ordered_json::object();
  for (const Target& target : targets) {
    json[target.property] = {{"value", number(target.value)}, {"tolerance", number(target.tolerance)}};
  }
  return json;
}

ordered_json design_json(const Design& design, const std::vector<std::uint64_t>& seeds) {
  ordered_json json{{"factors", ordered_json::array()}, {"alpha", number(design.alpha)}, {"coded", design.coded},
                    {"real", real_matrix(design)},      {"kind", ordered_json::array()}, {"seeds", seeds}};
  for (const Factor& factor : design.factors) json["factors"].push_back(factor_json(factor));
  for (PointKind kind : design.kind) json["kind"].push_back(word(kind));
  return json;
}

ordered_json responses_json(const Responses& responses) {
  ordered_json json = ordered_json::object();
  for (const Response& response : responses.list) {
    ordered_json values = ordered_json::array();
    for (double value : response.values) values.push_back(number(value));
    json[response.name] = std::move(values);
  }
  return json;
}

ordered_json bad_runs_json(const std::vector<BadRun>& bad_runs) {
  ordered_json json = ordered_json::array();
  for (const BadRun& run : bad_runs) {
    json.push_back({{"row", run.row}, {"test", run.test}, {"reason", run.reason}, {"treatment", run.treatment}});
  }
  return json;
}

ordered_json round_json(const Round& round) {
  ordered_json json{{"centre", {}},
                    {"step", {}},
                    {"moved_by", number(round.moved_by)},
                    {"best_desirability", number(round.best_desirability)},
                    {"solutions", round.solutions}};
  for (const Factor& factor : round.factors) {
    json["centre"][factor.pointer] = number(factor.centre);
    json["step"][factor.pointer] = number(factor.step);
  }
  return json;
}

ordered_json parameters_json(const std::vector<Factor>& factors, const std::vector<double>& real) {
  ordered_json json = ordered_json::object();
  for (std::size_t j = 0; j < factors.size(); ++j) json[factors[j].pointer] = number(real[j]);
  return json;
}

ordered_json solution_json(const Solution& solution, const std::vector<Factor>& factors,
                           const std::vector<Target>& targets) {
  ordered_json json{
      {"parameters", parameters_json(factors, solution.real)}, {"coded", solution.point.x},
      {"desirability", number(solution.point.desirability)},   {"within_tolerance", solution.point.within_tolerance},
      {"free_directions", solution.point.free_directions},     {"predicted", ordered_json::object()}};
  for (std::size_t r = 0; r < targets.size(); ++r) {
    json["predicted"][targets[r].property] = prediction_json(solution.predicted[r]);
  }
  json["region"] = region_json(solution, factors);
  return json;
}

ordered_json verification_json(const std::vector<Verification>& verifications) {
  ordered_json json = ordered_json::object();
  for (const Verification& v : verifications) json[v.property] = verification_of(v);
  return json;
}

}  // namespace asperity
