#include "core/confrontation/read_measured.hpp"

#include <algorithm>

#include "core/config/enum_words.hpp"
#include "core/config/json_text.hpp"
#include "core/config/read_config.hpp"
#include "core/config/schema_faults.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/confrontation/measured_curve.hpp"
#include "core/confrontation/test_checks.hpp"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

void append(std::vector<Fault>& faults, std::vector<Fault> more) {
  std::move(more.begin(), more.end(), std::back_inserter(faults));
}

std::optional<double> number(const json& j, const char* key) {
  return j.contains(key) ? std::optional(j.at(key).get<double>()) : std::nullopt;
}

/// Lays the keys given over what holds so far.
void read_instrument(const json& j, Instrument& instrument) {
  if (!j.contains("instrument")) return;
  const json& given = j.at("instrument");
  const auto take = [&](const char* key, double& value) { value = given.value(key, value); };
  take("load_noise_percent", instrument.load_noise_percent);
  take("displacement_noise_percent", instrument.displacement_noise_percent);
  take("transverse_noise_percent", instrument.transverse_noise_percent);
  take("load_scale_percent", instrument.load_scale_percent);
  take("displacement_scale_percent", instrument.displacement_scale_percent);
  take("load_zero_percent", instrument.load_zero_percent);
  take("displacement_zero_mm", instrument.displacement_zero_mm);
}

void read_profile(const json& j, MeasuredTest& test) {
  for (const json& tooth : j.value("profile", json::array())) {
    ToothConfig t;
    t.angle_deg = tooth.at("angle_deg").get<double>();
    t.height_mm = tooth.at("height_mm").get<double>();
    t.gap_before_mm = tooth.value("gap_before_mm", t.gap_before_mm);
    test.profile.push_back(t);
  }
}

MeasuredTest read_test(const json& j, const Instrument& instrument) {
  MeasuredTest test;
  test.id = j.at("id").get<std::string>();
  test.note = j.value("note", "");
  test.experiment = from_word<ExperimentType>(j.at("experiment").get<std::string>());
  test.width_mm = number(j, "width_mm");
  test.height_mm = number(j, "height_mm");
  test.diameter_mm = number(j, "diameter_mm");
  test.thickness_mm = number(j, "thickness_mm");
  test.confining_pressure_mpa = number(j, "confining_pressure_mpa");
  test.normal_stress_mpa = number(j, "normal_stress_mpa");
  test.end_gap_mm = number(j, "end_gap_mm");
  test.closing_rate_mm_per_s = number(j, "closing_rate_mm_per_s");
  test.shear_rate_mm_per_s = number(j, "shear_rate_mm_per_s");
  test.axial_gauge_mm = number(j, "axial_gauge_mm");
  if (j.contains("plane")) test.plane = from_word<PlaneCondition>(j.at("plane").get<std::string>());
  test.preparation.core_angle_deg = j.value("core_angle_deg", 0.0);
  test.preparation.lubricated_platens = j.value("lubricated_platens", false);
  test.ends_before_peak = j.value("ends_before_peak", false);
  if (j.contains("use")) test.use = j.at("use") == "fit" ? TestUse::fit : TestUse::hold_out;
  if (j.value("scatter", "pooled") == "specimens") test.scatter = ScatterSource::specimens;
  test.instrument = instrument;
  read_instrument(j, test.instrument);
  read_profile(j, test);
  return test;
}

/// The curves of a test from its file.
void read_curves(const json& j, const fs::path& folder, MeasuredTest& test, std::vector<Fault>& faults) {
  if (!j.contains("curve")) return;
  const fs::path given = j.at("curve").get<std::string>();
  const fs::path file = given.is_absolute() ? given : folder / given;
  try {
    append(faults, take_in_curves(read_csv(file), file, test));
  } catch (const Error& error) {
    for (Fault fault : error.faults()) {
      if (fault.allowed.empty() && fault.hint.empty())
        fault.hint = "the path of a curve is relative to the measured file";
      faults.push_back(std::move(fault));
    }
    return;
  }
  append(faults, curve_faults(test));
}

std::string name_of(const json& document, const fs::path& origin) {
  return document.value("name", origin.stem().string());
}

/// Fills what the schema has accepted. Faults of a test leave the others to be checked.
MeasuredData fill(const json& document, const fs::path& origin, std::vector<Fault>& faults) {
  MeasuredData data{name_of(document, origin),     document.value("material", ""),    document.value("source", ""),
                    document.value("licence", ""), document.value("description", ""), {}};
  Instrument instrument;
  read_instrument(document, instrument);
  std::size_t index = 0;
  for (const json& j : document.at("tests")) {
    const std::string pointer = "/tests/" + std::to_string(index++);
    MeasuredTest test = read_test(j, instrument);
    append(faults, key_faults(j, pointer, test.experiment));
    read_curves(j, origin.parent_path(), test, faults);
    append(faults, take_in_results(j, pointer, test));
    append(faults, test_faults(test, pointer));
    data.tests.push_back(std::move(test));
  }
  append(faults, id_faults(data));
  return data;
}

}  // namespace

MeasuredData parse_measured_data(const std::string& text, const fs::path& origin) {
  const json& schema = parsed_schema("measured");
  ParsedText parsed = parse_json(text, origin.string());
  std::vector<Fault> faults = std::move(parsed.faults);
  if (parsed.well_formed && !parsed.document.is_object()) {
    faults.push_back(
        {origin.string(), "must be an object", json_text(parsed.document), "{ \"tests\": [...], ... }", ""});
  } else if (parsed.well_formed) {
    append(faults, schema_faults(parsed.document, schema));
  }
  if (!faults.empty()) throw Error(ErrorKind::config, std::move(faults));
  MeasuredData data = fill(parsed.document, origin, faults);
  if (!faults.empty()) throw Error(ErrorKind::config, std::move(faults));
  return data;
}

MeasuredData read_measured_data(const fs::path& path) { return parse_measured_data(read_config_text(path), path); }

}  // namespace asperity
