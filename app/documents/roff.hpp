#pragma once
#include <string>

/// Text for man(7). Lines stay below 80 bytes, as mandoc's lint wants them.
namespace asperity::app::roff {

/// The text with its blanks as they are and every dash, quote, backslash and accent printed as typed: for examples.
std::string literal(const std::string& text);

/// A paragraph's text, wrapped, with dashes of options printed as typed.
std::string prose(const std::string& text);

std::string bold(const std::string& text);
std::string italic(const std::string& text);

}  // namespace asperity::app::roff
