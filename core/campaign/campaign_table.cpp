#include "core/campaign/campaign_table.hpp"

#include <algorithm>
#include <optional>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/config/bindings.hpp"
#include "core/config/write_config.hpp"
#include "core/output/csv.hpp"
#include "core/output/summary.hpp"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;
using Summaries = std::vector<std::optional<Summary>>;

const CsvCell kEmpty{""};

Summaries read_summaries(const std::vector<CampaignOutcome>& outcomes) {
  Summaries summaries;
  for (const CampaignOutcome& outcome : outcomes) {
    const bool finished = outcome.status == RunStatus::finished;
    summaries.push_back(finished ? std::optional(read_summary(outcome.folder / "summary.json")) : std::nullopt);
  }
  return summaries;
}

/// A label or a value may hold a line break, a row may not.
CsvCell word_cell(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return {std::string_view(text)};
}

bool is_number(const Json& value) { return value.is_number() || value.is_null(); }

/// Names of the numbers in "results" of all runs, in the order of their first appearance.
std::vector<std::string> result_names(const Summaries& summaries) {
  std::vector<std::string> names;
  for (const auto& summary : summaries) {
    if (!summary) continue;
    for (const auto& [name, value] : summary->results.items())
      if (is_number(value) && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

CsvCell number_cell(const Json& object, const std::string& key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return kEmpty;
  return found->is_number_integer() ? CsvCell(found->get<std::int64_t>()) : CsvCell(found->get<double>());
}

/// A configuration's value as the user would write it, strings without their quotes.
std::string plain_value(const RunConfig& config, const std::string& pointer) {
  const std::string text = value_text(config, pointer);
  const bool quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
  return quoted ? text.substr(1, text.size() - 2) : text;
}

std::vector<CsvCell> row_of(const CampaignConfig& config, std::size_t i, const CampaignOutcome& outcome) {
  const RunConfig& run = config.runs[i].config;
  std::vector<CsvCell> row{word_cell(outcome.label), word_cell(outcome.folder.filename().string()),
                           word_cell(config.base_names[i])};
  for (const std::string& pointer : config.varied) row.push_back(word_cell(plain_value(run, pointer)));
  row.insert(row.end(), {run.particles.seed, status_word(outcome.status), word_cell(outcome.reason)});
  return row;
}

void append_results(std::vector<CsvCell>& row, const std::optional<Summary>& summary,
                    const std::vector<std::string>& names) {
  const Json none = Json::object();
  for (const std::string& name : names) row.push_back(number_cell(summary ? summary->results : none, name));
  row.push_back(number_cell(summary ? summary->cracks : none, "tension"));
  row.push_back(number_cell(summary ? summary->cracks : none, "shear"));
  row.push_back(number_cell(summary ? summary->energy : none, "relative_closure_error"));
}

std::vector<std::string> columns_of(const CampaignConfig& config, const std::vector<std::string>& names) {
  std::vector<std::string> columns{"label", "run", "config"};
  columns.insert(columns.end(), config.varied.begin(), config.varied.end());
  columns.insert(columns.end(), {"seed", "status", "reason"});
  columns.insert(columns.end(), names.begin(), names.end());
  columns.insert(columns.end(), {"cracks_tension", "cracks_shear", "relative_closure_error"});
  return columns;
}

Json run_json(const CampaignConfig& config, std::size_t i, const CampaignOutcome& outcome) {
  const RunConfig& run = config.runs[i].config;
  Json json = {{"label", outcome.label},         {"folder", outcome.folder.string()},
               {"config", config.base_names[i]}, {"config_hash", config_hash(run)},
               {"seed", run.particles.seed},     {"status", status_word(outcome.status)},
               {"reason", outcome.reason},       {"reused", outcome.reused},
               {"exit_code", outcome.exit_code}, {"compute_s", outcome.compute_s}};
  for (const std::string& pointer : config.varied) json["varied"][pointer] = plain_value(run, pointer);
  return json;
}

/// Computing time of this call alone: what was re-used was paid before.
Json cost_json(const std::vector<CampaignOutcome>& outcomes, double wall_s) {
  const auto count = [&](auto holds) { return std::count_if(outcomes.begin(), outcomes.end(), holds); };
  double compute_s = 0;
  for (const CampaignOutcome& outcome : outcomes) compute_s += outcome.reused ? 0.0 : outcome.compute_s;
  return {{"runs", outcomes.size()},
          {"finished", count([](const auto& o) { return o.status == RunStatus::finished; })},
          {"failed", count([](const auto& o) { return o.status == RunStatus::failed; })},
          {"interrupted", count([](const auto& o) { return o.status == RunStatus::interrupted; })},
          {"reused", count([](const auto& o) { return o.reused; })},
          {"wall_s", wall_s},
          {"compute_s", compute_s}};
}

}  // namespace

const char* status_word(RunStatus status) {
  if (status == RunStatus::finished) return "finished";
  return status == RunStatus::failed ? "failed" : "interrupted";
}

void write_campaign_table(const std::filesystem::path& path, const CampaignConfig& config,
                          const std::vector<CampaignOutcome>& outcomes) {
  const Summaries summaries = read_summaries(outcomes);
  const std::vector<std::string> names = result_names(summaries);
  std::vector<std::vector<CsvCell>> rows;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    rows.push_back(row_of(config, i, outcomes[i]));
    append_results(rows.back(), summaries[i], names);
  }
  write_csv(path, columns_of(config, names), rows);
}

void write_campaign_json(const std::filesystem::path& path, const CampaignConfig& config,
                         const std::vector<CampaignOutcome>& outcomes, double wall_s) {
  Json json = {{"name", config.name}, {"description", config.description}, {"runs", Json::array()}};
  for (std::size_t i = 0; i < outcomes.size(); ++i) json["runs"].push_back(run_json(config, i, outcomes[i]));
  json["cost"] = cost_json(outcomes, wall_s);
  write_file_atomically(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace asperity
