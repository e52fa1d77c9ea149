#include "core/confrontation/feature_bank.hpp"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/config/enum_words.hpp"
#include "core/config/read_config.hpp"
#include "core/config/write_config.hpp"
#include "core/confrontation/significant_digits.hpp"
#include "core/measurement/features.hpp"

namespace asperity {
namespace {

constexpr const char* kHeader = "asperity feature bank 1";
constexpr const char* kFeatures = "features";
constexpr const char* kGolden = "golden";
constexpr const char* kHint = "have the bank written again by this build, or leave it out";
constexpr std::size_t kKeyDigits = 32;  // 128 bits: no two runs share them by chance
constexpr int kDigits = 9, kExactDigits = 17;

/// Where a line stands, for what is wrong with it.
struct BankLine {
  std::string where, text;
  [[noreturn]] void refuse(const std::string& what, const std::string& allowed) const {
    throw Error(ErrorKind::config, {{where, what, text.substr(0, 60), allowed, kHint}});
  }
};

std::string values_text(const FeatureValues& values, int digits) {
  std::string text;
  for (const std::optional<double>& value : values) text += value ? " " + digits_text(*value, digits) : " -";
  return text;
}

std::string features_line(ExperimentType type) {
  std::string text = std::string(kFeatures) + " " + std::string(word(type));
  for (const FeatureKind& kind : feature_kinds(type)) text += " " + std::string(kind.name);
  return text;
}

/// A configuration on one line; its name plays no part.
std::string config_line(RunConfig config) {
  config.name = kGolden;
  config.description.clear();
  return nlohmann::ordered_json::parse(effective_json(config)).dump();
}

ExperimentType read_experiment(std::istringstream& words, const BankLine& line) {
  std::string text;
  words >> text;
  for (const auto& [type, name] : words_of(ExperimentType{})) {
    if (name == text) return type;
  }
  line.refuse("names no experiment", "uniaxial, triaxial, brazilian or direct_shear");
}

std::optional<double> read_value(const std::string& text, const BankLine& line) {
  if (text == "-") return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    line.refuse("has what is no number: " + text, "numbers, and - where a feature is absent");
  return value;
}

FeatureValues read_values(std::istringstream& words, ExperimentType type, const BankLine& line) {
  FeatureValues values;
  for (std::string text; words >> text;) values.push_back(read_value(text, line));
  const std::size_t needed = feature_kinds(type).size();
  if (values.size() != needed)
    line.refuse("has " + std::to_string(values.size()) + " values", std::to_string(needed) + " values");
  return values;
}

void read_golden(FeatureBank& bank, const BankLine& line) {
  const std::size_t brace = line.text.find('{');
  if (brace == std::string::npos) line.refuse("is a golden run without a configuration", "a JSON object at its end");
  std::istringstream words(line.text.substr(0, brace));
  std::string golden;
  words >> golden;
  const ExperimentType type = read_experiment(words, line);
  FeatureValues values = read_values(words, type, line);
  try {
    bank.golden.push_back({parse_run_config(line.text.substr(brace), line.where), std::move(values)});
  } catch (const Error& error) {
    line.refuse(std::string("has a configuration that is none: ") + error.what(), "");
  }
  if (bank.golden.back().config.experiment.type != type) line.refuse("names another experiment than its run", "");
}

void read_run(FeatureBank& bank, const BankLine& line) {
  std::istringstream words(line.text);
  std::string key;
  words >> key;
  if (key.size() != kKeyDigits || key.find_first_not_of("0123456789abcdef") != std::string::npos)
    line.refuse("does not begin with a run's key", "32 hexadecimal digits");
  const ExperimentType type = read_experiment(words, line);
  if (!bank.runs.emplace(key, BankedRun{type, read_values(words, type, line)}).second)
    line.refuse("has the key of an earlier line", "each run once");
}

void read_line(FeatureBank& bank, const BankLine& line) {
  std::istringstream words(line.text);
  std::string first;
  words >> first;
  if (first == kFeatures) {
    if (line.text != features_line(read_experiment(words, line)))
      line.refuse("has other features than this build reads", "those of `asperity features`, in their order");
  } else if (first == kGolden) {
    read_golden(bank, line);
  } else {
    read_run(bank, line);
  }
}

}  // namespace

std::string bank_key(const RunConfig& config) { return config_hash(config).substr(0, kKeyDigits); }

double rounded(double value) { return rounded_to(value, kDigits); }

FeatureValues rounded(FeatureValues values) {
  for (std::optional<double>& value : values) {
    if (value) value = rounded(*value);
  }
  return values;
}

std::string bank_text(const FeatureBank& bank) {
  std::string text = std::string(kHeader) + "\n";
  for (const auto& [type, name] : words_of(ExperimentType{})) text += features_line(type) + "\n";
  for (const GoldenRun& run : bank.golden) {
    text += std::string(kGolden) + " " + std::string(word(run.config.experiment.type)) +
            values_text(run.values, kExactDigits) + " " + config_line(run.config) + "\n";
  }
  for (const auto& [key, run] : bank.runs)
    text += key + " " + std::string(word(run.experiment)) + values_text(run.values, kDigits) + "\n";
  return text;
}

FeatureBank parse_bank(const std::string& text, const std::string& origin) {
  FeatureBank bank;
  std::istringstream in(text);
  std::string content;
  for (std::size_t number = 1; std::getline(in, content); ++number) {
    const BankLine line{origin + ":" + std::to_string(number), content};
    if (number > 1) {
      read_line(bank, line);
    } else if (content != kHeader) {
      line.refuse("is no feature bank of this format", kHeader);
    }
  }
  if (text.empty() || text.back() != '\n') BankLine{origin, ""}.refuse("is cut off", "whole lines");
  return bank;
}

FeatureBank read_bank(const std::filesystem::path& path) { return parse_bank(read_config_text(path), path.string()); }

void write_bank(const std::filesystem::path& path, const FeatureBank& bank) {
  write_file_atomically(path, bank_text(bank));
}

const BankedRun* find_run(const FeatureBank& bank, const std::string& key) {
  const auto found = bank.runs.find(key);
  return found == bank.runs.end() ? nullptr : &found->second;
}

void merge(FeatureBank& bank, const FeatureBank& more) { bank.runs.insert(more.runs.begin(), more.runs.end()); }

}  // namespace asperity
