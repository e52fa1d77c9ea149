#include "core/campaign/campaign_grid.hpp"

#include <algorithm>
#include <set>

#include "core/base/error.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMostRuns = 100000;

/// A value in a label: strings without quotes.
std::string plain(const json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

std::string override_text(const std::string& pointer, const json& value) { return pointer + "=" + value.dump(); }

std::vector<std::string> overrides_of(const json& set) {
  std::vector<std::string> overrides;
  for (const auto& [pointer, value] : set.items()) overrides.push_back(override_text(pointer, value));
  return overrides;
}

std::vector<std::string> bases_of(const json& document) {
  const json base = document.value("base", json::array());
  return base.is_string() ? std::vector{base.get<std::string>()} : base.get<std::vector<std::string>>();
}

std::vector<std::uint64_t> seeds_of(const json& document) {
  const json seeds = document.value("seeds", json::array());
  if (seeds.is_array()) return seeds.get<std::vector<std::uint64_t>>();
  std::vector<std::uint64_t> list(seeds.at("count").get<std::size_t>());
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = seeds.at("first").get<std::uint64_t>() + i;
  return list;
}

/// The last part of a pointer, or the whole where another varied key ends in the same.
std::string short_name(const json& vary, const std::string& pointer) {
  const std::string last = pointer_tokens(pointer).back();
  const auto same = std::count_if(
      vary.begin(), vary.end(), [&](const json& entry) { return pointer_tokens(entry.at("pointer")).back() == last; });
  return same > 1 ? pointer : last;
}

/// `run` once for every value, with it in label and overrides.
std::vector<GridRun> with_values(const std::vector<GridRun>& runs, const std::string& name, const std::string& pointer,
                                 const std::vector<json>& values) {
  std::vector<GridRun> result;
  for (const GridRun& run : runs) {
    for (const json& value : values) {
      GridRun one = run;
      one.label += (one.label.empty() ? "" : " ") + name + "=" + plain(value);
      one.overrides.push_back(override_text(pointer, value));
      result.push_back(std::move(one));
    }
  }
  return result;
}

std::vector<GridRun> with_seeds(const std::vector<GridRun>& runs, const std::vector<std::uint64_t>& seeds) {
  if (seeds.empty()) return runs;
  return with_values(runs, "seed", kSeedPointer, {seeds.begin(), seeds.end()});
}

std::vector<GridRun> grid_of_bases(const json& document, const fs::path& folder) {
  const json vary = document.value("vary", json::array());
  const std::vector<std::string> bases = bases_of(document);
  const bool named = bases.size() > 1 || vary.empty();
  std::vector<GridRun> runs;
  for (const std::string& base : bases) {
    const fs::path path = folder / base;
    runs.push_back({named ? path.stem().string() : "", path, overrides_of(document.value("set", json::object()))});
  }
  for (const json& entry : vary) {
    const std::string pointer = entry.at("pointer");
    runs = with_values(runs, short_name(vary, pointer), pointer, entry.at("values"));
  }
  return runs;
}

std::vector<GridRun> listed_runs(const json& document, const fs::path& folder) {
  std::vector<GridRun> runs;
  for (const json& entry : document.value("runs", json::array())) {
    std::vector<std::string> overrides = overrides_of(document.value("set", json::object()));
    const std::vector<std::string> own = overrides_of(entry.value("set", json::object()));
    overrides.insert(overrides.end(), own.begin(), own.end());
    runs.push_back({entry.at("label"), folder / entry.at("config").get<std::string>(), std::move(overrides)});
  }
  return runs;
}

bool is_pointer(const std::string& text) {
  try {
    return !json::json_pointer(text).empty();
  } catch (const json::parse_error&) {
    return false;
  }
}

std::vector<Fault> set_faults(const json& holder, const std::string& where) {
  std::vector<Fault> faults;
  const json set = holder.value("set", json::object());
  for (const auto& [pointer, value] : set.items()) {
    if (is_pointer(pointer)) continue;
    faults.push_back({child_pointer(where + "/set", pointer), "is no JSON pointer", json_text(value),
                      "a pointer like \"/particles/edge_mm\"", "keys begin with \"/\""});
  }
  return faults;
}

/// Keys varied twice, or by "seeds" as well.
std::vector<Fault> vary_faults(const json& document) {
  std::vector<Fault> faults;
  std::set<std::string> seen;
  if (document.contains("seeds")) seen.insert(kSeedPointer);
  const json vary = document.value("vary", json::array());
  for (std::size_t i = 0; i < vary.size(); ++i) {
    const std::string pointer = vary[i].at("pointer"), where = "/vary/" + std::to_string(i) + "/pointer";
    if (!is_pointer(pointer)) {
      faults.push_back({where, "is no JSON pointer", pointer, "a pointer like \"/particles/edge_mm\"", ""});
    } else if (!seen.insert(pointer).second) {
      faults.push_back({where, "is varied twice", pointer, "", "\"seeds\" varies /particles/seed"});
    }
  }
  return faults;
}

std::vector<Fault> missing_faults(const json& document) {
  const bool base = document.contains("base");
  if (!base && !document.contains("runs"))
    return {{"/base", "is missing, and so is \"runs\": there is nothing to run", "", "a path or a list of paths",
             "\"base\": \"quickstart.json\""}};
  if (!base && document.contains("vary"))
    return {{"/vary", "has no \"base\" to vary", "", "", "add \"base\", or put the values into \"runs\""}};
  return {};
}

void require_sound(const json& document) {
  std::vector<Fault> faults = missing_faults(document);
  const auto add = [&](const std::vector<Fault>& more) { faults.insert(faults.end(), more.begin(), more.end()); };
  add(set_faults(document, ""));
  add(vary_faults(document));
  const json runs = document.value("runs", json::array());
  for (std::size_t i = 0; i < runs.size(); ++i) add(set_faults(runs[i], "/runs/" + std::to_string(i)));
  if (!faults.empty()) throw Error(ErrorKind::config, std::move(faults));
}

/// Before the list is made: the product of a few lists is soon beyond what a machine can hold.
void require_countable(const json& document) {
  double count = static_cast<double>(bases_of(document).size());
  for (const json& entry : document.value("vary", json::array())) count *= entry.at("values").size();
  count += static_cast<double>(document.value("runs", json::array()).size());
  count *= static_cast<double>(std::max<std::size_t>(1, seeds_of(document).size()));
  if (count >= 1 && count <= kMostRuns) return;
  const std::string hint = count < 1 ? "name at least one configuration" : "split the campaign; they may share a store";
  throw Error(ErrorKind::config, {{"/", "has a number of runs that is out of range", number_text(count),
                                   "1 to " + std::to_string(kMostRuns), hint}});
}

void require_distinct(const std::vector<GridRun>& runs) {
  std::set<std::string> labels;
  std::vector<Fault> faults;
  for (const GridRun& run : runs) {
    if (labels.insert(run.label).second) continue;
    faults.push_back({"/runs", "gives a label twice", run.label, "", "labels name the rows of the table"});
  }
  if (!faults.empty()) throw Error(ErrorKind::config, std::move(faults));
}

std::vector<std::string> varied_pointers(const json& document) {
  std::vector<std::string> pointers;
  const auto add = [&](const std::string& pointer) {
    const bool known = std::find(pointers.begin(), pointers.end(), pointer) != pointers.end();
    if (!known && pointer != kSeedPointer) pointers.push_back(pointer);  // every table has the seed
  };
  for (const json& entry : document.value("vary", json::array())) add(entry.at("pointer"));
  for (const json& entry : document.value("runs", json::array())) {
    const json set = entry.value("set", json::object());
    for (const auto& [pointer, value] : set.items()) add(pointer);
  }
  return pointers;
}

}  // namespace

Grid make_grid(const json& document, const fs::path& folder) {
  require_sound(document);
  require_countable(document);
  Grid grid{grid_of_bases(document, folder), varied_pointers(document)};
  const std::vector<GridRun> listed = listed_runs(document, folder);
  grid.runs.insert(grid.runs.end(), listed.begin(), listed.end());
  grid.runs = with_seeds(grid.runs, seeds_of(document));
  require_distinct(grid.runs);
  return grid;
}

}  // namespace asperity
