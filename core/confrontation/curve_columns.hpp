#pragma once
#include <span>
#include <string_view>

#include "core/config/run_config.hpp"
#include "core/confrontation/column_units.hpp"
#include "core/measurement/curve.hpp"

namespace asperity {

/// A column that a curve may have. Its name in a file is the base with a unit.
struct ColumnKind {
  std::string_view base;
  Quantity quantity;
  std::vector<double> Curve::*member;
  bool required;
  std::string_view what;
};

/// The columns of an experiment's curves beside `specimen`.
std::span<const ColumnKind> curve_columns(ExperimentType experiment);

}  // namespace asperity
