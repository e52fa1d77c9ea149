#include "app/joint_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/report/document.hpp"
#include "core/base/output_error.hpp"
#include "core/contact/joint_strength.hpp"
#include "core/experiment/joint_results.hpp"
#include "core/geometry/joint_profile.hpp"
#include "render/charts.hpp"
#include "render/paint.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLeastStresses = 3;
constexpr int kCurveParts = 200;

/// What the runs of one envelope have in common.
RunConfig without_load(RunConfig config) {
  config.name.clear();
  config.description.clear();
  config.experiment.normal_stress_mpa = 0.0;
  config.particles.seed = 0;
  return config;
}

bool is_one_joint(const CampaignConfig& campaign) {
  std::set<double> stresses;
  for (const CampaignRun& run : campaign.runs) {
    if (run.config.experiment.type != ExperimentType::direct_shear) return false;
    if (!(without_load(run.config) == without_load(campaign.runs.front().config))) return false;
    stresses.insert(run.config.experiment.normal_stress_mpa);
  }
  return stresses.size() >= kLeastStresses;
}

struct Strengths {
  std::vector<double> normal, peak, residual;
};

Strengths simulated(const CampaignConfig& campaign, const std::vector<CampaignOutcome>& outcomes) {
  Strengths s;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (outcomes[i].status != RunStatus::finished) continue;
    const Document summary(outcomes[i].folder / "summary.json");
    const Value results = summary.root()["results"];
    s.normal.push_back(campaign.runs[i].config.experiment.normal_stress_mpa);
    s.peak.push_back(results["peak_shear_stress_mpa"].number());
    s.residual.push_back(results["residual_shear_stress_mpa"].number());
  }
  return s;
}

render::LineLayer line(const std::string& label, const std::vector<double>& x, std::vector<double> y,
                       render::Colour colour, std::vector<double> dash) {
  for (double& value : y) value = std::isfinite(value) ? value : std::nan("");
  return {label, x, std::move(y), {colour, 3.0, std::move(dash)}};
}

render::ChartFigure figure_of(const ToothedJoint& joint, const Strengths& runs) {
  using namespace render::style;
  const double most = 1.1 * *std::max_element(runs.normal.begin(), runs.normal.end());
  std::vector<double> normal;
  for (int i = 0; i <= kCurveParts; ++i) normal.push_back(most * i / kCurveParts);
  const StrengthEnvelope e = strength_envelope(joint, normal);
  render::Chart chart{"", "normal stress σ_{n} [MPa]", "shear strength τ [MPa]", {}, {}, {}, {}};
  chart.layers.emplace_back(line("Patton: sliding, σ_{n} tan(φ_{j} + i)", normal, e.sliding, kBlue, kDashes[0]));
  chart.layers.emplace_back(
      line("Patton: sheared through, C b/L + σ_{n} tan φ", normal, e.base_shear, kVermilion, kDashes[1]));
  chart.layers.emplace_back(line("Ladanyi & Archambault", normal, e.ladanyi_archambault, kGreen, kDashes[3]));
  chart.layers.emplace_back(line("friction on the sheared base, φ_{j}", normal, e.residual_low, kBlack, kDashes[2]));
  chart.layers.emplace_back(render::PointLayer{
      "simulated peak, one point a mesh", runs.normal, runs.peak, {render::MarkerShape::disc, kInk, 9}, {}, {}, {}});
  const double highest = *std::max_element(runs.peak.begin(), runs.peak.end());
  chart.x_range = render::Range{0.0, most};
  chart.y_range = render::Range{0.0, 1.5 * highest};
  return {"Shear strength of the joint against normal stress", "", {chart}, 1};
}

}  // namespace

std::optional<fs::path> draw_joint_envelope(const CampaignConfig& campaign,
                                            const std::vector<CampaignOutcome>& outcomes, const fs::path& out) {
  if (campaign.runs.empty() || !is_one_joint(campaign)) return std::nullopt;
  const RunConfig& config = campaign.runs.front().config;
  const std::optional<ToothedJoint> joint = toothed_joint(config, joint_profile(config.joint));
  const Strengths runs = simulated(campaign, outcomes);
  if (!joint || runs.normal.empty()) return std::nullopt;
  std::error_code error;
  fs::create_directories(out / "plots", error);
  if (error) throw output_error(out / "plots", "cannot be created", error.value());
  const render::Drawing drawing = render::draw_figure(figure_of(*joint, runs));
  render::write_png(drawing, out / "plots" / "envelope.png");
  render::write_svg(drawing, out / "plots" / "envelope.svg");
  return out / "plots" / "envelope.png";
}

}  // namespace asperity::app
