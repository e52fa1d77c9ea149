#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/output/csv.hpp"

namespace asperity {

struct Sample;
struct Crack;
struct AcousticEvent;

/// Which curves a test has: of a joint with so many teeth, or of a specimen between platens.
struct CurveLayout {
  bool joint = false;
  std::size_t teeth = 0;
};

/// Columns and rows of a run's tables, in one order; outputs/README.md says what each column is.
std::vector<std::string> curve_columns(const CurveLayout& layout = {});
std::vector<std::string> energy_columns(const CurveLayout& layout = {});
std::vector<std::string> crack_columns();
std::vector<std::string> event_columns();
std::vector<std::string> fragment_columns();

std::vector<CsvCell> curve_row(const Sample& sample, const CurveLayout& layout = {});
std::vector<CsvCell> energy_row(const Sample& sample, const CurveLayout& layout = {});
std::vector<CsvCell> crack_row(const Crack& crack);
std::vector<CsvCell> event_row(const AcousticEvent& event);
std::vector<CsvCell> fragment_row(std::size_t number, double area_mm2);

}  // namespace asperity
