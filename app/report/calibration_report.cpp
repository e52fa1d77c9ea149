#include "app/report/calibration_report.hpp"

#include "app/report/report_parts.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/build_info.hpp"

namespace asperity::app {
namespace {

constexpr const char* kDocument = "calibration.json";

html::Markup subtitle(const Value& root) {
  const bool data = root["kind"].text() == "data";
  return data ? "Microparameters from given runs" : "Microparameters from simulated runs on a design of experiments";
}

std::vector<html::Section> sections(const ReportContext& context) {
  std::vector<html::Section> all;
  for (const auto part :
       {outcome_section, parameters_section, elastic_section, trade_off_section, failure_section, design_section,
        models_section, surfaces_section, effects_section, fits_section, desirability_section, rounds_section,
        routes_section, cost_section, definitions_section, provenance_section}) {
    html::Section section = part(context);
    if (!section.parts.empty() || !section.sections.empty()) all.push_back(std::move(section));
  }
  return all;
}

}  // namespace

bool is_calibration_folder(const std::filesystem::path& folder) { return std::filesystem::exists(folder / kDocument); }

std::filesystem::path write_calibration_report(const std::filesystem::path& folder) {
  const Document document(folder / kDocument);
  const ReportContext context{folder, document.root(), read_calibration_data(document.root())};
  make_folder(folder / "plots");
  html::Page page{
      "Calibration " + (context.root["name"].exists() ? context.root["name"].text() : folder.filename().string()),
      subtitle(context.root), warnings(context), sections(context),
      "Made by Asperity " + std::string(build_info().version) + ", revision " + build_info().revision + "."};
  const std::filesystem::path report = folder / "report.html";
  write_file_atomically(report, html::document(page));
  return report;
}

}  // namespace asperity::app
