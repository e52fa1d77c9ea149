#pragma once
#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/config/run_config.hpp"
#include "core/output/csv.hpp"

namespace asperity::app {

/// What a test's curves stand over: a column of curves.csv, times a factor, under a label.
struct Abscissa {
  const char* column;
  double factor;
  const char* label;
};
Abscissa abscissa_of(ExperimentType type);
std::vector<double> abscissae(const CsvData& table, const Abscissa& abscissa);

/// The stress of a test's curve: column and label with unit.
const char* stress_column(ExperimentType type);
const char* stress_label(ExperimentType type);

/// A frame of a run and where it stands on the curve; `abscissa` in the unit of its label.
struct RunFrame {
  int number = 0;
  std::size_t row = 0;  ///< Of curves.csv: frames are taken at samples.
  double abscissa = 0, stress_mpa = 0;
};

/// The frames that fields.pvd lists, by their times; none where it is missing or the table is empty.
std::vector<RunFrame> run_frames(const std::filesystem::path& root, const CsvData& curves, ExperimentType type);

/// Five frames that tell a run's story: half way to the peak, the peak, where the largest fall behind it has ended,
/// half way from there to the end, and the end. The nearest frames, each once, in their order; all where there are no
/// more than five.
std::vector<RunFrame> telling_frames(const std::vector<RunFrame>& frames, const std::vector<double>& abscissae,
                                     const std::vector<double>& stresses);

}  // namespace asperity::app
