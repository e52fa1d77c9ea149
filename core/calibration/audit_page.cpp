#include <fmt/format.h>

#include <cmath>

#include "core/calibration/paper_audit.hpp"

namespace asperity {
namespace {

const char* yes(bool value) { return value ? "yes" : "**no**"; }

std::string head(const PaperAudit& audit) {
  return fmt::format(
      "# A published calibration against its own data\n\n"
      "{}.\n\nMade by `asperity calibrate` from {} printed runs; every figure below is computed from them. Nothing was "
      "simulated.\n",
      audit.source, audit.runs);
}

std::string misprints(const AuditedEquation& equation) {
  std::string text;
  for (const AuditedTerm& term : equation.terms) {
    if (term.name == term.meant) continue;
    text += fmt::format(
        "\nMisprint in {}: {} stands twice, and {} is missing. Its fitted coefficient, {:.4f}, is what the second one "
        "prints ({}).\n",
        equation.label, term.name, term.meant, term.fitted, term.printed);
  }
  return text;
}

std::size_t agreeing(const AuditedEquation& equation) {
  std::size_t count = 0;
  for (const AuditedTerm& term : equation.terms) count += term.agrees;
  return count;
}

std::string equation_table(const AuditedEquation& equation) {
  std::string text = fmt::format(
      "\n### {}\n\n{} of {} printed coefficients are those of least squares to all printed digits; R² = {:.3f}.\n\n"
      "| term | printed | fitted | agrees |\n|---|---|---|---|\n",
      equation.label, agreeing(equation), equation.terms.size(), equation.r2);
  for (const AuditedTerm& term : equation.terms) {
    const std::string name = term.name == term.meant ? term.name : term.name + ", meant " + term.meant;
    text += fmt::format("| {} | {} | {:.4f} | {} |\n", name, term.printed, term.fitted, yes(term.agrees));
  }
  return text + misprints(equation);
}

std::string solution_section(const DataCalibration& calibration, const PaperAudit& audit) {
  std::string point;
  for (double v : calibration.published->coded) point += fmt::format("{}{}", point.empty() ? "" : ", ", v);
  std::string text = fmt::format(
      "\n## The published solution does not solve the published equations\n\nAt ({}) the equations give:\n\n"
      "| | claimed | as printed | misprints mended | refitted | off by |\n|---|---|---|---|---|---|\n",
      point);
  for (const AuditedEquation& e : audit.equations) {
    text += fmt::format("| {} | {} | {:.3g} | {:.3g} | {:.3g} | {:+.0f} % |\n", e.label, e.claimed,
                        e.at_solution_as_printed, e.at_solution_mended, e.at_solution_fitted,
                        100.0 * (e.at_solution_fitted / e.claimed - 1.0));
  }
  return text;
}

std::string reach_section(const PaperAudit& audit) {
  std::string text = fmt::format(
      "\n## What lies inside the design\n\nSmallest and largest value of the printed runs, and of the quadratics "
      "inside |x| ≤ {:.3f}:\n\n"
      "| | target | runs | printed, misprints mended | refitted | target inside |\n|---|---|---|---|---|---|\n",
      audit.alpha);
  for (const AuditedEquation& e : audit.equations) {
    text += fmt::format("| {} | {} | {:.2f} to {:.2f} | {:.2f} to {:.2f} | {:.2f} to {:.2f} | {} |\n", e.label,
                        e.claimed, e.smallest_run, e.largest_run, e.smallest_printed, e.largest_printed,
                        e.smallest_inside, e.largest_inside, yes(e.target_inside));
  }
  return text;
}

std::string compromise_section(const DataCalibration& calibration, const PaperAudit& audit) {
  std::string text = fmt::format(
      "\nSolutions of all targets together inside the design: {} by the reduced models, {} by the full quadratics. "
      "The nearest that the reduced models come (desirability {:.2f}):\n\n",
      audit.solved ? "found" : "none", audit.solved_in_full ? "found" : "none", audit.compromise.point.desirability);
  text += "| | target | there | sd of a run |\n|---|---|---|---|\n";
  for (std::size_t r = 0; r < calibration.targets.size(); ++r) {
    const Prediction& predicted = audit.compromise.predicted[r];
    text += fmt::format("| {} | {} | {:.3g} | {:.2g} |\n", calibration.targets[r].property,
                        calibration.targets[r].value, predicted.value, predicted.sd_run);
  }
  return text;
}

std::string coding_section(const PaperAudit& audit) {
  std::string text =
      "\n## Two codings\n\nCentre and step of each factor as the coding states them, and as the runs' table itself has "
      "them (least squares of its real values on its coded ones):\n\n"
      "| factor | stated | in the table | published solution | decoded as stated | agrees | decoded by the table |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const AuditedFactor& f : audit.factors) {
    text += fmt::format("| {} {} ({}) | {} ± {} | {:.2f} ± {:.2f} | {} | {:.3f} | {} | {:.2f} |\n", f.stated.name,
                        f.stated.symbol, f.stated.unit, f.stated.centre, f.stated.step, f.tabled_centre, f.tabled_step,
                        f.printed, f.solution, yes(f.solution_agrees), f.solution_by_table);
  }
  return text;
}

std::string alpha_section(const PaperAudit& audit) {
  const double rotatable = star_distance(audit.factors.size(), StarDistance::rotatable);
  return fmt::format(
      "\n## The star points\n\nThe stars of the table stand at {:.3f}. The text calls that the sphere through the "
      "cube's corners, whose radius is √{} = {:.3f}; {:.3f} is the rotatable distance, (2^{})^(1/4). The corners "
      "themselves lie outside |x| ≤ {:.3f}.\n",
      audit.alpha, audit.factors.size(), audit.corner, rotatable, audit.factors.size(), audit.alpha);
}

std::string scatter_section(const PaperAudit& audit) {
  std::string text = fmt::format(
      "\n## Scatter\n\nRelative standard deviation over the {} centre points (one parameter set, {} meshes), and the "
      "one "
      "published for the calibrated set:\n\n| | centre points | published |\n|---|---|---|\n",
      audit.centre_points, audit.centre_points);
  for (const AuditedEquation& e : audit.equations) {
    text += fmt::format("| {} | {:.1f} % | {} |\n", e.label, 100.0 * e.centre_scatter,
                        e.claimed_scatter ? fmt::format("{:.1f} %", 100.0 * *e.claimed_scatter) : "-");
  }
  return text;
}

}  // namespace

std::string audit_page(const DataCalibration& calibration, const PaperAudit& audit) {
  std::string page = head(audit) + "\n## The equations\n";
  for (const AuditedEquation& equation : audit.equations) page += equation_table(equation);
  page += solution_section(calibration, audit) + reach_section(audit) + compromise_section(calibration, audit);
  return page + coding_section(audit) + alpha_section(audit) + scatter_section(audit);
}

}  // namespace asperity
