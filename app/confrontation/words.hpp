#pragma once
#include <string>
#include <string_view>
#include <vector>

/// What the numbers of a confrontation mean, in words of rock mechanics. Pure functions.
namespace asperity::app {

/// "peak_axial_stress_mpa": "peak axial stress"; the unit is told apart.
std::string feature_words(std::string_view name);

/// So many significant digits with a true minus sign and "×10⁻⁷", at least the whole number up to 99,999; "–" where it
/// is not finite.
std::string figures(double value, int digits = 3);

/// "1.33 ± 0.02": the error in two digits, the value to the same decimal; the value alone without one.
std::string figures_with_error(double value, double error);

/// "A", "A and B", "A, B and C".
std::string joined(const std::vector<std::string>& words);

/// Few words for a mechanism: its title in the library; its id where the library has none.
std::string mechanism_title(const std::string& id);

/// "platen friction (platen_friction)".
std::string mechanism_name(const std::string& id);

/// The mechanism's own parameters at an amplitude: "friction coefficient 0.17 ± 0.03"; empty where it has none that
/// follows the amplitude. `error` 0: none is told.
std::string parameter_words(const std::string& id, double amplitude, double error);

/// The same with the amplitude itself: "friction coefficient 0.17 ± 0.03 (0.85 ± 0.15 of the declared strong one)".
std::string amplitude_words(const std::string& id, double amplitude, double error);

constexpr double kKeepingLevel = 0.01;  ///< Share of draws below which a hypothesis is refuted.

/// What two shares of draws say of a hypothesis: fits no better, lies as far behind the best.
std::string hypothesis_words(double p_misfit, double p_excess);

/// "in 34 of 100 repetitions", "in fewer than 1 of 100 repetitions".
std::string repetitions(double p);

/// What a mechanism that calibration absorbs by so much, seen from an amplitude on, could hide.
std::string detection_words(const std::string& id, double detectable, double absorbed_share);

}  // namespace asperity::app
