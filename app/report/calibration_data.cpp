#include "app/report/calibration_data.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace asperity::app {
namespace {

FactorData read_factor(const Value& json) {
  FactorData factor{json["name"].text(), json["pointer"].text(), {}, json["centre"].number(), json["step"].number()};
  factor.quantity = quantity_of_pointer(factor.pointer);
  if (!json["label"].text().empty()) factor.quantity.name = json["label"].text();
  if (!json["symbol"].text().empty()) factor.quantity.symbol = json["symbol"].text();
  if (!json["unit"].text().empty()) factor.quantity.unit = json["unit"].text();
  factor.logarithmic = json["scale"].text() == "logarithmic";
  return factor;
}

render::DesignPointKind read_kind(const std::string& word) {
  if (word == "star") return render::DesignPointKind::star;
  return word == "centre" ? render::DesignPointKind::centre : render::DesignPointKind::factorial;
}

void read_design(const Value& json, CalibrationData& data) {
  for (const Value& factor : json["factors"].items()) data.factors.push_back(read_factor(factor));
  for (const Value& row : json["coded"].items()) data.coded.push_back(row.numbers());
  for (const Value& kind : json["kind"].items()) data.kinds.push_back(read_kind(kind.text()));
  for (const auto& row : data.coded) {
    if (row.size() != data.factors.size())
      throw Error(ErrorKind::config, {{"/design/coded", "has a row of another length than there are factors",
                                       std::to_string(row.size()), std::to_string(data.factors.size()), ""}});
    double square = 0;
    for (const double level : row) data.reach = std::max(data.reach, std::abs(level)), square += level * level;
    data.radius = std::max(data.radius, std::sqrt(square));
  }
}

/// The reduced model where there is one, else the full one.
std::vector<ResponseSurface::Term> read_terms(const Value& model) {
  const bool reduced = model["reduced"].exists();
  const Value coefficients = model[reduced ? "reduced" : "coefficients"];
  const Value errors = model[reduced ? "reduced_standard_errors" : "standard_errors"];
  std::vector<ResponseSurface::Term> terms;
  for (const auto& [name, value] : coefficients.entries())
    terms.push_back({name, value.number(), errors[name].number()});
  return terms;
}

/// One number a run that the model used, from a list over those runs or over all rows of the design.
std::vector<double> of_rows(const std::vector<double>& values, const std::vector<std::size_t>& rows,
                            std::size_t design_rows) {
  std::vector<double> picked;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::size_t at = values.size() == design_rows ? rows[k] : k;
    picked.push_back(at < values.size() ? values[at] : NAN);
  }
  return picked;
}

ModelData read_model(const std::string& property, const Value& json, const std::vector<double>& response,
                     const CalibrationData& data) {
  std::vector<std::size_t> rows;
  std::vector<std::vector<double>> runs;
  for (std::size_t i = 0; i < std::min(response.size(), data.coded.size()); ++i) {
    if (!std::isfinite(response[i])) continue;
    rows.push_back(i);
    runs.push_back(data.coded[i]);
  }
  ModelData model{property, ResponseSurface(read_terms(json), runs), rows, {}, {}, {}, json["residual_sd"].number()};
  const std::size_t all = data.coded.size();
  model.simulated = of_rows(response, rows, all);
  model.fitted = of_rows(json["fitted"].numbers(), rows, all);
  model.studentised = of_rows(json["studentised_residuals"].numbers(), rows, all);
  return model;
}

void read_models(const Value& root, CalibrationData& data) {
  for (const auto& [property, json] : root["models"].entries()) {
    if (!json.exists() || (!json["reduced"].exists() && !json["coefficients"].exists())) continue;
    data.models.push_back(read_model(property, json, root["responses"][property].numbers(), data));
  }
}

void read_solution(const Value& root, CalibrationData& data) {
  const std::vector<Value> solutions = root["solutions"].items();
  if (solutions.empty()) return;
  data.solution = solutions.front()["coded"].numbers();
  if (data.solution.size() != data.factors.size()) data.solution.clear();
  const Value region = solutions.front()["region"];
  if (!region.exists()) return;
  for (const FactorData& factor : data.factors) {
    const double low = region["lower"][factor.pointer].number(), high = region["upper"][factor.pointer].number();
    data.region.push_back(low < high ? std::optional(render::Range{low, high}) : std::nullopt);
  }
}

}  // namespace

double FactorData::real(double coded) const {
  return logarithmic ? centre * std::pow(step, coded) : centre + step * coded;
}

double FactorData::coded(double real) const {
  return logarithmic ? std::log(real / centre) / std::log(step) : (real - centre) / step;
}

std::vector<double> CalibrationData::held() const {
  return solution.empty() ? std::vector<double>(factors.size(), 0.0) : solution;
}

double CalibrationData::desirability_product(const std::vector<double>& levels) const {
  constexpr double kLeast = 0.02;  // of the other targets' desirabilities, outside: only the worst one's edge counts
  double product = 1, others = 1, worst = 1;
  for (const ModelData& model : models) {
    const auto found = targets.find(model.property);
    if (found == targets.end()) continue;
    const TargetData& target = found->second;
    const double value = model.surface.value(levels);
    const double left = 1 - std::abs(value / target.value - 1) / desirability.half_range;
    product *= std::pow(app::desirability(value, target.value, desirability), target.weight);
    others *= std::max(kLeast, std::max(left, worst));
    worst = std::min(worst, left);
  }
  return worst < 0 ? worst * others : product;
}

double CalibrationData::total_weight() const {
  double sum = 0;
  for (const ModelData& model : models)
    if (const auto found = targets.find(model.property); found != targets.end()) sum += found->second.weight;
  return sum;
}

double CalibrationData::overall_desirability(const std::vector<double>& levels) const {
  const double weights = total_weight();
  return weights > 0 ? std::pow(std::max(0.0, desirability_product(levels)), 1 / weights) : NAN;
}

CalibrationData read_calibration_data(const Value& root) {
  CalibrationData data;
  read_design(root["design"], data);
  for (const auto& [property, target] : root["targets"].entries()) {
    if (!target["value"].exists()) continue;
    const double weight = target["weight"].exists() ? target["weight"].number() : 1;
    data.targets[property] = {target["value"].number(), weight};
  }
  const Value shape = root["desirability"];
  if (shape["half_range"].exists()) data.desirability.half_range = shape["half_range"].number();
  if (shape["exponent"].exists()) data.desirability.exponent = shape["exponent"].number();
  read_models(root, data);
  read_solution(root, data);
  return data;
}

Quantity parameter_quantity(const CalibrationData& data, const std::string& pointer) {
  for (const FactorData& factor : data.factors)
    if (factor.pointer == pointer) return factor.quantity;
  return quantity_of_pointer(pointer);
}

}  // namespace asperity::app
