#include "core/calibration/config_sections.hpp"
#include "core/calibration/data_calibration.hpp"

namespace asperity {
namespace {

std::optional<double> optional_number(const Section& section, const std::string& key) {
  if (!section.has(key)) return std::nullopt;
  return section.number(key);
}

void require(const Section& section, const std::string& key, bool good, const std::string& allowed) {
  if (section.has(key) && !good) section.fault(key, "is out of range", allowed);
}

Target read_target(const std::string& property, const Section& section) {
  Target target;
  target.property = property;
  target.value = section.number("value");
  target.tolerance = section.number("tolerance", target.tolerance);
  target.standard_error = section.number("standard_error", 0.0);
  target.weight = section.number("weight", 1.0);
  require(section, "value", target.value != 0.0, "not 0");
  require(section, "tolerance", target.tolerance > 0.0, "above 0");
  require(section, "standard_error", target.standard_error >= 0.0, "0 or more");
  require(section, "weight", target.weight > 0.0, "above 0");
  return target;
}

Factor read_factor(const std::string& index, const Section& section) {
  Factor factor;
  factor.name = "x" + std::to_string(std::stoul(index) + 1);
  factor.pointer = section.text("pointer");
  factor.label = section.text("label", factor.pointer);
  factor.symbol = section.text("symbol", factor.name);
  factor.unit = section.text("unit", "");
  factor.centre = section.number("centre");
  factor.step = section.number("step");
  factor.lower = optional_number(section, "lower");
  factor.upper = optional_number(section, "upper");
  factor.scale =
      section.choice("scale", {"linear", "logarithmic"}) == 1 ? FactorScale::logarithmic : FactorScale::linear;
  return factor;
}

}  // namespace

std::vector<Target> read_targets(const nlohmann::ordered_json& config, std::vector<Fault>& faults) {
  std::vector<Target> targets;
  const Section root(&config, "", faults);
  if (!root.has("targets")) root.fault("targets", "is missing", "one target or more");
  root.section("targets").for_each(
      [&](const std::string& property, const Section& section) { targets.push_back(read_target(property, section)); });
  return targets;
}

std::vector<Factor> read_factors(const nlohmann::ordered_json& config, std::vector<Fault>& faults) {
  std::vector<Factor> factors;
  const Section root(&config, "", faults);
  if (!root.has("factors") || !root.section("factors").json()->is_array()) {
    root.fault("factors", "is no list of factors", "one factor or more");
    return factors;
  }
  root.section("factors").for_each(
      [&](const std::string& index, const Section& section) { factors.push_back(read_factor(index, section)); });
  return factors;
}

AnalysisOptions read_analysis(const nlohmann::ordered_json& config, std::vector<Fault>& faults) {
  const Section section = Section(&config, "", faults).section("analysis");
  AnalysisOptions options;
  options.model.elimination_level = section.number("elimination_level", options.model.elimination_level);
  options.model.hierarchy = section.flag("hierarchical", true) ? Hierarchy::hierarchical : Hierarchy::free;
  options.region = section.choice("region", {"sphere", "cube"}) == 1 ? RegionShape::cube : RegionShape::sphere;
  DesirabilityOptions& desirability = options.search.desirability;
  desirability.half_range = section.number("desirability_half_range", desirability.half_range);
  desirability.exponent = section.number("desirability_exponent", desirability.exponent);
  options.search.starts = section.count("starts", options.search.starts);
  options.search.cluster_radius = section.number("cluster_radius", options.search.cluster_radius);
  options.level = section.number("level", options.level);
  options.most_move = section.number("most_move", options.most_move);
  options.bootstrap_draws = section.count("bootstrap_draws", options.bootstrap_draws);
  options.seed = section.count("seed", options.seed);
  require(section, "elimination_level", options.model.elimination_level > 0.0 && options.model.elimination_level <= 1.0,
          "above 0, up to 1 (1: nothing is eliminated)");
  require(section, "desirability_half_range", desirability.half_range > 0.0, "above 0");
  require(section, "desirability_exponent", desirability.exponent > 0.0, "above 0");
  require(section, "cluster_radius", options.search.cluster_radius > 0.0, "above 0");
  require(section, "level", options.level > 0.0 && options.level < 1.0, "above 0, below 1");
  require(section, "most_move", options.most_move > 0.0, "above 0");
  return options;
}

}  // namespace asperity
