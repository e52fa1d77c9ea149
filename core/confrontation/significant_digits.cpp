#include "core/confrontation/significant_digits.hpp"

#include <charconv>

namespace asperity {

std::string digits_text(double value, int digits) {
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr;
  return {buffer, end};
}

double rounded_to(double value, int digits) {
  const std::string text = digits_text(value, digits);
  double result = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

}  // namespace asperity
