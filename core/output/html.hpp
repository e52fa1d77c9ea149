#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Parts of report pages as pure functions: text in, HTML out. A page needs no network and no file but the pictures it
/// links, and can be read without a script; it prints well and follows the reader's light or dark mode.
namespace asperity::html {

/// A piece of a page. Text becomes one by being escaped, so that none gets in unescaped by oversight.
class Markup {
 public:
  Markup() = default;
  Markup(std::string_view text);  // NOLINT(google-explicit-constructor): cells, parts.
  Markup(const std::string& text) : Markup(std::string_view(text)) {}  // NOLINT(google-explicit-constructor)
  Markup(const char* text) : Markup(std::string_view(text)) {}         // NOLINT(google-explicit-constructor)
  /// Takes HTML as it stands. For this folder's functions; others put elements together.
  static Markup from_html(std::string html);
  const std::string& html() const { return html_; }
  bool empty() const { return html_.empty(); }
  Markup& operator+=(const Markup& other);

 private:
  std::string html_;
};

Markup operator+(Markup a, const Markup& b);

/// The text with & < > " ' as entities; control characters that HTML forbids become U+FFFD.
std::string escaped(std::string_view text);

/// A number in so many significant digits: "−0.0123", "1.30", "6.2×10⁻⁷" with a raised exponent, "–" if it is not
/// finite.
Markup number(double value, int digits = 4);

/// A number with so many decimals, its minus sign a true one; "–" if it is not finite.
Markup fixed(double value, int decimals);

/// A number somebody gave, without zeros it does not need: "1.6", "40".
Markup as_given(double value);

/// "1.327 ± 0.022": the standard deviation in two digits, the mean to the same decimal; the mean alone without one.
Markup with_scatter(double mean, double sd);

/// A formula in plain text: "_x" or "_{xy}" is lowered, "^x" or "^{xy}" raised, and single Latin letters are italic.
/// "D = (d_1 d_2)^{1/2}".
Markup formula(std::string_view text);

/// A symbol or label in which "_{...}" is lowered, all else as it stands.
Markup with_indices(std::string_view text);

Markup paragraph(const Markup& text);
Markup strong(const Markup& text);
Markup code(const Markup& text);
/// One under another in the same cell or paragraph.
Markup lines(const std::vector<Markup>& all);

Markup bullet_list(const std::vector<Markup>& items);

/// A link to a file beside the page, by its path relative to it.
Markup link(const std::filesystem::path& target, const Markup& text);

enum class NoticeKind { information, warning };
Markup notice(NoticeKind kind, const Markup& text);

struct Definition {
  Markup term;
  Markup meaning;
};
Markup definition_list(const std::vector<Definition>& entries);

/// `head` cells name their row; `prose` cells hold sentences and get room for them.
enum class ColumnKind { head, text, prose, number };

struct Column {
  Markup heading;
  Markup unit = {};  ///< Shown under the heading; empty: none.
  ColumnKind kind = ColumnKind::number;
};

/// How a row stands out, by colour and by a bar at its left; its cells must say why.
enum class RowTone { plain, good, bad, quiet };

struct Row {
  std::vector<Markup> cells;  ///< One a column; missing ones are empty.
  RowTone tone = RowTone::plain;
};

struct Table {
  Markup caption;
  std::vector<Column> columns;
  std::vector<Row> rows;
};
Markup table(const Table& table);

/// A picture and what a reader who does not see it should know. `source` comes from linked_source or embedded_source.
struct Picture {
  std::string source;
  std::string alternative_text;
};

/// The address of a file beside the page, by its path relative to it: percent-encoded where an address needs it.
std::string linked_source(const std::filesystem::path& path);

/// The picture's bytes as an address of its own ("data:image/png;base64,..."), for pages that are one file.
std::string embedded_source(std::string_view bytes, std::string_view media_type);

struct FileLink {
  std::filesystem::path target;
  std::string text;
};

struct Figure {
  std::vector<Picture> pictures;  ///< Several stand side by side where there is room.
  Markup caption;
  std::vector<FileLink> links;  ///< Behind the caption: other formats, data.
};
Markup figure(const Figure& figure);

/// A heading with what stands under it; levels follow from the nesting.
struct Section {
  std::string title;
  std::vector<Markup> parts;
  std::vector<Section> sections;
};

struct Page {
  std::string title;
  Markup subtitle;
  std::vector<Markup> lead;  ///< Before the contents: what a reader must not miss.
  std::vector<Section> sections;
  Markup foot;
  std::string_view script = {};  ///< Put into the page; what it does must be more than the page needs. Empty: none.
};

/// The page as a whole HTML document with a list of its sections.
std::string document(const Page& page);

/// The style sheet every page carries.
std::string_view style_sheet();

}  // namespace asperity::html
