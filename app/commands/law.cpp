#include <iostream>

#include "app/commands/commands.hpp"
#include "app/law/law_set.hpp"
#include "app/result_folder.hpp"
#include "core/config/read_config.hpp"
#include "core/output/run_folder.hpp"
#include "render/paint.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

void write_figure(const LawFigure& figure, const fs::path& folder) {
  const render::Drawing drawing = render::draw_figure(figure.figure);
  const fs::path png = folder / (figure.name + ".png"), svg = folder / (figure.name + ".svg"),
                 csv = folder / (figure.name + ".csv");
  render::write_png(drawing, png);
  render::write_svg(drawing, svg);
  write_csv(csv, law_columns(), figure.rows);
  for (const fs::path& path : {png, svg, csv}) std::cout << path.string() << "\n";
}

}  // namespace

int law_command(const LawOptions& options) {
  const RunConfig config = read_run_config(options.config, options.overrides);
  const LawSet set = law_set(config);
  const fs::path folder = options.out.value_or(default_run_folder(config.name + "_law"));
  make_folder(folder);
  for (const auto& figure : {tension_figure, shear_figure, strength_figure, damage_figure})
    write_figure(figure(set), folder);
  std::cout << folder.string() << "\n";
  return 0;
}

}  // namespace asperity::app
