#pragma once
#include <string_view>

#include "core/output/html.hpp"

/// Tables that a reader sorts and filters. Without a script the page shows the table as it is.
namespace asperity::html {

/// A small picture that leads to a file beside the page, for a cell.
Markup thumbnail(const Picture& picture, const std::filesystem::path& target);

/// The table with a filter box above it; with the script, every heading but those of columns without one becomes a
/// button that sorts. `rows_are` names the rows: "runs".
Markup sortable_table(const Table& table, std::string_view rows_are);

/// What a page with sortable tables takes as Page::script.
std::string_view sortable_table_script();

}  // namespace asperity::html
