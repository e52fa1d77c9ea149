#pragma once
#include <string>
#include <vector>

#include "app/report/joint_numbers.hpp"

/// Figures and names in sentences about a joint; plain text, minus signs true ones.
namespace asperity::app {

std::string decimals(double value, int count);
std::string mm(double value);       ///< "0.64 mm"
std::string mpa(double value);      ///< "1.90 MPa"
std::string degrees(double value);  ///< "17.8°"

/// "12 % less", "3 % more".
std::string percent_apart(double value, double reference);

/// "the tooth" of a single one, else "tooth 2 (30°)". `index` from 0.
std::string tooth_name(const JointNumbers& numbers, std::size_t index);

/// The text with a capital at its beginning.
std::string capital(std::string text);

/// "when tooth 2 (30°) bore its most, tooth 1 (15°) bore 12 % of its own": of all teeth but the first to fail, which
/// there must be.
std::string unequal_loads(const JointNumbers& numbers);

/// Whether two or more teeth failed together or one after the other, and what opened or closed the flatter ones'
/// flanks: one sentence or more an entry. `curves` is the run's curves.csv.
std::vector<std::string> teeth_story(const JointNumbers& numbers, const CsvData& curves);

}  // namespace asperity::app
