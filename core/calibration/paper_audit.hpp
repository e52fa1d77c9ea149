#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/data_calibration.hpp"

/// A published calibration held against its own data.
namespace asperity {

/// Whether the text is a number with nothing behind it.
bool is_printed_number(const std::string& text);

/// One coefficient, printed and fitted.
struct AuditedTerm {
  std::string name;   ///< As printed.
  std::string meant;  ///< What it must be: other than `name` where a term is printed twice and the fit tells which
                      ///< missing one has this coefficient.
  std::string printed;
  double fitted = 0;    ///< Coefficient of `meant`.
  bool agrees = false;  ///< The fitted coefficient rounds to the printed digits.
};

struct AuditedEquation {
  std::string property, label;
  std::vector<AuditedTerm> terms;
  double r2 = 0;
  double at_solution_as_printed = 0;  ///< The equation as printed, misprints included, at the published solution.
  double at_solution_mended = 0;      ///< With the misprints mended.
  double at_solution_fitted = 0;      ///< With the fitted coefficients.
  double claimed = 0;                 ///< The target that the solution is said to reach.
  double smallest_run = 0, largest_run = 0;          ///< Of the table.
  double smallest_inside = 0, largest_inside = 0;    ///< Of the fitted full quadratic inside |x| <= alpha.
  double smallest_printed = 0, largest_printed = 0;  ///< Of the printed one, misprints mended, there.
  bool target_inside = false;                        ///< The claimed value lies between those.
  double centre_scatter = 0;                         ///< Relative standard deviation over the centre points.
  std::optional<double> claimed_scatter;
};

/// One factor's coding, as the config says and as the table's own columns say.
struct AuditedFactor {
  Factor stated;
  double tabled_centre = 0, tabled_step = 0;  ///< Least squares of the table's real values on its coded ones.
  double solution = 0;                        ///< The published solution decoded with the stated coding.
  std::string printed;                        ///< As printed.
  bool solution_agrees = false;
  double solution_by_table = 0;  ///< The same decoded with the table's coding.
};

struct PaperAudit {
  std::string source;
  double alpha = 0;
  double corner = 0;  ///< Coded distance of the corners, the circumscribed sphere's radius.
  std::size_t runs = 0, centre_points = 0;
  std::vector<AuditedEquation> equations;
  std::vector<AuditedFactor> factors;
  bool solved = false;          ///< The reduced models have a solution inside the design.
  bool solved_in_full = false;  ///< The full quadratics have one.
  Solution compromise;          ///< Best point of the design, by the reduced models.
};

/// The audit of a calibration that has something published; `analysis` is its own. Throws Error(config) where an
/// equation is of no response or no target of the calibration.
PaperAudit audit_paper(const DataCalibration& calibration, const Analysis& analysis);

/// The audit as a Markdown page.
std::string audit_page(const DataCalibration& calibration, const PaperAudit& audit);

/// Smallest and largest value of a fit inside |x| <= alpha.
std::pair<double, double> extremes(const LinearFit& fit, double alpha);

}  // namespace asperity
