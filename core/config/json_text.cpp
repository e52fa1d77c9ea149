#include "core/config/json_text.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include "core/config/schema_lookup.hpp"

namespace asperity {

using nlohmann::json;

namespace {

constexpr std::size_t kDeepest = 64;        // later steps recurse over the levels
constexpr std::size_t kLongestArray = 256;  // later steps compare all pairs of values
constexpr std::size_t kMostTooLarge = 100;  // each of these numbers takes a pass over the text

/// An object or array that is being read.
struct Level {
  bool is_array;
  std::size_t index = 0;
  std::string key;
  std::set<std::string> seen;
};

/// A number literal beyond the range of double, and where it stands.
struct TooLarge {
  std::string pointer, literal;
  std::size_t end;
};

/// Reads a text once and notes duplicate keys and the first thing that stops the parser. nlohmann's own tree keeps the
/// last of duplicate keys silently and names no place for a number that is too large.
class Scanner : public nlohmann::json_sax<json> {
 public:
  bool null() override { return next(); }
  bool boolean(bool) override { return next(); }
  bool number_integer(number_integer_t) override { return next(); }
  bool number_unsigned(number_unsigned_t) override { return next(); }
  bool number_float(number_float_t, const string_t&) override { return next(); }
  bool string(string_t&) override { return next(); }
  bool binary(binary_t&) override { return next(); }
  bool start_object(std::size_t) override { return enter(false); }
  bool start_array(std::size_t) override { return enter(true); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool key(string_t& name) override;
  bool parse_error(std::size_t end, const std::string& token, const json::exception& error) override;

  std::vector<Fault> duplicates;
  std::vector<TooLarge> too_large;   ///< At most one: the parser stops there.
  bool too_deep = false;             ///< The parser stopped at brackets nested beyond any sense.
  std::string too_long;              ///< The value at which an array had too many; empty if none has.
  std::size_t syntax_error_end = 0;  ///< Bytes read when the syntax error was seen.
  std::string syntax_error;          ///< Empty if there is none.

 private:
  bool next();
  bool enter(bool is_array);
  bool leave();
  std::string pointer() const;
  std::vector<Level> levels_;
};

bool Scanner::next() {
  if (levels_.empty() || !levels_.back().is_array) return true;
  if (levels_.back().index == kLongestArray) too_long = pointer();
  ++levels_.back().index;
  return too_long.empty();
}

bool Scanner::enter(bool is_array) {
  too_deep = levels_.size() == kDeepest;
  if (too_deep) return false;
  levels_.push_back({is_array, 0, {}, {}});
  return true;
}

bool Scanner::leave() {
  levels_.pop_back();
  return next();
}

bool Scanner::key(string_t& name) {
  levels_.back().key = name;
  if (!levels_.back().seen.insert(name).second)
    duplicates.push_back({pointer(), "is given twice", "", "", "keep one of the two; JSON has no order between them"});
  return true;
}

std::string Scanner::pointer() const {
  std::string path;
  for (const Level& level : levels_)
    path = child_pointer(path, level.is_array ? std::to_string(level.index) : level.key);
  return path;
}

bool Scanner::parse_error(std::size_t end, const std::string& token, const json::exception& error) {
  constexpr int kNumberOverflow = 406;
  if (error.id == kNumberOverflow) {
    too_large.push_back({pointer(), token, end});
    return false;
  }
  syntax_error_end = end;
  syntax_error = error.what();
  return false;
}

/// "origin:line:column" of a byte of the text, counted from 1.
std::string place(const std::string& text, const std::string& origin, std::size_t byte) {
  const std::string_view before = std::string_view(text).substr(0, std::min(byte, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;
  return origin + ":" + std::to_string(line) + ":" + std::to_string(column);
}

/// nlohmann's message without its number and position: "syntax error while parsing object - unexpected ...".
std::string parser_message(const std::string& message) {
  const std::size_t start = message.find("syntax error");
  return start == std::string::npos ? message : message.substr(start);
}

Fault syntax_fault(const Scanner& scanner, const std::string& text, const std::string& origin) {
  if (scanner.too_deep) return {origin, "has brackets nested too deeply", "", "up to 64 levels", ""};
  if (!scanner.too_long.empty())
    return {scanner.too_long, "is one value too many for an array", "", "up to 256 values", ""};
  const std::size_t byte = scanner.syntax_error_end == 0 ? 0 : scanner.syntax_error_end - 1;
  return {place(text, origin, byte), "is not JSON: " + parser_message(scanner.syntax_error), "", "",
          "JSON has no comments and no comma before a closing bracket; keys stand in double quotes"};
}

Fault too_large_fault(const TooLarge& number) {
  return {number.pointer, "is too large for a number", number.literal, "magnitudes up to 1.7e308",
          "write a finite number"};
}

/// Overwrites the literal by 0 so that the rest of the text can be checked.
void blank_out(std::string& text, const TooLarge& number) {
  const std::size_t length = number.literal.size();
  text.replace(number.end - length, length, "0" + std::string(length - 1, ' '));
}

}  // namespace

ParsedText parse_json(std::string text, const std::string& origin) {
  std::vector<Fault> faults;
  while (true) {
    Scanner scanner;
    const bool done = json::sax_parse(text, &scanner);
    if (!done && !scanner.too_large.empty()) {
      faults.push_back(too_large_fault(scanner.too_large.front()));
      if (faults.size() == kMostTooLarge) return {nullptr, std::move(faults), false};
      blank_out(text, scanner.too_large.front());
      continue;
    }
    faults.insert(faults.end(), scanner.duplicates.begin(), scanner.duplicates.end());
    if (done) return {json::parse(text), std::move(faults), true};
    faults.push_back(syntax_fault(scanner, text, origin));
    return {nullptr, std::move(faults), false};
  }
}

}  // namespace asperity
