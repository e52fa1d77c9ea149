#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/confrontation/chapters.hpp"
#include "app/confrontation/confrontation_data.hpp"
#include "render/bar_panels.hpp"
#include "render/charts.hpp"
#include "render/matrix_plot.hpp"

/// The pictures of a confrontation's report: what is drawn as pure functions, and the drawing into plots/ (PNG and SVG)
/// and pictures/ (PNG). Drawing throws Error(output).
namespace asperity::app {

/// "a + b" of the model that is shown beside the base; empty: none.
std::string extension_name(const ConfrontationData& data);

/// "T30: triaxial, σ₃ = 30 MPa, kept back".
std::string test_title(const ShownTest& test);

/// Residuals of the base, and beside them the extension's.
render::BarPanels residual_bars(const ConfrontationData& data);

/// The residual without what calibration absorbs, and what the leading candidates make of it.
render::BarPanels fingerprint_bars(const ConfrontationData& data);

/// Between the leading candidates; nothing for fewer than two.
std::optional<render::MatrixPlot> cosine_picture(const ConfrontationData& data);

/// One panel a test that has measured curves, at most six a figure.
std::vector<render::ChartFigure> curve_figures(const ConfrontationData& data);

/// Peaks against confining pressure (uniaxial: 0), or of joints against normal stress, where three tests or more differ
/// in it.
std::optional<render::ChartFigure> strength_figure(const ConfrontationData& data);
std::optional<render::ChartFigure> joint_strength_figure(const ConfrontationData& data);

PlainFigure draw_bars(const ConfrontationData& data, const render::BarPanels& bars, const PlainFigure& texts);
PlainFigure draw_matrix(const ConfrontationData& data, const render::MatrixPlot& matrix, const PlainFigure& texts);
PlainFigure draw_charts(const ConfrontationData& data, const render::ChartFigure& figure, const PlainFigure& texts);

/// Cracks at the end of the first mesh's runs of base and extension, side by side at one scale: of each experiment
/// the first test, and the one whose stress differs most from its. A picture that was drawn before stands where its
/// run is gone.
std::vector<PlainFigure> pattern_figures(const ConfrontationData& data);

}  // namespace asperity::app
