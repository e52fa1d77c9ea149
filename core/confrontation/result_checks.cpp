#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <span>

#include "core/config/schema_lookup.hpp"
#include "core/config/suggest.hpp"
#include "core/confrontation/column_units.hpp"
#include "core/confrontation/test_checks.hpp"
#include "core/measurement/features.hpp"

namespace asperity {
namespace {

using nlohmann::json;

/// Quantity and base of a feature's name.
struct Named {
  std::string base;
  Quantity quantity;
};

Named split_name(const FeatureKind& kind) {
  static const std::map<std::string_view, std::pair<std::string_view, Quantity>> units{
      {"MPa", {"_mpa", Quantity::stress}},
      {"GPa", {"_gpa", Quantity::modulus}},
      {"mm", {"_mm", Quantity::length}},
      {"N/mm", {"_n_per_mm", Quantity::line_load}}};
  const auto found = units.find(kind.unit);
  if (found == units.end()) {
    if (kind.name.ends_with("_count") || kind.name == "events_at_peak")
      return {std::string(kind.name), Quantity::count};
    return {std::string(kind.name), kind.name.find("strain") != kind.name.npos ? Quantity::strain : Quantity::ratio};
  }
  const std::string_view suffix = found->second.first;
  return {std::string(kind.name.substr(0, kind.name.size() - suffix.size())), found->second.second};
}

struct KnownResult {
  const FeatureKind* kind;
  Quantity quantity;
  double factor;
};

/// The feature a result is, and the factor to its unit.
std::optional<KnownResult> known_result(const std::string& key, ExperimentType experiment) {
  for (const FeatureKind& kind : feature_kinds(experiment)) {
    const Named named = split_name(kind);
    if (const auto factor = unit_factor(key, named.base, named.quantity))
      return KnownResult{&kind, named.quantity, *factor};
  }
  return std::nullopt;
}

Fault unknown_result(const std::string& key, const std::string& pointer, ExperimentType experiment) {
  std::vector<std::string> names;
  for (const FeatureKind& kind : feature_kinds(experiment)) {
    const Named named = split_name(kind);
    if (key.starts_with(named.base + "_") && unit_suffixes(named.quantity).size() > 1) {
      return {pointer, "the unit of a result is not known", key, names_with_units(named.base, named.quantity),
              "convert it to one of these"};
    }
    names.emplace_back(kind.name);
  }
  const std::string near = closest(key, names);
  return {pointer, "is no result of this experiment", key, "names of its features",
          near.empty() ? "`asperity features` prints them, docs/measured_data.md lists them"
                       : "did you mean " + near + "?"};
}

/// One number, or a list of numbers and nulls; empty where it is neither.
std::vector<double> values_of(const json& given) {
  if (given.is_number()) return {given.get<double>()};
  std::vector<double> values;
  if (!given.is_array()) return values;
  for (const json& one : given) {
    if (!one.is_number() && !one.is_null()) return {};
    values.push_back(one.is_null() ? std::numeric_limits<double>::quiet_NaN() : one.get<double>());
  }
  return values;
}

bool is_one_of(std::string_view name, std::span<const std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_drop(const FeatureKind& kind) { return kind.name.ends_with("_drop_mpa"); }

/// Features that lie above 0 by their definition: strengths, slopes of rising lines, ways to the peak. A residual may
/// be 0, a toe and what goes sideways have either sign.
bool is_positive(const FeatureKind& kind) {
  constexpr std::string_view kSlopes[] = {"GPa", "N/mm2", "MPa/mm"};
  constexpr std::string_view kOthers[] = {
      "peak_axial_strain",          "peak_strain_from_toe",          "peak_closure_mm",     "peak_closure_from_toe_mm",
      "peak_shear_displacement_mm", "peak_displacement_from_toe_mm", "late_stiffness_ratio"};
  const bool load = kind.unit == "MPa" || kind.unit == "N/mm";
  const bool may_be_zero = kind.name.starts_with("residual_") || is_drop(kind);
  return is_one_of(kind.unit, kSlopes) || is_one_of(kind.name, kOthers) || (load && !may_be_zero);
}

/// Where a feature is a share, the least and the largest that noise and a load cell's zero leave possible.
struct ShareRange {
  std::string_view name;
  double least, largest;
};

constexpr ShareRange kShares[] = {{"event_share_at_half", 0.0, 1.0},
                                  {"event_share_at_four_fifths", 0.0, 1.0},
                                  {"event_onset_share", -0.1, 1.1},
                                  {"drop_share", -0.1, 1.1},
                                  {"toe_extent_share", -1.0, 1.0}};

bool is_no_share(std::string_view name, double value) {
  return std::any_of(std::begin(kShares), std::end(kShares), [&](const ShareRange& share) {
    return share.name == name && (value < share.least || value > share.largest);
  });
}

std::string size_hint(const KnownResult& known, const std::string& key) {
  if (known.quantity == Quantity::strain && known.factor == 1.0) return "in percent its name is " + key + "_percent";
  return unit_suffixes(known.quantity).size() > 1 ? "is the unit of its name that of its numbers?" : "";
}

/// What is wrong with a value, in the core's unit; its place and the number as written are left open.
std::optional<Fault> value_fault(double value, const KnownResult& known, const std::string& key) {
  const QuantityLimit limit = limit_of(known.quantity);
  if (std::abs(value) > limit.largest)
    return Fault{"", "is too large for " + std::string(limit.word), "",
                 fmt::format("up to {:g}", limit.largest / known.factor), size_hint(known, key)};
  if (is_positive(*known.kind) && value <= 0.0)
    return Fault{"", "cannot be 0 or below", "", "above 0", "its sign is that of what is measured; null: not measured"};
  if ((known.quantity == Quantity::count || is_drop(*known.kind)) && value < 0.0)
    return Fault{"", "cannot be below 0", "", "0 or more", "null: not measured"};
  if (is_no_share(known.kind->name, value))
    return Fault{"", "is no share", "", "0 to 1", "a share is no percentage; null: not measured"};
  return std::nullopt;
}

/// Brings the values of a result into the core's unit. Those that cannot be become unmeasured; the first is the fault.
void convert(std::vector<double>& values, const KnownResult& known, const std::string& key, const std::string& place,
             std::vector<Fault>& faults) {
  bool told = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double written = values[i];
    values[i] *= known.factor;
    std::optional<Fault> fault = std::isnan(written) ? std::nullopt : value_fault(values[i], known, key);
    if (!fault) continue;
    values[i] = std::numeric_limits<double>::quiet_NaN();
    if (told) continue;
    told = true;
    fault->where = values.size() > 1 ? place + "/" + std::to_string(i) : place;
    fault->value = number_text(written);
    faults.push_back(*std::move(fault));
  }
}

/// Values may be of more specimens than have a curve, the same in all results.
std::optional<Fault> count_fault(const std::string& place, std::size_t given, std::size_t curves, std::size_t before) {
  constexpr const char* kHint = "write null where a specimen has no value";
  if (before != 0 && given != before)
    return Fault{place, "has another number of specimens than the results before it", std::to_string(given),
                 std::to_string(before), kHint};
  if (given < curves)
    return Fault{place, "has fewer specimens than the curves", std::to_string(given),
                 std::to_string(curves) + " or more, those of the curves first", kHint};
  return std::nullopt;
}

}  // namespace

std::vector<Fault> take_in_results(const json& given, const std::string& pointer, MeasuredTest& test) {
  std::vector<Fault> faults;
  std::size_t count = 0;
  if (!given.contains("results")) return faults;
  for (const auto& [key, value] : given.at("results").items()) {
    const std::string place = child_pointer(pointer + "/results", key);
    const auto known = known_result(key, test.experiment);
    if (!known) {
      faults.push_back(unknown_result(key, place, test.experiment));
      continue;
    }
    std::vector<double> values = values_of(value);
    if (values.empty()) {
      faults.push_back({place, "is no list of numbers", json_text(value), "a number for each specimen, or null", ""});
      continue;
    }
    if (auto fault = count_fault(place, values.size(), test.curves.size(), count)) faults.push_back(*std::move(fault));
    if (count == 0) count = values.size();
    convert(values, *known, key, place, faults);
    if (!test.results.emplace(known->kind->name, std::move(values)).second) {
      faults.push_back({place, "is given twice, in two units", key, "one of them", ""});
    }
  }
  return faults;
}

}  // namespace asperity
