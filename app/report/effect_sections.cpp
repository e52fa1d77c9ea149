#include <fmt/format.h>

#include <cmath>

#include "app/report/report_parts.hpp"
#include "render/effect_plots.hpp"
#include "render/fit_plots.hpp"

namespace asperity::app {
namespace {

constexpr int kCurvePoints = 41;

std::vector<const ModelData*> models_with_targets(const CalibrationData& data) {
  std::vector<const ModelData*> models;
  for (const ModelData& model : data.models)
    if (data.targets.empty() || data.targets.contains(model.property)) models.push_back(&model);
  return models;
}

/// A response along one factor in real units, the other levels as given.
render::EffectCurve curve_along(const CalibrationData& data, const ModelData& model, std::size_t factor,
                                std::vector<double> levels) {
  render::EffectCurve curve;
  for (int i = 0; i < kCurvePoints; ++i) {
    levels[factor] = data.reach * (2.0 * i / (kCurvePoints - 1) - 1);
    const double mean = model.surface.value(levels), half = model.surface.half_width(levels);
    curve.x.push_back(data.factors[factor].real(levels[factor]));
    curve.mean.push_back(mean);
    if (!model.surface.has_confidence()) continue;
    curve.lower.push_back(mean - half);
    curve.upper.push_back(mean + half);
  }
  return curve;
}

render::EffectRow effect_row(const CalibrationData& data, const ModelData& model) {
  render::EffectRow row{short_axis_label(quantity_of(model.property)), {}, {}};
  const auto target = data.targets.find(model.property);
  if (target != data.targets.end()) row.target = target->second.value;
  for (std::size_t k = 0; k < data.factors.size(); ++k)
    row.curves.push_back(curve_along(data, model, k, std::vector<double>(data.factors.size(), 0.0)));
  return row;
}

html::Markup main_effects_figure(const ReportContext& context) {
  const CalibrationData& data = context.data;
  render::MainEffects effects{"Main effects", "Other factors at the design's centre.", {}, {}};
  for (const FactorData& factor : data.factors) effects.factor_labels.push_back(short_axis_label(factor.quantity));
  for (const ModelData* model : models_with_targets(data)) effects.rows.push_back(effect_row(data, *model));
  const PlotText text{
      "main_effects",
      fmt::format("{} rows of charts, one a response, and {} columns, one a factor: the modelled response "
                  "along each factor with its 95 % confidence band.",
                  effects.rows.size(), data.factors.size()),
      "Main effects: each response along each factor by the reduced model, the other factors at the "
      "design's centre; band: 95 % confidence of the mean response."};
  return plot_figure(context, text, render::main_effects(effects));
}

render::InteractionPair interaction(const CalibrationData& data, const ModelData& model, std::size_t i, std::size_t j) {
  const Quantity &along = data.factors[i].quantity, &other = data.factors[j].quantity;
  render::InteractionPair pair{
      "along " + picture_symbol(along) + ", lines: " + picture_symbol(other), short_axis_label(along), {}};
  for (const int level : {-1, 0, 1}) {
    std::vector<double> levels(data.factors.size(), 0.0);
    levels[j] = level;
    pair.curves[static_cast<std::size_t>(level + 1)] = curve_along(data, model, i, levels);
  }
  return pair;
}

html::Markup interactions_figure(const ReportContext& context) {
  const CalibrationData& data = context.data;
  render::Interactions given{"Interactions",
                             "Further factors at the design's centre. Lines that are not parallel show an interaction.",
                             {"second factor at coded −1", "at 0", "at +1"},
                             {}};
  for (const ModelData* model : models_with_targets(data)) {
    render::InteractionRow row{short_axis_label(quantity_of(model->property)), {}};
    for (std::size_t i = 0; i < data.factors.size(); ++i)
      for (std::size_t j = i + 1; j < data.factors.size(); ++j) row.pairs.push_back(interaction(data, *model, i, j));
    given.rows.push_back(std::move(row));
  }
  const PlotText text{
      "interactions",
      fmt::format("{} rows of charts, one a response: the response along one factor at three levels of "
                  "another, for each pair of factors.",
                  given.rows.size()),
      "Interactions: each response along one factor at the low, middle and high level of another one, by "
      "the reduced model."};
  return plot_figure(context, text, render::interactions(given));
}

render::FittedResponse fitted_response(const CalibrationData& data, const ModelData& model) {
  const Quantity quantity = quantity_of(model.property);
  render::FittedResponse response{
      capitalised(quantity.name), short_axis_label(quantity), model.simulated, model.fitted, model.studentised, {}, {},
      model.residual_sd};
  for (const std::size_t row : model.rows) {
    response.rows.push_back(static_cast<int>(row) + 1);
    response.points.push_back({{}, row < data.kinds.size() ? data.kinds[row] : render::DesignPointKind::factorial});
  }
  return response;
}

html::Markup fits_figure(const ReportContext& context, const std::vector<const ModelData*>& models) {
  render::ChartFigure figure;
  figure.title = "Predicted against simulated";
  figure.letters = render::Letters::each;
  figure.columns = static_cast<int>(std::min<std::size_t>(3, models.size()));
  for (const ModelData* model : models)
    figure.charts.push_back(render::predicted_against_simulated(fitted_response(context.data, *model)));
  figure.height = 230 + 520 * static_cast<int>((models.size() + 2) / 3);
  const PlotText text{
      "predicted_against_simulated",
      fmt::format("One chart a response ({}): the model's values over the simulated ones, with the 1:1 line.",
                  models.size()),
      "What each reduced model says of the design's runs over what the runs gave. Runs whose studentised "
      "residual exceeds 2 carry their number. The centre points are one set of parameters on several "
      "meshes: their scatter along the horizontal axis is the mesh's."};
  return plot_figure(context, text, figure);
}

}  // namespace

html::Markup residuals_figure(const ReportContext& context, const ModelData& model) {
  const render::FittedResponse response = fitted_response(context.data, model);
  render::ChartFigure figure;
  figure.title = "Residuals: " + quantity_of(model.property).name;
  figure.letters = render::Letters::each;
  figure.columns = 3;
  figure.height = 700;
  figure.charts = {render::normal_probability(response), render::residual_against_fitted(response),
                   render::residual_against_row(response)};
  const PlotText text{"residuals_" + model.property,
                      "Studentised residuals of " + quantity_of(model.property).name +
                          ": on a normal probability plot, over the fitted values, and in the order of the runs.",
                      "Studentised residuals of the reduced model: (a) ordered over normal scores, (b) over the fitted "
                      "values, (c) in the order of the runs. Runs beyond 2 carry their number."};
  return plot_figure(context, text, figure);
}

html::Section effects_section(const ReportContext& context) {
  html::Section section{"Effects and interactions", {}, {}};
  if (models_with_targets(context.data).empty() || context.data.factors.empty()) return section;
  section.parts.push_back(main_effects_figure(context));
  if (context.data.factors.size() > 1) section.parts.push_back(interactions_figure(context));
  return section;
}

html::Section fits_section(const ReportContext& context) {
  html::Section section{"Predicted against simulated", {}, {}};
  std::vector<const ModelData*> models;
  for (const ModelData* model : models_with_targets(context.data))
    if (render::range_of(model->fitted).high > render::range_of(model->fitted).low) models.push_back(model);
  if (!models.empty()) section.parts.push_back(fits_figure(context, models));
  return section;
}

}  // namespace asperity::app
