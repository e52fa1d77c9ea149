#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/output/html.hpp"

namespace asperity::html {
namespace {

constexpr int kDeepest = 6;  // HTML has no heading below h6

/// Names of sections as link targets, each once.
class Anchors {
 public:
  std::string of(const std::string& title) {
    std::string name;
    for (const char c : title) {
      const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
      const bool capital = c >= 'A' && c <= 'Z';
      if (letter || capital)
        name += capital ? static_cast<char>(c - 'A' + 'a') : c;
      else if (!name.empty() && name.back() != '-')
        name += '-';
    }
    while (name.ends_with('-')) name.pop_back();
    const int times = ++times_[name];
    return times == 1 && !name.empty() ? name : fmt::format("{}-{}", name.empty() ? "section" : name, times);
  }

 private:
  std::map<std::string, int> times_;
};

std::string section_html(const Section& section, int level, Anchors& anchors, std::string& contents) {
  const std::string anchor = anchors.of(section.title), title = escaped(section.title);
  const int heading = std::min(level, kDeepest);
  if (level == 2) contents += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", anchor, title);
  std::string out = fmt::format("<section id=\"{0}\">\n<h{1}>{2}</h{1}>\n", anchor, heading, title);
  for (const Markup& part : section.parts) out += part.html() + "\n";
  for (const Section& inner : section.sections) out += section_html(inner, level + 1, anchors, contents);
  return out + "</section>\n";
}

std::string head_html(const Page& page) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n<style>\n{}</style>\n</head>\n",
      escaped(page.title), style_sheet());
}

/// One section needs no list of its sections.
std::string contents_html(const Page& page, const std::string& items) {
  return page.sections.size() < 2 ? "" : "<nav aria-label=\"Contents\">\n<ol>\n" + items + "</ol>\n</nav>\n";
}

std::string script_html(std::string_view script) {
  return script.empty() ? "" : fmt::format("<script>\n{}</script>\n", script);
}

}  // namespace

std::string document(const Page& page) {
  Anchors anchors;
  std::string contents, body, lead;
  for (const Section& section : page.sections) body += section_html(section, 2, anchors, contents);
  for (const Markup& part : page.lead) lead += part.html() + "\n";
  return head_html(page) +
         fmt::format("<body>\n<header>\n<h1>{}</h1>\n<p class=\"subtitle\">{}</p>\n</header>\n", escaped(page.title),
                     page.subtitle.html()) +
         lead + contents_html(page, contents) + "<main>\n" + body +
         "</main>\n<footer>" + page.foot.html() + "</footer>\n" + script_html(page.script) + "</body>\n</html>\n";
}

std::string_view style_sheet() {
  // Colours: text at least 7:1 on its background in both modes. Pictures are drawn on white and stay on white.
  return R"css(:root {
  --paper: #ffffff; --ink: #1a1a1a; --soft: #4a4a4a; --line: #c9ced3; --stripe: #f4f6f8; --link: #00507d;
  --good: #0b6b4a; --good-fill: #e3f4ec; --bad: #a03c00; --bad-fill: #fdeadf; --note: #00507d; --note-fill: #e6f1f8;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #15181b; --ink: #ebedef; --soft: #bcc2c8; --line: #444b52; --stripe: #1e2327; --link: #8cc8f0;
    --good: #6fd3aa; --good-fill: #14302a; --bad: #ffb083; --bad-fill: #3a2316; --note: #8cc8f0; --note-fill: #15293a;
  }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 74rem; background: var(--paper); color: var(--ink);
  font: 1rem/1.55 "Source Sans 3", "Segoe UI", "Helvetica Neue", Arial, "DejaVu Sans", sans-serif;
  overflow-wrap: break-word; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.45rem; margin: 3rem 0 .8rem; padding-bottom: .25rem; border-bottom: 2px solid var(--line); }
h3 { font-size: 1.15rem; margin: 2.2rem 0 .6rem; }
h4, h5, h6 { font-size: 1rem; margin: 1.6rem 0 .4rem; }
p, ul, dl { max-width: 48rem; }
a { color: var(--link); }
code { font-family: "DejaVu Sans Mono", Consolas, monospace; font-size: .9em; overflow-wrap: anywhere; }
sub, sup { font-size: .75em; line-height: 0; }
.subtitle { color: var(--soft); margin: 0 0 1.5rem; max-width: none; }
.formula { white-space: nowrap; }
nav ol { columns: 18rem; margin: 1.5rem 0; padding: 1rem 1rem 1rem 2.6rem; background: var(--stripe); border-radius: .4rem; }
nav li { break-inside: avoid; }
.notice { margin: .8rem 0; padding: .6rem 1rem; border-left: .35rem solid; border-radius: .2rem; max-width: 62rem; }
.notice.warning { border-color: var(--bad); background: var(--bad-fill); }
.notice.warning > strong { color: var(--bad); }
.notice.information { border-color: var(--note); background: var(--note-fill); }
.notice.information > strong { color: var(--note); }
.wide { overflow-x: auto; margin: 1.2rem 0; }
table { border-collapse: collapse; font-size: .95rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--soft); padding: 0 0 .5rem; max-width: 62rem; }
th, td { padding: .3rem .75rem; text-align: left; vertical-align: baseline; }
th { font-weight: 600; }
thead th { border-top: 2px solid var(--ink); border-bottom: 1px solid var(--ink); vertical-align: bottom; line-height: 1.3; }
tbody tr:last-child > * { border-bottom: 2px solid var(--ink); }
tbody tr:nth-child(even) { background: var(--stripe); }
tbody th { font-weight: 500; }
td:not(.number) { min-width: 5rem; }
td.prose { min-width: 22rem; }
.number { text-align: right; white-space: nowrap; }
.unit { font-weight: 400; color: var(--soft); }
tr.good > :first-child { box-shadow: inset .3rem 0 var(--good); }
tr.bad > :first-child { box-shadow: inset .3rem 0 var(--bad); }
tr.bad, tbody tr.bad:nth-child(even) { background: var(--bad-fill); }
tr.quiet { color: var(--soft); }
figure { margin: 1.5rem 0; break-inside: avoid; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; }
.pictures > * { flex: 1 1 22rem; min-width: 0; }
img { display: block; max-width: 100%; height: auto; margin: 0 auto; background: #ffffff; border: 1px solid var(--line);
  border-radius: .3rem; }
figcaption { color: var(--soft); margin-top: .5rem; max-width: 62rem; }
[hidden] { display: none !important; }
.controls { padding: .7rem 1rem .8rem; background: var(--stripe); border-radius: .4rem; }
fieldset { border: 0; margin: 0 0 .5rem; padding: 0; }
legend { float: left; margin-right: 1rem; font-weight: 600; }
fieldset label { margin-right: 1rem; white-space: nowrap; }
.slider { display: flex; gap: .6rem; align-items: center; }
.slider input { flex: 1; min-width: 6rem; accent-color: var(--link); }
button { font: inherit; color: var(--ink); background: var(--paper); border: 1px solid var(--soft); border-radius: .3rem;
  padding: .15rem .7rem; min-width: 2.6rem; cursor: pointer; }
:focus-visible { outline: 3px solid var(--link); outline-offset: 2px; }
.state { margin: .8rem 0; max-width: none; font-weight: 600; font-variant-numeric: tabular-nums; }
.viewed { display: grid; grid-template-columns: minmax(0, 5fr) minmax(16rem, 3fr); gap: 1.2rem; align-items: center; }
.viewed svg { width: 100%; height: auto; }
.viewed text { fill: var(--ink); font-family: inherit; }
.viewed .grid { stroke: var(--line); stroke-width: 1; }
.viewed .edge { fill: none; stroke: var(--soft); stroke-width: 1.2; }
.viewed .curve { fill: none; stroke: var(--link); stroke-width: 2.2; stroke-linejoin: round; }
.viewed .guide { stroke: var(--bad); stroke-width: 1.2; stroke-dasharray: 5 4; }
.viewed .present { fill: var(--bad); stroke: var(--paper); stroke-width: 2; }
@media (max-width: 52rem) { .viewed { grid-template-columns: minmax(0, 1fr); } }
.filter input { font: inherit; color: var(--ink); background: var(--paper); border: 1px solid var(--soft); border-radius: .3rem;
  padding: .2rem .6rem; width: 20rem; max-width: 100%; }
.count { color: var(--soft); margin-left: 1rem; }
.thumbnail { display: block; width: 8rem; }
.thumbnail img { width: 8rem; height: 7.5rem; object-fit: cover; object-position: 4% 60%; }
body:has(.sortable) { max-width: 100rem; }
.sortable td, .sortable tbody th { vertical-align: middle; padding: .3rem .5rem; }
.sortable td:last-child { white-space: nowrap; }
thead button { font-weight: 600; text-align: inherit; border-color: transparent; background: none; padding: 0 .2rem; margin: 0 -.2rem; }
thead button:hover { border-color: var(--soft); }
[aria-sort] button::after { content: " \25B2"; font-size: .7em; }
[aria-sort=descending] button::after { content: " \25BC"; }
dt { font-weight: 600; margin-top: .9rem; }
dd { margin: .15rem 0 0 1.5rem; overflow-wrap: anywhere; }
footer { margin-top: 4rem; padding-top: 1rem; border-top: 1px solid var(--line); color: var(--soft); font-size: .9rem; }
@media (max-width: 30rem) { .formula { white-space: normal; } }
@media print {
  :root { --paper: #ffffff; --ink: #000000; --soft: #333333; --line: #999999; --stripe: #f4f4f4; --link: #000000;
    --good: #0b6b4a; --good-fill: #ffffff; --bad: #a03c00; --bad-fill: #ffffff; --note: #00507d; --note-fill: #ffffff; }
  body { max-width: none; padding: 0; font-size: 10pt; }
  nav, .controls { display: none; }
  h2, h3, h4 { break-after: avoid; }
  .wide { overflow: visible; }
  table { font-size: 7.5pt; line-height: 1.3; }
  th, td { padding: .12rem .22rem; }
  td:not(.number), td.prose { min-width: 0; }
  td, tbody th { overflow-wrap: break-word; }
  .number, .sortable td:last-child, fieldset label { white-space: normal; }
  .sortable table { font-size: 6.5pt; }
  thead button { padding: 0; margin: 0; border: 0; min-width: 0; font-size: inherit; }
  .thumbnail, .thumbnail img { width: 3.5rem; height: auto; }
  thead { display: table-header-group; }
  tr { break-inside: avoid; }
}
)css";
}

}  // namespace asperity::html
