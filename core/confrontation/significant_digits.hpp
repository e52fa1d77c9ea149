#pragma once
#include <string>

namespace asperity {

/// A finite number to so many significant decimal digits (1 to 17), as text: "1.2345e-05"; the same bytes everywhere.
std::string digits_text(double value, int digits);

/// The number that this text stands for.
double rounded_to(double value, int digits);

}  // namespace asperity
