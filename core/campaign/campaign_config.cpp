#include "core/campaign/campaign_config.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.hpp"
#include "core/campaign/campaign_grid.hpp"
#include "core/config/json_text.hpp"
#include "core/config/overrides.hpp"
#include "core/config/read_config.hpp"
#include "core/config/schema_faults.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Overrides of the campaign's own keys, and those laid over every run.
struct SplitOverrides {
  std::vector<Override> campaign;
  std::vector<std::string> runs;
};

SplitOverrides split(const std::vector<std::string>& texts) {
  const std::vector<Override> parsed = parse_overrides(texts);
  const std::vector<std::string> own = allowed_keys(parsed_schema("campaign"));
  SplitOverrides result;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::vector<std::string> tokens = pointer_tokens(parsed[i].pointer);
    if (std::find(own.begin(), own.end(), tokens.front()) != own.end()) {
      result.campaign.push_back(parsed[i]);
    } else {
      result.runs.push_back(texts[i]);
    }
  }
  return result;
}

void append(std::vector<Fault>& faults, std::vector<Fault> more) {
  std::move(more.begin(), more.end(), std::back_inserter(faults));
}

void throw_if_any(std::vector<Fault> faults) {
  if (!faults.empty()) throw Error(ErrorKind::config, std::move(faults));
}

/// The document, checked against the schema.
json read_document(const fs::path& path, const std::vector<Override>& overrides) {
  ParsedText parsed = parse_json(read_config_text(path), path.string());
  throw_if_any(std::move(parsed.faults));
  if (!parsed.document.is_object())
    throw Error(ErrorKind::config, {{path.string(), "must be an object", json_text(parsed.document),
                                     "{ \"base\": ..., \"vary\": [...], ... }", ""}});
  std::vector<Fault> faults = apply_overrides(parsed.document, parsed_schema("campaign"), overrides);
  append(faults, schema_faults(parsed.document, parsed_schema("campaign")));
  throw_if_any(std::move(faults));
  return std::move(parsed.document);
}

}  // namespace

SlurmConfig slurm_section(const json& document) {
  const json slurm = document.value("slurm", json::object());
  SlurmConfig c;
  c.partition = slurm.value("partition", c.partition);
  c.account = slurm.value("account", c.account);
  c.time_limit_min = slurm.value("time_limit_min", c.time_limit_min);
  c.memory_mb = slurm.value("memory_mb", c.memory_mb);
  c.max_tasks = slurm.value("max_tasks", c.max_tasks);
  c.extra_arguments = slurm.value("extra_arguments", c.extra_arguments);
  c.poll_interval_s = slurm.value("poll_interval_s", c.poll_interval_s);
  c.lost_after_s = slurm.value("lost_after_s", c.lost_after_s);
  c.resubmissions = slurm.value("resubmissions", c.resubmissions);
  return c;
}

namespace {

/// Reads run configurations, each file once, and gathers what is wrong with them; what is wrong with many runs in the
/// same way is told of the first.
class RunReader {
 public:
  explicit RunReader(std::vector<std::string> last_overrides) : last_overrides_(std::move(last_overrides)) {}

  void read(const GridRun& run, CampaignConfig& into) try {
    std::vector<std::string> overrides = run.overrides;
    overrides.insert(overrides.end(), last_overrides_.begin(), last_overrides_.end());
    into.runs.push_back({run.label, parse_run_config(text_of(run.config), run.config.string(), overrides)});
    into.base_names.push_back(run.config.stem().string());
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::config) throw;
    for (const Fault& fault : error.faults()) note(fault, run);
  }

  void throw_if_faulty() { throw_if_any(std::move(faults_)); }

 private:
  const std::string& text_of(const fs::path& path) {
    const auto found = texts_.find(path.string());
    if (found != texts_.end()) return found->second;
    return texts_.emplace(path.string(), read_config_text(path)).first->second;
  }

  void note(Fault fault, const GridRun& run) {
    if (!told_.insert(run.config.string() + describe(fault)).second) return;
    fault.where = run.config.string() + ", run \"" + run.label + "\": " + fault.where;
    faults_.push_back(std::move(fault));
  }

  std::vector<std::string> last_overrides_;
  std::map<std::string, std::string> texts_;
  std::set<std::string> told_;
  std::vector<Fault> faults_;
};

/// An override of a key that is varied would make its runs all the same.
std::vector<Fault> varied_overrides(const std::vector<std::string>& overrides, const std::vector<std::string>& varied) {
  std::vector<Fault> faults;
  for (const std::string& text : overrides) {
    const std::string pointer = text.substr(0, text.find('='));
    if (std::find(varied.begin(), varied.end(), pointer) == varied.end()) continue;
    faults.push_back({"--set " + pointer, "is varied by the campaign", text.substr(text.find('=') + 1), "",
                      "change \"vary\", \"runs\" or \"seeds\" of the file"});
  }
  return faults;
}

}  // namespace

CampaignConfig read_campaign_config(const fs::path& path, const std::vector<std::string>& overrides) {
  const SplitOverrides split_overrides = split(overrides);
  const json document = read_document(path, split_overrides.campaign);
  const Grid grid = make_grid(document, path.parent_path());
  CampaignConfig config;
  config.name = document.value("name", path.stem().string());
  config.description = document.value("description", "");
  config.slurm = slurm_section(document);
  config.varied = grid.varied;
  std::vector<std::string> all_varied = grid.varied;
  if (document.contains("seeds")) all_varied.push_back(kSeedPointer);
  throw_if_any(varied_overrides(split_overrides.runs, all_varied));
  RunReader reader(split_overrides.runs);
  for (const GridRun& run : grid.runs) reader.read(run, config);
  reader.throw_if_faulty();
  return config;
}

}  // namespace asperity
