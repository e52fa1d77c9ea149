#include <cmath>

#include "core/calibration/calibration_json.hpp"

namespace asperity {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

ordered_json optional_number(const std::optional<double>& value) {
  return value ? number(*value) : ordered_json(nullptr);
}

ordered_json by_term(const LinearFit& fit, const std::vector<double>& values) {
  ordered_json json = ordered_json::object();
  for (std::size_t i = 0; i < fit.terms.size(); ++i) json[term_name(fit.terms[i])] = number(values[i]);
  return json;
}

/// One value a design row.
ordered_json by_row(const LinearFit& fit, const std::vector<double>& values, std::size_t rows) {
  ordered_json json(rows, nullptr);
  for (std::size_t i = 0; i < fit.rows.size(); ++i) json[fit.rows[i]] = number(values[i]);
  return json;
}

ordered_json anova_json(const Anova& anova) {
  ordered_json json = ordered_json::array();
  for (const AnovaLine& line : anova.lines) {
    json.push_back({{"source", line.source},
                    {"df", line.df},
                    {"sum_of_squares", number(line.sum_of_squares)},
                    {"mean_square", optional_number(line.mean_square)},
                    {"f", optional_number(line.f)},
                    {"p", optional_number(line.p)}});
  }
  return json;
}

ordered_json lack_of_fit_json(const std::optional<LackOfFit>& lack) {
  if (!lack) return nullptr;
  return {{"df", lack->df},
          {"sum_of_squares", number(lack->sum_of_squares)},
          {"f", number(lack->f)},
          {"p", number(lack->p)}};
}

ordered_json pure_error_json(const std::optional<PureError>& pure) {
  if (!pure) return nullptr;
  return {{"df", pure->df}, {"sum_of_squares", number(pure->sum_of_squares)}};
}

ordered_json checks_json(const ResidualChecks& checks) {
  return {{"normality_p", number(checks.normality_p)},
          {"largest_studentised", number(checks.largest_studentised)},
          {"row_of_largest", checks.row_of_largest},
          {"run_order_correlation", number(checks.run_order_correlation)}};
}

void add_fits(ordered_json& json, const ResponseModel& model) {
  const LinearFit &full = model.full, &reduced = model.reduced;
  json["coefficients"] = by_term(full, full.coefficients);
  json["standard_errors"] = by_term(full, full.standard_errors);
  json["p_values"] = by_term(full, full.p_values);
  json["reduced"] = by_term(reduced, reduced.coefficients);
  json["reduced_standard_errors"] = by_term(reduced, reduced.standard_errors);
  json["reduced_p_values"] = by_term(reduced, reduced.p_values);
  json["eliminated"] = model.eliminated;
  json["r2"] = number(full.r2);
  json["r2_adjusted"] = number(full.r2_adjusted);
  json["r2_predicted"] = optional_number(full.r2_predicted);
  json["reduced_r2"] = number(reduced.r2);
  json["reduced_r2_adjusted"] = number(reduced.r2_adjusted);
  json["reduced_r2_predicted"] = optional_number(reduced.r2_predicted);
}

ordered_json model_json(const ResponseModel& model, std::size_t rows) {
  ordered_json json = ordered_json::object();
  add_fits(json, model);
  json["transform"] = model.transform == Transform::logarithm ? "logarithm" : "none";
  json["anova"] = anova_json(model.anova);
  json["residual_sd"] = number(model.full.residual_sd);
  json["reduced_residual_sd"] = number(model.reduced.residual_sd);
  json["lack_of_fit"] = lack_of_fit_json(model.anova.lack_of_fit);
  json["pure_error"] = pure_error_json(model.anova.pure_error);
  json["fitted"] = by_row(model.full, model.full.fitted, rows);
  json["residuals"] = by_row(model.full, model.full.residuals, rows);
  json["studentised_residuals"] = by_row(model.full, model.full.studentised, rows);
  json["leverages"] = by_row(model.full, model.full.leverages, rows);
  json["residual_checks"] = checks_json(model.residual_checks);
  return json;
}

}  // namespace

ordered_json models_json(const std::vector<ResponseModel>& models, std::size_t rows) {
  ordered_json json = ordered_json::object();
  for (const ResponseModel& model : models) json[model.name] = model_json(model, rows);
  return json;
}

}  // namespace asperity
