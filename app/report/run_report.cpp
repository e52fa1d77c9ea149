#include "app/report/run_report.hpp"

#include <fmt/format.h>

#include "app/report/run_parts.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/build_info.hpp"
#include "core/config/read_config.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/output/html_viewer.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

/// A JSON file of the folder; absent where it is not there.
class OptionalDocument {
 public:
  explicit OptionalDocument(const fs::path& path) : path_(path.string()) {
    if (fs::exists(path)) document_.emplace(path);
  }
  Value root() const { return document_ ? document_->root() : Value(nullptr, path_ + ": "); }

 private:
  std::string path_;
  std::optional<Document> document_;
};

CsvData table_or_empty(const fs::path& path) { return fs::exists(path) ? read_csv(path) : parse_csv("time_s\n", path); }

html::Markup subtitle(const RunContext& c) {
  const Value& m = c.manifest;
  const std::string changed = m["dirty"].truth() ? " with changed files" : "";
  return fmt::format("{} · configuration {}, hash {:.12} · seed {} · {} · Asperity {}, revision {:.12}{}",
                     experiment_title(c.config.experiment.type), c.config.name, m["config_hash"].text(),
                     c.config.particles.seed, m["started_utc"].text(), m["version"].text(), m["revision"].text(),
                     changed);
}

std::vector<html::Section> sections(const RunContext& context) {
  std::vector<html::Section> all;
  for (const auto part :
       {results_section, pictures_section, curves_section, teeth_section, closed_forms_section, failure_mode_section,
        crack_section, energy_section, events_section, run_cost_section, run_provenance_section}) {
    html::Section section = part(context);
    if (!section.parts.empty() || !section.sections.empty()) all.push_back(std::move(section));
  }
  return all;
}

}  // namespace

std::string experiment_title(ExperimentType type) {
  switch (type) {
    case ExperimentType::uniaxial:
      return "Uniaxial compression";
    case ExperimentType::triaxial:
      return "Triaxial compression";
    case ExperimentType::brazilian:
      return "Brazilian disc";
    case ExperimentType::direct_shear:
      return "Direct shear of a joint";
  }
  return "";
}

bool is_run_folder(const fs::path& folder) {
  return fs::exists(folder / "manifest.json") && fs::exists(folder / "config.effective.json");
}

fs::path write_run_report(const fs::path& folder) {
  const OptionalDocument summary(folder / "summary.json");
  const Document manifest(folder / "manifest.json");
  RunContext context{folder,
                     read_run_config(folder / "config.effective.json"),
                     summary.root(),
                     manifest.root(),
                     table_or_empty(folder / "curves.csv"),
                     {},
                     {}};
  context.frames = run_frames(folder, context.curves, context.config.experiment.type);
  if (context.sheared() && fs::exists(folder / "cracks.csv"))
    context.joint = joint_numbers(context.config, context.summary, context.curves, read_csv(folder / "cracks.csv"));
  html::Page page{
      "Run " + context.config.name, subtitle(context), run_warnings(context), sections(context),
      "Page made by Asperity " + std::string(build_info().version) + ", revision " + build_info().revision + "."};
  page.script = html::frame_viewer_script();
  const fs::path report = folder / "report.html";
  write_file_atomically(report, html::document(page));
  return report;
}

}  // namespace asperity::app
