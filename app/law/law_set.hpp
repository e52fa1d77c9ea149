#pragma once
#include <string>
#include <vector>

#include "core/contact/law_paths.hpp"
#include "core/output/csv.hpp"
#include "render/charts.hpp"

/// What the pictures of a contact law are made of: the configuration's own law and the other reading of the same
/// contact, driven along paths, and the figures of these paths.
namespace asperity::app {

/// A law with its name in legends.
struct NamedLaw {
  std::string name;
  DrivenLaw law;
};

/// The configuration's law, and the default one where that is literal, or the literal one as printed.
struct LawSet {
  NamedLaw own, other;
  std::string title;       ///< Name of the configuration.
  std::string parameters;  ///< A sentence for captions.
};

/// Of a configuration that its mechanisms have not been applied to; errors as with_mechanisms and law_parameters.
LawSet law_set(const RunConfig& config);

/// A figure with the paths it shows.
struct LawFigure {
  std::string name;  ///< Of its files.
  render::ChartFigure figure;
  std::vector<std::vector<CsvCell>> rows;
};

/// Columns of all tables of paths.
std::vector<std::string> law_columns();

/// Adds a path's points to a table under the law's name and its own.
void add_rows(std::vector<std::vector<CsvCell>>& rows, const NamedLaw& law, const std::string& path_name,
              const LawPath& path);

/// Fig. 3a: opening with unloading and reloading, G_f, closing.
LawFigure tension_figure(const LawSet& set);

/// Fig. 3b: slip at several pressures, unloading and reloading, the energy of shear, closing.
LawFigure shear_figure(const LawSet& set);

/// Strength over normal stress, and the traction along mixed openings.
LawFigure strength_figure(const LawSet& set);

/// Where damage begins and where the bond is broken, over opening and slip.
LawFigure damage_figure(const LawSet& set);

/// The line of a path: traction along the normal over the opening, or along the slip over the slip; arrows in the
/// middle of what is unloaded and loaded again.
enum class PathView { opening, slip };
render::LineLayer line_of(const LawPath& path, PathView view, const std::string& label, const render::Stroke& stroke);

/// The strokes of the two laws: own solid and thick, the other dashed and thin, so that it shows on top.
render::Stroke own_stroke(render::Colour colour);
render::Stroke other_stroke(render::Colour colour);

/// Points with names, without a place in the legend.
render::PointLayer named_points(const std::vector<Vec2>& at, std::vector<std::string> names);

/// Three significant digits, or all before the point: "6.89", "0.00748", "2504".
std::string short_number(double value);

}  // namespace asperity::app
