#include "core/calibration/paper_audit.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/calibration/data_procedure.hpp"
#include "tests/unit/calibration/examples.hpp"

using namespace asperity;

namespace {

struct Audited {
  DataCalibration calibration = read_data_calibration(examples::kTable4);
  Analysis analysis = analyse(calibration.design, calibration.responses, calibration.targets, calibration.options);
  PaperAudit audit = audit_paper(calibration, analysis);
};

const Audited& audited() {
  static const Audited all;
  return all;
}

}  // namespace

TEST_CASE("the audit page in docs is what the data calibration writes") {
  const std::filesystem::path folder = std::filesystem::path(ASPERITY_TEST_SCRATCH) / "paper_audit";
  std::filesystem::create_directories(folder);
  calibrate_data(examples::kTable4, folder);
  INFO("written to " << folder / "audit.md"
                     << "; look at it before you copy it to docs/paper_audit.md");
  CHECK(read_file(folder / "audit.md") ==
        read_file(std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/paper_audit.md"));
}

TEST_CASE("least squares on Table 4 returns Eqs 17 to 19, and tells the misprint") {
  for (const AuditedEquation& equation : audited().audit.equations) {
    for (const AuditedTerm& term : equation.terms) {
      INFO(equation.label << " " << term.name << " printed " << term.printed << " fitted " << term.fitted);
      const bool rounded_up = equation.property == "cohesion_mpa" && term.name == "1";
      CHECK(term.agrees == !rounded_up);
      CHECK(term.fitted == Approx(std::stod(term.printed)).margin(rounded_up ? 0.006 : 0.0051));
    }
  }
  // The one that does not: 1.7946 is printed as 1.80.
  CHECK(audited().audit.equations.at(1).terms.at(0).fitted == Approx(1.7946).margin(0.0001));
  const std::vector<AuditedTerm>& terms = audited().audit.equations.at(0).terms;
  CHECK(terms.at(5).name == "x1x3");
  CHECK(terms.at(5).meant == "x1x3");
  CHECK(terms.at(6).name == "x1x3");
  CHECK(terms.at(6).meant == "x2x3");
}

TEST_CASE("the published solution does not solve the published equations") {
  // The figures of an independent computation, to the digits it gave.
  const std::vector<AuditedEquation>& e = audited().audit.equations;
  CHECK(e.at(0).at_solution_mended == Approx(1.02).margin(0.005));
  CHECK(e.at(1).at_solution_mended == Approx(1.93).margin(0.005));
  CHECK(e.at(2).at_solution_mended == Approx(61.4).margin(0.05));
  for (const AuditedEquation& equation : e) {
    // Ten coefficients, each rounded by up to 0.005, times monomials of at most 0.871.
    CHECK(equation.at_solution_fitted == Approx(equation.at_solution_mended).margin(0.03));
  }
  CHECK(e.at(0).at_solution_as_printed != e.at(0).at_solution_mended);
}

TEST_CASE("the target of the tensile strength lies outside the design") {
  const AuditedEquation& e = audited().audit.equations.at(0);
  CHECK(e.largest_run == 1.14);
  CHECK(e.largest_printed == Approx(1.26).margin(0.005));
  CHECK(e.largest_inside < 1.3);
  CHECK_FALSE(e.target_inside);
  CHECK(audited().audit.equations.at(1).target_inside);
  CHECK_FALSE(audited().audit.solved);
  CHECK_FALSE(audited().audit.solved_in_full);
  CHECK(audited().analysis.move.has_value());
}

TEST_CASE("codings, decoded solution and scatter of the centre points") {
  const PaperAudit& audit = audited().audit;
  const double centre[3] = {5, 20, 20}, step[3] = {2.5, 10, 10}, solution[3] = {6.89, 5.02, 36.50};
  for (std::size_t j = 0; j < 3; ++j) {
    CHECK(audit.factors.at(j).tabled_centre ==
          Approx(centre[j]).margin(0.01));  // printed to 0.1, eight and more values
    CHECK(audit.factors.at(j).tabled_step == Approx(step[j]).margin(0.01));
    CHECK(audit.factors.at(j).solution == Approx(solution[j]).margin(0.005));
    CHECK(audit.factors.at(j).solution_agrees);
  }
  CHECK(100 * audit.equations.at(0).centre_scatter == Approx(12.6).margin(0.05));
  CHECK(100 * audit.equations.at(1).centre_scatter == Approx(11.7).margin(0.05));
  CHECK(100 * audit.equations.at(0).claimed_scatter.value() == Approx(2.5));
}

TEST_CASE("extremes of a quadratic in the sphere, by hand") {
  LinearFit fit;
  fit.terms = {{}, {0, -1}, {1, -1}, {1, 1}};
  fit.coefficients = {1.0, 3.0, 4.0, 0.0};
  CHECK(extremes(fit, 2.0).second == Approx(11.0));  // 1 + 2 * 5
  CHECK(extremes(fit, 2.0).first == Approx(-9.0));
  fit.coefficients = {1.0, 0.0, 2.0, -1.0};  // 1 + 2 y - y^2: largest 2 at y = 1, smallest at y = -2: -7
  CHECK(extremes(fit, 2.0).second == Approx(2.0));
  CHECK(extremes(fit, 2.0).first == Approx(-7.0));
}

TEST_CASE("what is published of no target is an error") {
  DataCalibration other = audited().calibration;
  other.published->equations[0].property = "youngs_modulus_gpa";
  CHECK_THROWS_WITH(audit_paper(other, audited().analysis),
                    Catch::Contains("/published/equations/youngs_modulus_gpa: is of no target"));
}
