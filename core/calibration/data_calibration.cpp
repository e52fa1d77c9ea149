#include "core/calibration/data_calibration.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/atomic_file.hpp"
#include "core/calibration/calibration_json.hpp"
#include "core/calibration/config_sections.hpp"
#include "core/calibration/read_published.hpp"
#include "core/config/json_text.hpp"
#include "core/output/csv.hpp"

namespace asperity {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

ordered_json read_document(const fs::path& path) {
  std::string text;
  try {
    text = read_file(path);
  } catch (const Error& failure) {
    throw Error(ErrorKind::config, failure.faults());  // a config that cannot be read is wrong input, no failed output
  }
  const ParsedText parsed = parse_json(text, path.string());
  if (!parsed.faults.empty()) throw Error(ErrorKind::config, parsed.faults);
  return ordered_json::parse(text);  // again, because the first keeps no order of keys
}

PointKind kind_of(const std::vector<double>& levels) {
  std::size_t off = 0;
  for (double level : levels) off += level != 0.0;
  if (off == 0) return PointKind::centre;
  return off == 1 && levels.size() > 1 ? PointKind::star : PointKind::factorial;
}

/// Columns as rows.
std::vector<std::vector<double>> read_rows(const CsvData& table, const std::vector<std::string>& columns) {
  std::vector<std::vector<double>> rows(columns.empty() ? 0 : table.rows());
  for (const std::string& column : columns) {
    const std::vector<double> values = table.numbers(column);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(values[i]);
  }
  return rows;
}

void fill_design(Design& design, std::vector<std::vector<double>> coded) {
  for (const std::vector<double>& row : coded) {
    design.kind.push_back(kind_of(row));
    for (double level : row) design.alpha = std::max(design.alpha, std::abs(level));
  }
  design.coded = std::move(coded);
}

void note_bad_rows(Responses& responses, const Response& response) {
  for (std::size_t row = 0; row < response.values.size(); ++row) {
    if (std::isfinite(response.values[row])) continue;
    responses.bad_runs.push_back({row, response.name, "the table has no value", "left out of this response's model"});
  }
}

/// A column's name, or {"column": ..., "transform": "logarithm"}.
Response read_response(const std::string& property, const Section& entry, const CsvData& table) {
  const bool plain = entry.json()->is_string();
  const std::string column = plain ? entry.json()->get<std::string>() : entry.text("column");
  Response response{property, table.numbers(column), Transform::none};
  if (!plain && entry.choice("transform", {"none", "logarithm"}) == 1) response.transform = Transform::logarithm;
  return response;
}

void read_table(DataCalibration& calibration, const Section& data, const fs::path& folder) {
  const CsvData table = read_csv(folder / data.text("file"));
  const std::vector<std::string> coded = data.texts("coded_columns");
  if (coded.size() != calibration.design.factors.size()) data.fault("coded_columns", "has not one column a factor", "");
  fill_design(calibration.design, read_rows(table, coded));
  calibration.tabled = read_rows(table, data.texts("real_columns"));
  data.section("response_columns").for_each([&](const std::string& property, const Section& entry) {
    calibration.responses.list.push_back(read_response(property, entry, table));
    note_bad_rows(calibration.responses, calibration.responses.list.back());
  });
}

void throw_if(const std::vector<Fault>& faults) {
  if (!faults.empty()) throw Error(ErrorKind::config, faults);
}

}  // namespace

DataCalibration read_data_calibration(const fs::path& path) {
  const ordered_json document = read_document(path);
  std::vector<Fault> faults;
  const Section root(&document, "", faults);
  DataCalibration calibration;
  calibration.name = root.text("name", path.stem().string());
  calibration.description = root.text("description", "");
  calibration.targets = read_targets(document, faults);
  calibration.design.factors = read_factors(document, faults);
  calibration.options = read_analysis(document, faults);
  if (!root.has("data")) root.fault("data", "is missing", "");
  const Section data = root.section("data");
  const bool named = !data.text("file").empty();
  throw_if(faults);
  if (named) read_table(calibration, data, path.parent_path());
  calibration.published = read_published(root.section("published"), calibration.design.factors.size());
  throw_if(faults);
  check_design(calibration.design);
  return calibration;
}

ordered_json calibration_json(const DataCalibration& calibration, const Analysis& analysis) {
  const std::vector<Factor>& factors = calibration.design.factors;
  ordered_json json{{"name", calibration.name}, {"kind", "data"}, {"targets", targets_json(calibration.targets)}};
  json["elastic"] = nullptr;
  json["design"] = design_json(calibration.design, {});
  json["responses"] = responses_json(calibration.responses);
  json["bad_runs"] = bad_runs_json(calibration.responses.bad_runs);
  json["models"] = models_json(analysis.models, calibration.design.coded.size());
  json["rounds"] = ordered_json::array();
  json["rounds"].push_back(
      round_json({factors, 0.0, analysis.compromise.point.desirability, analysis.solutions.size()}));
  json["solutions"] = ordered_json::array();
  for (const Solution& solution : analysis.solutions) {
    json["solutions"].push_back(solution_json(solution, factors, calibration.targets));
  }
  json["compromise"] = solution_json(analysis.compromise, factors, calibration.targets);
  json["routes"] = nullptr;
  json["parameters"] =
      analysis.solutions.empty() ? ordered_json(nullptr) : parameters_json(factors, analysis.solutions.front().real);
  json["configs"] = ordered_json::array();
  json["verification"] = ordered_json::object();
  json["failure_mode"] = nullptr;
  json["trade_off"] = ordered_json::array();
  json["cost"] = {{"runs", 0}, {"reused", 0}, {"wall_s", nullptr}, {"compute_s", nullptr}};
  json["warnings"] = analysis.warnings;
  return json;
}

}  // namespace asperity
