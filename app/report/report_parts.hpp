#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/report/calibration_data.hpp"
#include "app/report/document.hpp"
#include "core/output/html.hpp"
#include "render/charts.hpp"

/// The parts of a calibration's report. Each is a section of the page, with its figures drawn into plots/; a section
/// without parts has nothing to say and is left out.
namespace asperity::app {

/// What every part reads: calibration.json, the same prepared for figures, and the folder they lie in.
struct ReportContext {
  std::filesystem::path folder;
  Value root;
  CalibrationData data;
};

/// File name without ending, alternative text and caption of a plot.
struct PlotText {
  std::string name, alternative_text;
  html::Markup caption;
};

/// Draws plots/NAME.png and .svg and returns the figure that shows the one and links the other. Throws Error(output).
html::Markup plot_figure(const ReportContext& context, const PlotText& text, const render::ChartFigure& figure);

/// A number with its unit: "1.30 GPa"; no unit where it is "–", no blank before a degree sign.
html::Markup with_unit(const html::Markup& number, const Quantity& quantity);
html::Markup quantity_text(double value, const Quantity& quantity, int digits = 4);

/// A share as a percentage with its sign: "+1.8 %".
html::Markup percent(double share);

/// A probability: three decimals, or "< 0.001".
html::Markup p_value(double p);

/// "t_c = 6.4 MPa, φ_c = 37.2°" for captions of pictures: the held levels of all factors but two.
std::string held_text(const CalibrationData& data, std::size_t i, std::size_t j);

/// A column for a quantity: its symbol or name over its unit.
html::Column quantity_column(const Quantity& quantity);

/// The desirability over each pair of factors, and the lines of the targets over one.
std::vector<html::Markup> desirability_figures(const ReportContext& context);

/// Normal probability, residual against fitted value and against run.
html::Markup residuals_figure(const ReportContext& context, const ModelData& model);

/// One notice a warning of the calibration.
std::vector<html::Markup> warnings(const ReportContext& context);

html::Section outcome_section(const ReportContext& context);
html::Section parameters_section(const ReportContext& context);
html::Section elastic_section(const ReportContext& context);
html::Section design_section(const ReportContext& context);
html::Section models_section(const ReportContext& context);
html::Section surfaces_section(const ReportContext& context);
html::Section effects_section(const ReportContext& context);
html::Section fits_section(const ReportContext& context);
html::Section desirability_section(const ReportContext& context);
html::Section rounds_section(const ReportContext& context);
html::Section routes_section(const ReportContext& context);
html::Section failure_section(const ReportContext& context);
html::Section trade_off_section(const ReportContext& context);
html::Section cost_section(const ReportContext& context);
html::Section definitions_section(const ReportContext& context);
html::Section provenance_section(const ReportContext& context);

}  // namespace asperity::app
