#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/confrontation/words.hpp"
#include "app/gallery/gallery_pictures.hpp"
#include "app/report/report_parts.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/build_info.hpp"
#include "core/base/output_error.hpp"
#include "core/config/enum_words.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/output/html.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kTold = 6;     // changes of one experiment in a table
constexpr std::size_t kBriefly = 2;  // in the overview
constexpr double kLeast = 0.01;      // of a feature's size: less is not told

const GalleryRuns* part_of(const Gallery& gallery, const std::string& mechanism, ExperimentType type) {
  for (const GalleryRuns& part : gallery.parts) {
    if (part.mechanism == mechanism && part.experiment == type) return &part;
  }
  return nullptr;
}

std::vector<ExperimentType> experiments_of(const Gallery& gallery) {
  std::vector<ExperimentType> types;
  for (const GalleryRuns& part : gallery.parts) {
    if (part.mechanism.empty()) types.push_back(part.experiment);
  }
  return types;
}

std::string failure_of(const GalleryRuns& part) {
  for (const CampaignOutcome& outcome : part.outcomes) {
    if (outcome.status == RunStatus::failed) return outcome.reason;
  }
  return "";
}

/// "peak stress -12 %": in shares where the base has a size, else in the feature's unit.
std::string change_text(const FeatureChange& c) {
  const std::string name = feature_words(c.kind->name);
  if (std::abs(c.base) > std::abs(c.change) * 0.05)
    return fmt::format("{} {:+.0f} %", name, 100.0 * c.change / std::abs(c.base));
  return fmt::format("{} {:+.3g}{}", name, c.change, c.kind->unit == "1" ? "" : " " + std::string(c.kind->unit));
}

std::string brief(const Gallery& gallery, const MechanismDeclaration& m, ExperimentType type) {
  const GalleryRuns* part = part_of(gallery, m.id, type);
  if (!part) return "–";
  const std::string failure = failure_of(*part);
  std::string text;
  for (const FeatureChange& c : telling_changes(part->changes, kBriefly, kLeast)) {
    text += (text.empty() ? "" : "; ") + change_text(c);
  }
  if (text.empty()) text = "nothing beyond the meshes' scatter";
  return failure.empty() ? text : text + " (a run failed: " + failure + ")";
}

html::Markup overview_table(const Gallery& gallery) {
  html::Table table{"The two changes of each experiment that stand out most from the scatter of the meshes.", {}, {}};
  table.columns.push_back({"Mechanism", {}, html::ColumnKind::head});
  const std::vector<ExperimentType> types = experiments_of(gallery);
  for (const ExperimentType type : types)
    table.columns.push_back({feature_words(word(type)), {}, html::ColumnKind::prose});
  for (const MechanismDeclaration& m : gallery.mechanisms) {
    html::Row row{{m.id}};
    for (const ExperimentType type : types) row.cells.push_back(brief(gallery, m, type));
    table.rows.push_back(std::move(row));
  }
  return html::table(table);
}

html::Markup fingerprint_table(const GalleryRuns& part) {
  html::Table table{feature_words(word(part.experiment)) + ": what changes most against the meshes' scatter.",
                    {{"Feature", {}, html::ColumnKind::head},
                     {"Unit", {}, html::ColumnKind::text},
                     {"Without", {}},
                     {"Change", {}},
                     {"Share", "%"},
                     {"Over the scatter of one mesh", {}},
                     {"Meshes", {}}},
                    {}};
  for (const FeatureChange& c : telling_changes(part.changes, kTold, kLeast)) {
    table.rows.push_back({{feature_words(c.kind->name), std::string(c.kind->unit),
                           html::with_scatter(c.base, c.base_sd), html::with_scatter(c.change, c.change_error),
                           c.base != 0.0 ? html::fixed(100.0 * c.change / std::abs(c.base), 1) : html::Markup("–"),
                           html::fixed(c.scatter_ratio, 1), std::to_string(c.meshes)}});
  }
  if (table.rows.empty())
    return html::paragraph(feature_words(word(part.experiment)) + ": nothing beyond the meshes' scatter.");
  return html::table(table);
}

html::Markup told(const MechanismDeclaration& m) {
  std::vector<html::Definition> entries{
      {"Equation", m.equation}, {"Source", m.source}, {"Why the strong values", m.reason}, {"Expected", m.expectation}};
  for (const MechanismParameter& p : m.parameters) {
    const std::string unit = p.unit == "1" ? "" : " " + p.unit;
    entries.push_back(
        {html::code(p.key), fmt::format("{}; {} to {}{}, strong {}{}", p.description, number_text(p.lowest),
                                        number_text(p.highest), unit, number_text(p.strong), unit)});
  }
  return html::definition_list(entries);
}

html::Markup patterns(const Gallery& gallery, const MechanismDeclaration& m, const fs::path& folder) {
  html::Figure figure{{}, "", {}};
  for (const ExperimentType type : experiments_of(gallery)) {
    const GalleryRuns* part = part_of(gallery, m.id, type);
    if (!part) continue;
    for (const GalleryRuns* one : {base_of(gallery, type), part}) {
      if (const auto picture = draw_pattern(*one, folder))
        figure.pictures.push_back({html::linked_source(picture->path), picture->alternative_text});
    }
  }
  if (figure.pictures.empty()) return {};
  figure.caption =
      "Cracks at the end of the first mesh's runs: of each experiment the one without, then the one with " + m.id +
      ". Blue: tension; vermilion with a white core: shear; thin purple: softening.";
  return html::figure(figure);
}

html::Section section_of(const Gallery& gallery, const MechanismDeclaration& m, const fs::path& folder) {
  html::Section section{m.id + ": " + m.title, {told(m)}, {}};
  for (const GalleryRuns& part : gallery.parts) {
    if (part.mechanism != m.id) continue;
    const std::string failure = failure_of(part);
    if (!failure.empty())
      section.parts.push_back(
          html::notice(html::NoticeKind::warning, feature_words(word(part.experiment)) + ": a run failed: " + failure));
  }
  if (const auto curves = draw_curves(gallery, m, folder)) {
    fs::path svg = curves->path;
    section.parts.push_back(html::figure({{{html::linked_source(curves->path), curves->alternative_text}},
                                          "Curves of all meshes; the loop is the one that every base has.",
                                          {{svg.replace_extension(".svg"), "SVG"}}}));
  }
  for (const GalleryRuns& part : gallery.parts) {
    if (part.mechanism == m.id) section.parts.push_back(fingerprint_table(part));
  }
  section.parts.push_back(patterns(gallery, m, folder));
  return section;
}

Json change_json(const FeatureChange& c) {
  return {{"feature", c.kind->name},
          {"unit", c.kind->unit},
          {"meshes", c.meshes},
          {"base", c.base},
          {"base_sd", c.base_sd},
          {"change", c.change},
          {"change_error", c.change_error},
          {"scatter_ratio", c.scatter_ratio}};
}

std::string json_of(const Gallery& gallery) {
  Json parts = Json::array();
  for (const GalleryRuns& part : gallery.parts) {
    Json runs = Json::array(), changes = Json::array();
    for (std::size_t i = 0; i < part.outcomes.size(); ++i) {
      runs.push_back({{"seed", gallery.seeds[i]},
                      {"folder", part.outcomes[i].folder.string()},
                      {"reason", part.outcomes[i].reason}});
    }
    for (const FeatureChange& c : part.changes) {
      if (c.meshes > 0) changes.push_back(change_json(c));
    }
    parts.push_back(
        {{"experiment", word(part.experiment)}, {"mechanism", part.mechanism}, {"runs", runs}, {"changes", changes}});
  }
  return Json{{"seeds", gallery.seeds}, {"parts", parts}}.dump(2) + "\n";
}

std::string markdown_of(const Gallery& gallery) {
  const std::vector<ExperimentType> types = experiments_of(gallery);
  std::string text = "| mechanism |", rule = "|---|";
  for (const ExperimentType type : types) {
    text += " " + feature_words(word(type)) + " |";
    rule += "---|";
  }
  text += "\n" + rule + "\n";
  for (const MechanismDeclaration& m : gallery.mechanisms) {
    text += "| `" + m.id + "` |";
    for (const ExperimentType type : types) text += " " + brief(gallery, m, type) + " |";
    text += "\n";
  }
  return text;
}

void make_subfolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw output_error(folder, "cannot be created", error.value());
}

}  // namespace

fs::path write_gallery(const Gallery& gallery, const fs::path& folder) {
  make_subfolder(folder / "curves");
  make_subfolder(folder / "patterns");
  html::Page page{
      "Gallery of mechanisms",
      fmt::format("{} mechanisms at their declared strong amplitude, on {} meshes that each test has with and "
                  "without them",
                  gallery.mechanisms.size(), gallery.seeds.size()),
      {},
      {{"Overview", {overview_table(gallery)}, {}}},
      "Made by Asperity " + std::string(build_info().version) + ", revision " + build_info().revision + "."};
  for (const MechanismDeclaration& m : gallery.mechanisms) page.sections.push_back(section_of(gallery, m, folder));
  write_file_atomically(folder / "gallery.json", json_of(gallery));
  write_file_atomically(folder / "gallery.md", markdown_of(gallery));
  write_file_atomically(folder / "gallery.html", html::document(page));
  return folder / "gallery.html";
}

}  // namespace asperity::app
