#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "core/config/enum_words.hpp"
#include "core/confrontation/instrument_json.hpp"
#include "core/confrontation/read_measured.hpp"
#include "core/confrontation/run_curve.hpp"
#include "core/confrontation/test_features.hpp"

namespace asperity::app {
namespace {

using Json = nlohmann::ordered_json;

/// What is printed of a test or a run.
struct Printed {
  bool has_curves = true;
  std::string id;
  ExperimentType experiment;
  std::vector<std::string> specimens;
  std::vector<TestFeature> features;
  std::optional<Instrument> instrument;  ///< Of a measured test.
};

Json value_json(const SpecimenValue& s) {
  if (!s.value) return {{"value", nullptr}, {"absent", s.absent}};
  return {{"value", *s.value},
          {"instrument_sd", s.instrument_sd},
          {"noise_sd", s.noise_sd},
          {"from", s.from_results ? "results" : "curve"}};
}

Json feature_json(const TestFeature& feature) {
  Json specimens = Json::array();
  for (const SpecimenValue& s : feature.specimens) specimens.push_back(value_json(s));
  return {{"unit", feature.kind->unit},
          {"equation", feature.kind->equation},
          {"what", feature.kind->what},
          {"count", feature.count},
          {"mean", feature.count > 0 ? Json(feature.mean) : Json()},
          {"sd", feature.count > 1 ? Json(feature.sd) : Json()},
          {"specimens", specimens}};
}

Json test_json(const Printed& test) {
  Json features = Json::object();
  for (const TestFeature& f : test.features) features[std::string(f.kind->name)] = feature_json(f);
  return {{"id", test.id},
          {"experiment", word(test.experiment)},
          {"specimens", test.specimens},
          {"instrument", test.instrument ? instrument_json(*test.instrument) : Json()},
          {"features", features}};
}

std::string with_unit(std::string_view unit) { return unit == "1" ? "" : " " + std::string(unit); }

void print_value(const TestFeature& f) {
  std::string line = fmt::format("  {:<34}{:>12.6g}", f.kind->name, f.mean);
  if (f.count > 1) line += fmt::format(" +- {:.2g}", f.sd);
  line += with_unit(f.kind->unit);
  if (f.count > 1) line += fmt::format(" (n {})", f.count);
  std::cout << line << fmt::format("  {}\n", f.kind->equation);
}

void print_test(const Printed& test) {
  const std::size_t n = test.specimens.size();
  std::cout << fmt::format("{} ({}, {} specimen{})\n", test.id, word(test.experiment), n, n == 1 ? "" : "s");
  for (const TestFeature& f : test.features) {
    if (f.count > 0) print_value(f);
  }
  for (const TestFeature& f : test.features) {
    if (f.count == 0 && test.has_curves)
      std::cout << fmt::format("  {:<34}     not there: {}\n", f.kind->name, f.specimens.front().absent);
  }
}

std::vector<Printed> tests_of(const std::filesystem::path& source) {
  if (std::filesystem::is_directory(source)) {
    const RunCurve run = read_run_curve(source);
    return {{true,
             run.config.name,
             run.config.experiment.type,
             {"simulated"},
             features_of(run.curve, reading_of_run(run.config)),
             std::nullopt}};
  }
  std::vector<Printed> tests;
  for (const MeasuredTest& test : read_measured_data(source).tests) {
    tests.push_back(
        {!test.curves.empty(), test.id, test.experiment, specimens_of(test), features_of(test), test.instrument});
  }
  return tests;
}

}  // namespace

int features_command(const FeaturesOptions& options) {
  const std::vector<Printed> tests = tests_of(options.source);
  if (!options.json) {
    for (const Printed& test : tests) print_test(test);
    return 0;
  }
  Json list = Json::array();
  for (const Printed& test : tests) list.push_back(test_json(test));
  std::cout << Json{{"source", options.source.string()}, {"tests", list}}.dump(2) << "\n";
  return 0;
}

}  // namespace asperity::app
