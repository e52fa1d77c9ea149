#include "core/output/html_sortable.hpp"

#include <fmt/format.h>

#include <cassert>

namespace asperity::html {

Markup thumbnail(const Picture& picture, const std::filesystem::path& target) {
  assert(!picture.alternative_text.empty());
  return Markup::from_html(
      fmt::format("<a class=\"thumbnail\" href=\"{}\"><img src=\"{}\" alt=\"{}\" loading=\"lazy\"></a>",
                  linked_source(target), picture.source, escaped(picture.alternative_text)));
}

Markup sortable_table(const Table& content, std::string_view rows_are) {
  const std::string words = escaped(rows_are);
  return Markup::from_html(fmt::format(
      "<div class=\"sortable\" data-rows=\"{0}\">\n<p class=\"filter controls\" hidden><label>Show {0} with (commas "
      "part several) "
      "<input type=\"search\" autocomplete=\"off\"></label> <span class=\"count\" aria-live=\"polite\"></span></p>\n{1}"
      "</div>\n",
      words, table(content).html()));
}

std::string_view sortable_table_script() {
  return R"js("use strict";
for (const sortable of document.querySelectorAll(".sortable")) {
  const body = sortable.querySelector("tbody"), rows = [...body.rows];
  const headings = [...sortable.querySelectorAll("thead th")];
  const box = sortable.querySelector("input[type=search]"), count = sortable.querySelector(".count");

  function value(row, column) {
    const text = row.cells[column].textContent.trim();
    const number = text.match(/^([−-]?[0-9.]+)( [^0-9]+)?$/);  // with a unit or without
    return number ? Number(number[1].replace("−", "-")) : text;
  }

  // Numbers by size, then words; what is not there comes last in either direction.
  function compare(a, b, direction) {
    const absent = (v) => v === "" || v === "–";
    if (absent(a) || absent(b)) return absent(a) - absent(b);
    const numbers = (typeof a === "number") + (typeof b === "number");
    if (numbers === 1) return typeof a === "number" ? -1 : 1;
    return direction * (numbers === 2 ? a - b : a.localeCompare(b, "en", { numeric: true }));
  }

  function sort(column) {
    const heading = headings[column], upwards = heading.getAttribute("aria-sort") !== "ascending";
    for (const other of headings) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", upwards ? "ascending" : "descending");
    rows.sort((a, b) => compare(value(a, column), value(b, column), upwards ? 1 : -1));
    body.append(...rows);
  }

  function filter() {
    const words = box.value.toLowerCase().split(",").map((word) => word.trim()).filter(Boolean);
    let shown = 0;
    for (const row of rows) {
      const text = row.textContent.toLowerCase();
      row.hidden = !words.every((word) => text.includes(word));
      shown += row.hidden ? 0 : 1;
    }
    count.textContent = shown + " of " + rows.length + " " + sortable.dataset.rows;
  }

  headings.forEach((heading, column) => {
    if (heading.textContent.trim() === "") return;
    const button = document.createElement("button");
    button.type = "button";
    button.append(...heading.childNodes);
    heading.append(button);
    button.addEventListener("click", () => sort(column));
  });
  box.addEventListener("input", filter);
  sortable.querySelector(".filter").hidden = false;
  filter();
}
)js";
}

}  // namespace asperity::html
