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
  Analysis analysis =
      analyse(calibration.design, calibration.responses, calibration.targets, calibration.options);
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
  INFO("written to " << folder / "audit.md" << "; look at it before you copy it to docs/paper_audit.md");
  CHECK(read_file(folder / "audit.md") == read_file(std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/paper_audit.md"));
}

TEST_CASE("least squares on Table 4 returns Eqs 17 to 19, and tells the misprint") {
  for (const AuditedEquation& equation : audited().audit.equations) {
    for (const AuditedTerm& term : equation.terms) {
      INFO(equation.label << " " << term.name << " printed " << term.printed << " fitted " << term.fitted);
      CHECK(term.agrees);
    }
  }
  const std::vector<AuditedTerm>& terms = audited().audit.equations.at(0).terms;
  CHECK(terms.at(5).name == "x1x3");
  CHECK(terms.at(5).meant == "x1x3");
  CHECK(terms.at(6).name == "x1x3");
  CHECK(terms.at(6).meant == "x2x3");
}

TEST_CASE("the published solution does not solve the published equations") {
  // The figures of an independent computation, to the digits it gave.
  const std::vector<AuditedEquation>& e = audited().audit.equations;
  CHECK(e.at(0).at_solution_fitted == Approx(1.02).margin(0.005));
  CHECK(e.at(1).at_solution_fitted == Approx(1.93).margin(0.005));
  CHECK(e.at(2).at_solution_fitted == Approx(61.4).margin(0.05));
  CHECK(e.at(0).at_solution_mended == Approx(e.at(0).at_solution_fitted).margin(0.02));  // ten roundings of 0.005
}
