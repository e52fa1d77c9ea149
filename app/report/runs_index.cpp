#include "app/report/runs_index.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/report/calibration_report.hpp"
#include "app/report/document.hpp"
#include "app/report/mechanism_words.hpp"
#include "app/report/quantities.hpp"
#include "app/report/run_report.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/build_info.hpp"
#include "core/base/error.hpp"
#include "core/config/read_config.hpp"
#include "core/output/html_sortable.hpp"
#include "core/output/manifest.hpp"
#include "core/output/run_folder.hpp"
#include "render/scene.hpp"
#include "render/series.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;
using html::ColumnKind;
using html::Markup;

std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Keys of summary.json's results that an experiment's row shows: the strength, and where it was reached.
struct KeyResults {
  const char* strength;
  const char* place;
  double factor;  ///< Of the place, to % or mm.
  const char* unit;
};

KeyResults key_results(ExperimentType type) {
  if (type == ExperimentType::direct_shear) return {"peak_shear_stress_mpa", "peak_shear_displacement_mm", 1, "mm"};
  if (type == ExperimentType::brazilian) return {"tensile_strength_mpa", "peak_closure_mm", 1, "mm"};
  return {"peak_axial_stress_mpa", "peak_axial_strain", 100, "%"};
}

std::string experiment_words(const RunConfig& config) {
  std::string words = experiment_title(config.experiment.type);
  if (config.experiment.type == ExperimentType::triaxial)
    words += fmt::format(", {:g} MPa", config.experiment.confining_pressure_mpa);
  if (config.experiment.type == ExperimentType::direct_shear)
    words += fmt::format(", {:g} MPa", config.experiment.normal_stress_mpa);
  return words;
}

std::string set_up_words(const RunConfig& config) {
  const std::string mechanisms = mechanism_words(config);
  return fmt::format("seed {}, edge {:g} mm{}", config.particles.seed, config.particles.edge_mm,
                     mechanisms.empty() ? "" : "; " + mechanisms);
}

/// The last frame in the first of the configuration's fields that was drawn, its preview if there is one; else the
/// strip.
std::optional<fs::path> last_picture(const fs::path& run, const RunConfig& config) {
  const int last = fs::exists(run / "fields.pvd") ? static_cast<int>(render::series_times(run).size()) - 1 : -1;
  for (const std::string& name : config.output.fields) {
    const auto field = render::field_from_name(name);
    if (!field) continue;
    const fs::path picture = render::picture_path("", *field, last), preview = render::preview_path(picture);
    if (fs::exists(run / preview)) return preview;
    if (fs::exists(run / picture)) return picture;
  }
  const fs::path strip = fs::path("plots") / "strip.png";
  return fs::exists(run / strip) ? std::optional(strip) : std::nullopt;
}

/// The page of a run, or its folder where it has none.
fs::path page_of(const fs::path& run) {
  return run.filename() / (fs::exists(run / "report.html") ? "report.html" : "");
}

Markup picture_cell(const fs::path& run, const RunConfig& config) {
  const std::optional<fs::path> picture = last_picture(run, config);
  if (!picture) return "";
  const std::string field = picture->stem().string();
  return html::thumbnail({html::linked_source(run.filename() / *picture),
                          "Last picture of " + run.filename().string() + ": " + field.substr(0, field.find('_'))},
                         page_of(run));
}

std::string status_of(const fs::path& run, const Manifest& manifest) {
  switch (manifest.outcome) {
    case Outcome::finished:
      return "finished";
    case Outcome::failed:
      return "failed: " + manifest.exit_reason;
    case Outcome::interrupted:
      return "interrupted";
    case Outcome::running:
      break;
  }
  return is_written(run) ? "running" : "cut off";
}

html::RowTone tone_of(const Manifest& manifest) {
  if (manifest.outcome == Outcome::failed) return html::RowTone::bad;
  return manifest.outcome == Outcome::finished ? html::RowTone::plain : html::RowTone::quiet;
}

/// "2026-03-01 12:34" of the end, or of the start where there is no end yet.
std::string date_of(const Manifest& manifest) {
  constexpr std::size_t kToMinutes = 16;
  std::string date = (manifest.ended_utc.empty() ? manifest.started_utc : manifest.ended_utc).substr(0, kToMinutes);
  std::replace(date.begin(), date.end(), 'T', ' ');
  return date;
}

Markup count_cell(const Value& value) { return value.is_number() ? html::fixed(value.number(), 0) : Markup("–"); }

void add_results(const Value& summary, ExperimentType type, html::Row& row) {
  const KeyResults keys = key_results(type);
  const Value place = summary["results"][keys.place];
  row.cells.push_back(html::number(summary["results"][keys.strength].number()));
  row.cells.push_back(place.exists() ? html::number(keys.factor * place.number(), 3) + " " + keys.unit : Markup("–"));
  for (const char* key : {"tension", "shear", "fragments"}) row.cells.push_back(count_cell(summary["cracks"][key]));
  const Value failure = summary["failure_mode"];
  const std::string teeth = failure["teeth_failed"].text(), verdict = failure["at_end"]["verdict"].text();
  std::string words = teeth.empty() ? verdict : "teeth failed: " + teeth;
  std::replace(words.begin(), words.end(), '_', ' ');
  row.cells.push_back(words.empty() ? "–" : words);
}

html::Row row_of(const fs::path& run) try {
  const RunConfig config = read_run_config(run / "config.effective.json");
  const Manifest manifest = read_manifest(run / "manifest.json");
  html::Row row{{picture_cell(run, config), html::link(page_of(run), run.filename().string()), experiment_words(config),
                 set_up_words(config)},
                tone_of(manifest)};
  if (fs::exists(run / "summary.json")) {
    const Document summary(run / "summary.json");
    add_results(summary.root(), config.experiment.type, row);
  } else {
    row.cells.insert(row.cells.end(), 6, "–");
  }
  row.cells.push_back(status_of(run, manifest));
  row.cells.push_back(date_of(manifest));
  return row;
} catch (const Error& error) {
  html::Row row{{"", html::link(run.filename() / "", run.filename().string())}, html::RowTone::bad};
  row.cells.insert(row.cells.end(), 8, "–");
  row.cells.push_back(std::string("cannot be read: ") + error.what());
  row.cells.push_back("–");
  return row;
}

html::Table runs_table(const std::vector<fs::path>& entries) {
  html::Table table{
      "Strength: largest axial stress (σ₁), 2P/(πDt) or shear stress; beside it the strain, closure or shear "
      "displacement at which it was reached. Dates are UTC, of the end.",
      {{"", {}, ColumnKind::text},
       {"Run", {}, ColumnKind::head},
       {"Experiment", {}, ColumnKind::text},
       {"Set-up", {}, ColumnKind::text},
       {"Strength", "MPa"},
       {"At"},
       {"Tension", "broken"},
       {"Shear", "broken"},
       {"Fragments"},
       {"Failure", {}, ColumnKind::text},
       {"Status", {}, ColumnKind::text},
       {"Date", {}, ColumnKind::text}},
      {}};
  for (const fs::path& entry : entries)
    if (fs::is_directory(entry) && is_run_folder(entry)) table.rows.push_back(row_of(entry));
  return table;
}

/// Pages that are no run's: comparisons, calibrations, the gallery.
std::vector<Markup> other_pages(const std::vector<fs::path>& entries) {
  std::vector<Markup> pages;
  for (const fs::path& entry : entries) {
    const std::string name = entry.filename().string();
    if (entry.extension() == ".html" && name != "index.html") pages.push_back(html::link(name, name));
    if (!fs::is_directory(entry) || is_run_folder(entry)) continue;
    for (const char* page : {"report.html", "gallery.html", "index.html"})
      if (fs::exists(entry / page)) pages.push_back(html::link(fs::path(name) / page, name + "/" + page));
  }
  return pages;
}

}  // namespace

bool holds_results(const fs::path& folder) {
  const std::vector<fs::path> entries = sorted_entries(folder);
  return std::any_of(entries.begin(), entries.end(), [](const fs::path& entry) {
    return fs::is_directory(entry) && (is_run_folder(entry) || is_calibration_folder(entry));
  });
}

fs::path write_runs_index(const fs::path& folder) {
  const std::vector<fs::path> entries = sorted_entries(folder);
  const html::Table runs = runs_table(entries);
  const fs::path whole = fs::absolute(folder).lexically_normal();
  const std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
  html::Page page{
      "Runs in " + name, fmt::format("{} {}", runs.rows.size(), runs.rows.size() == 1 ? "run" : "runs"), {}, {}, {}};
  page.sections.push_back({"Runs", {html::sortable_table(runs, "runs")}, {}});
  if (const std::vector<Markup> others = other_pages(entries); !others.empty())
    page.sections.push_back({"Other pages", {html::bullet_list(others)}, {}});
  page.foot =
      "Page made by Asperity " + std::string(build_info().version) + ", revision " + build_info().revision + ".";
  page.script = html::sortable_table_script();
  write_file_atomically(folder / "index.html", html::document(page));
  return folder / "index.html";
}

}  // namespace asperity::app
