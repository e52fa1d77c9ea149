#include "core/output/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::html {
namespace {

Markup element(std::string_view name, const Markup& inside) {
  return Markup::from_html(fmt::format("<{0}>{1}</{0}>", name, inside.html()));
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Bytes of the UTF-8 character that begins here.
std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  const std::size_t length = byte < 0x80 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
  return std::min(length, text.size() - at);
}

/// The index or exponent after a mark: what the braces hold, or one character. `at` moves behind it.
std::string_view take_group(std::string_view text, std::size_t& at) {
  const std::size_t start = at;
  const std::size_t close = text[at] == '{' ? text.find('}', at) : std::string_view::npos;
  if (close == std::string_view::npos) {
    at += character_length(text, at);
    return text.substr(start, at - start);
  }
  at = close + 1;
  return text.substr(start + 1, close - start - 1);
}

enum class Letters { upright, italic };

/// A run of letters: one alone is a variable and italic, longer ones are words or functions.
void append_letters(std::string_view text, std::size_t& at, Letters letters, std::string& out) {
  const std::size_t start = at;
  while (at < text.size() && is_letter(text[at])) ++at;
  const std::string_view word = text.substr(start, at - start);
  out += word.size() == 1 && letters == Letters::italic ? fmt::format("<i>{}</i>", word) : std::string(word);
}

/// Whether an index or exponent follows: in a formula any, in other text only "_{".
bool is_mark(std::string_view text, std::size_t at, Letters letters) {
  if (at + 1 >= text.size()) return false;
  if (letters == Letters::upright) return text.substr(at, 2) == "_{";
  return text[at] == '_' || text[at] == '^';
}

std::string set_formula(std::string_view text, Letters letters) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (is_mark(text, at, letters)) {
      const std::string_view tag = c == '_' ? "sub" : "sup";
      out += fmt::format("<{0}>{1}</{0}>", tag, set_formula(take_group(text, ++at), letters));
    } else if (is_letter(c)) {
      append_letters(text, at, letters, out);
    } else {
      const std::size_t length = character_length(text, at);
      out += escaped(text.substr(at, length));
      at += length;
    }
  }
  return out;
}

/// A C number as one reads it: true minus sign, "×10" with a raised exponent.
std::string typeset(std::string digits) {
  std::string power;
  if (const std::size_t e = digits.find('e'); e != std::string::npos) {
    const int exponent = std::stoi(digits.substr(e + 1));
    power = fmt::format("×10<sup>{}{}</sup>", exponent < 0 ? "−" : "", std::abs(exponent));
    digits.resize(e);
  }
  return (digits.front() == '-' ? "−" + digits.substr(1) : digits) + power;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7F)
          out += "\xEF\xBF\xBD";
        else
          out += c;
    }
  return out;
}

Markup::Markup(std::string_view text) : html_(escaped(text)) {}

Markup Markup::from_html(std::string html) {
  Markup markup;
  markup.html_ = std::move(html);
  return markup;
}

Markup& Markup::operator+=(const Markup& other) {
  html_ += other.html_;
  return *this;
}

Markup operator+(Markup a, const Markup& b) { return a += b; }

Markup number(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  if (value == 0) return "0";
  const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);  // rounds before the exponent is read off
  const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
  constexpr int kSmallest = -4, kLargest = 6;  // beyond them a power of ten is easier to read than zeros
  if (exponent < kSmallest || exponent >= kLargest) return Markup::from_html(typeset(scientific));
  return fixed(value, std::max(0, digits - 1 - exponent));
}

Markup fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return Markup::from_html(typeset(zero && text.front() == '-' ? text.substr(1) : text));
}

Markup as_given(double value) {
  return std::isfinite(value) ? Markup::from_html(typeset(fmt::format("{:.6g}", value))) : Markup("–");
}

Markup with_scatter(double mean, double sd) {
  if (!std::isfinite(mean) || !std::isfinite(sd) || sd <= 0) return number(mean);
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(sd))), 0, 9);
  return fixed(mean, decimals) + " ± " + fixed(sd, decimals);
}

Markup formula(std::string_view text) {
  return Markup::from_html("<span class=\"formula\">" + set_formula(text, Letters::italic) + "</span>");
}

Markup with_indices(std::string_view text) { return Markup::from_html(set_formula(text, Letters::upright)); }

Markup paragraph(const Markup& text) { return element("p", text); }
Markup strong(const Markup& text) { return element("strong", text); }
Markup code(const Markup& text) { return element("code", text); }

Markup lines(const std::vector<Markup>& all) {
  Markup text;
  for (std::size_t i = 0; i < all.size(); ++i) text += (i ? Markup::from_html("<br>") : Markup()) + all[i];
  return text;
}

Markup bullet_list(const std::vector<Markup>& items) {
  Markup inside;
  for (const Markup& item : items) inside += element("li", item);
  return element("ul", inside);
}

Markup link(const std::filesystem::path& target, const Markup& text) {
  return Markup::from_html(fmt::format("<a href=\"{}\">{}</a>", linked_source(target), text.html()));
}

Markup notice(NoticeKind kind, const Markup& text) {
  const bool warns = kind == NoticeKind::warning;
  return Markup::from_html(fmt::format("<div class=\"notice {}\" role=\"note\"><strong>{}</strong> {}</div>",
                                       warns ? "warning" : "information", warns ? "Warning." : "Note.", text.html()));
}

Markup definition_list(const std::vector<Definition>& entries) {
  Markup inside;
  for (const Definition& entry : entries) inside += element("dt", entry.term) + element("dd", entry.meaning);
  return element("dl", inside);
}

}  // namespace asperity::html
