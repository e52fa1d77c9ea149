#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/report/document.hpp"
#include "app/report/joint_numbers.hpp"
#include "app/run_frames.hpp"
#include "core/config/run_config.hpp"
#include "core/output/csv.hpp"
#include "core/output/html.hpp"

/// The parts of a run's report. Each is a section of the page; one without parts has nothing to say and is left out.
namespace asperity::app {

/// What every part reads, all of it from the run's folder. A summary or manifest that is not there is an absent value.
struct RunContext {
  std::filesystem::path folder;
  RunConfig config;
  Value summary, manifest;
  CsvData curves;
  std::vector<RunFrame> frames;
  std::optional<JointNumbers> joint;  ///< Of a direct shear test that has its results and closed forms.
  bool sheared() const { return config.experiment.type == ExperimentType::direct_shear; }
};

/// A picture or plot of the folder with its caption, and a link to its SVG where there is one; nothing where it was not
/// drawn.
std::optional<html::Markup> run_figure(const RunContext& context, const std::string& name,
                                       const std::string& alternative_text, const html::Markup& caption);

/// "shear displacement 0.48 mm, shear stress 1.40 MPa" of a frame.
std::string frame_text(const RunContext& context, const RunFrame& frame);

/// One notice a warning, and that a run did not come to its end.
std::vector<html::Markup> run_warnings(const RunContext& context);

html::Section results_section(const RunContext& context);
html::Section pictures_section(const RunContext& context);
html::Section curves_section(const RunContext& context);
html::Section teeth_section(const RunContext& context);
html::Section closed_forms_section(const RunContext& context);
html::Section failure_mode_section(const RunContext& context);
html::Section crack_section(const RunContext& context);
html::Section energy_section(const RunContext& context);
html::Section events_section(const RunContext& context);
html::Section run_cost_section(const RunContext& context);
html::Section run_provenance_section(const RunContext& context);

}  // namespace asperity::app
