#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

/// The reference of a configuration's keys, for people: pages of Markdown made of the schema, so that they say what the
/// program does.
namespace asperity {

/// The page of one kind of configuration (see schema_text): a section for each object and for the entries of each list
/// of objects, with a row for every key: JSON pointer, type, unit, what is allowed, default, meaning. In a run's page
/// conditional keys say where they have a meaning, and each mechanism has a section of its own. An unknown kind is a
/// usage error.
std::string schema_reference(std::string_view kind);

/// The same of any schema; `run` tells whether the conditions and mechanisms of a run belong to it.
std::string schema_reference(const nlohmann::ordered_json& schema, std::string_view kind, bool run);

/// Rows of a Markdown table for the keys of an object node at `pointer`, in the schema's order, without its head.
std::string reference_rows(const nlohmann::ordered_json& node, const std::string& pointer, bool run);

/// The head of such a table.
std::string reference_table_head();

/// A section for each mechanism that is declared: what it is, where it acts, its parameters.
std::string mechanisms_reference();

/// Text that may stand in a cell of a Markdown table.
std::string table_cell(std::string text);

}  // namespace asperity
