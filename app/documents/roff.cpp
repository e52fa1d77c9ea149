#include "app/documents/roff.hpp"

#include <map>
#include <sstream>

namespace asperity::app::roff {
namespace {

constexpr std::size_t kMostBytes = 79;

/// Characters that roff would take for something else.
std::string escaped(const std::string& text, bool dashes) {
  static const std::map<char, std::string> escapes{{'\\', "\\e"},  {'\'', "\\(aq"}, {'`', "\\(ga"},
                                                   {'^', "\\(ha"}, {'~', "\\(ti"},  {'"', "\\(dq"}};
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins_word = i == 0 || std::string(" (-").find(text[i - 1]) != std::string::npos;
    const auto escape = escapes.find(text[i]);
    if (text[i] == '-' && (dashes || begins_word)) {
      result += "\\-";
    } else {
      result += escape == escapes.end() ? std::string(1, text[i]) : escape->second;
    }
  }
  return result;
}

/// A line that begins with a dot would be a macro.
std::string guarded(const std::string& line) { return line.starts_with('.') ? "\\&" + line : line; }

}  // namespace

std::string literal(const std::string& text) { return guarded(escaped(text, true)); }

std::string prose(const std::string& text) {
  std::istringstream words(escaped(text, false));
  std::string word, line, result;
  while (words >> word) {
    if (!line.empty() && line.size() + 1 + word.size() > kMostBytes) {
      result += guarded(line) + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return result + guarded(line) + "\n";
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text, true) + "\\fR"; }

std::string italic(const std::string& text) { return "\\fI" + escaped(text, true) + "\\fR"; }

}  // namespace asperity::app::roff
