#include <fmt/format.h>

#include "app/compare/comparison.hpp"
#include "app/report/quantities.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/build_info.hpp"
#include "core/output/html.hpp"
#include "render/side_panel.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;
using html::ColumnKind;
using html::Markup;

std::string inside(const fs::path& png) { return html::embedded_source(read_file(png), "image/png"); }

/// A link to a file by its path from the page's folder.
Markup link_from(const ComparisonFiles& files, const fs::path& target, const std::string& text) {
  const fs::path page = files.html.has_parent_path() ? files.html.parent_path() : ".";
  return html::link(fs::absolute(target).lexically_normal().lexically_relative(fs::absolute(page).lexically_normal()),
                    text);
}

std::string panels_in_words(const Comparison& c) {
  std::string words;
  for (std::size_t i = 0; i < c.runs.size(); ++i) {
    const PatternMeasures& m = c.patterns[i].measures;
    words += fmt::format("{} {}: {}, {:.0f} contacts broken in tension and {:.0f} in shear. ", i == 0 ? "" : " ",
                         c.runs[i].letter, c.labels[i], m.cracks_tension, m.cracks_shear);
  }
  return words;
}

html::Section patterns_section(const Comparison& c, const ComparisonFiles& files) {
  html::Section section{"Patterns", {}, {}};
  section.parts.push_back(html::figure(
      {{{inside(files.picture),
         "Specimens side by side with their " + std::string(render::field_name(c.field)) + ". " + panels_in_words(c)}},
       capitalised(c.aligned.words) + ", as near as frames were taken; one scale, one legend. Roses: crack length by "
                                      "orientation, the loading axis upwards.",
       {}}));
  if (fs::exists(files.beside("_difference.png")))
    section.parts.push_back(html::figure(
        {{{inside(files.beside("_difference.png")),
           "The mesh at rest, coloured by the damage of B less that of A; contacts broken in both runs, in A alone and "
           "in B alone."}},
         "Both runs have one mesh. Red: more damage in B; blue: more in A; white: as much.",
         {}}));
  return section;
}

html::Section curves_of(const ComparisonFiles& files) {
  html::Section section{"Curves", {}, {}};
  section.parts.push_back(html::figure({{{inside(files.beside("_curves.png")),
                                          "The stress of every run over strain or displacement, with a point where its "
                                          "frame was taken."}},
                                        "Points: the frames compared.",
                                        {}}));
  return section;
}

html::Table run_columns(const Comparison& c, const Markup& caption, const char* first) {
  html::Table table{caption, {{first, {}, ColumnKind::head}}, {}};
  for (const ComparedRun& run : c.runs) table.columns.push_back({run.letter, run.name});
  return table;
}

html::Section measures_section(const Comparison& c, const ComparisonFiles& files) {
  html::Section section{"Measures", {}, {}};
  html::Table table = run_columns(c,
                                  "Angles from the loading axis, positive to the right; “–”: there is none. Energies "
                                  "are shares of the external work.",
                                  "Measure");
  table.columns.insert(table.columns.begin() + 1, {"Unit", {}, ColumnKind::text});
  for (const MeasureKind& kind : measure_kinds()) {
    html::Row row{{kind.name, kind.unit}};
    for (const MeasuredPattern& pattern : c.patterns) row.cells.push_back(measure_text(pattern.measures.*kind.value));
    table.rows.push_back(std::move(row));
  }
  section.parts.push_back(html::table(table));
  section.parts.push_back(html::paragraph(
      "The distance of orientations is the mean angle by which a piece of crack has to be turned to make one "
      "distribution the other (Wasserstein's, on the circle; 0 to 90°). Damage shared is Σ min over Σ max of "
      "the two runs' damage, by area: 1 for the same, 0 for damage at other places."));
  section.parts.push_back(html::paragraph(Markup("As files: ") + link_from(files, files.beside(".csv"), "table") +
                                          ", " + link_from(files, files.beside("_orientation.csv"), "orientations") +
                                          ", " + link_from(files, files.beside(".md"), "Markdown") + "."));
  return section;
}

html::Section differences_section(const Comparison& c) {
  html::Section section{"What differs", {}, {}};
  if (c.keys.empty()) {
    section.parts.push_back(
        html::paragraph("The configurations are the same but for their names and what is written out."));
    return section;
  }
  html::Table table =
      run_columns(c, "Every key of the effective configurations that is not the same in all runs.", "Key");
  for (const DifferingKey& key : c.keys) {
    html::Row row{{html::code(key.pointer)}};
    for (const std::string& value : key.values) row.cells.emplace_back(value);
    table.rows.push_back(std::move(row));
  }
  section.parts.push_back(html::table(table));
  return section;
}

html::Section runs_section(const Comparison& c, const ComparisonFiles& files) {
  html::Section section{"Runs", {}, {}};
  html::Table table{{},
                    {{"Run", {}, ColumnKind::head},
                     {"Folder", {}, ColumnKind::text},
                     {"Differs by", {}, ColumnKind::prose},
                     {"Revision", {}, ColumnKind::text},
                     {"Ended (UTC)", {}, ColumnKind::text}},
                    {}};
  for (std::size_t i = 0; i < c.runs.size(); ++i) {
    const ComparedRun& run = c.runs[i];
    const fs::path report = run.folder / "report.html";
    table.rows.push_back({{run.letter, fs::exists(report) ? link_from(files, report, run.name) : Markup(run.name),
                           c.labels[i], fmt::format("{:.12}", run.manifest.build.revision), run.manifest.ended_utc}});
  }
  section.parts.push_back(html::table(table));
  return section;
}

}  // namespace

void write_comparison_page(const Comparison& c, const ComparisonFiles& files) {
  html::Page page{title_of(c), capitalised(c.aligned.words), {}, {}, {}};
  for (const std::string& warning : c.warnings)
    page.lead.push_back(html::notice(html::NoticeKind::warning, warning + "."));
  page.sections = {patterns_section(c, files), curves_of(files), measures_section(c, files), differences_section(c),
                   runs_section(c, files)};
  page.foot =
      "Page made by Asperity " + std::string(build_info().version) + ", revision " + build_info().revision + ".";
  write_file_atomically(files.html, html::document(page));
}

}  // namespace asperity::app
