#include "app/confrontation/condition_tables.hpp"

#include <algorithm>
#include <set>

#include "app/confrontation/words.hpp"
#include "core/config/enum_words.hpp"
#include "core/measurement/features.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;

constexpr const char* kErrors[] = {"load_noise_percent",  "displacement_noise_percent", "transverse_noise_percent",
                                   "load_scale_percent",  "displacement_scale_percent", "load_zero_percent",
                                   "displacement_zero_mm"};

std::string known(const Value& value) { return value.exists() ? figures(value.number()) : "not given"; }

std::string size_words(const Value& size) {
  std::string text;
  for (const double mm : size.numbers()) text += (text.empty() ? "" : " × ") + figures(mm, 4);
  return text.empty() ? "–" : text;
}

std::string stress_words(const ShownTest& test) {
  if (test.confining_pressure_mpa) return "σ₃ = " + figures(*test.confining_pressure_mpa);
  if (test.normal_stress_mpa) return "σₙ = " + figures(*test.normal_stress_mpa);
  return "–";
}

std::string preparation_words(const Value& conditions) {
  std::string text;
  if (const Value angle = conditions["core_angle_deg"]; angle.exists() && angle.number() != 0.0)
    text = "core turned by " + figures(angle.number()) + "°";
  if (conditions["lubricated_platens"].truth()) text += (text.empty() ? "" : ", ") + std::string("lubricated platens");
  return text.empty() ? "–" : text;
}

std::vector<std::string> instrument_cells(const Value& test) {
  std::vector<std::string> cells;
  for (const char* error : kErrors) cells.push_back(figures(test["instrument"][error].number()));
  cells.emplace_back(test["instrument_by_default"].truth() ? "the defaults" : "given; those left out by default");
  return cells;
}

}  // namespace

PlainTable conditions_table(const ConfrontationData& data) {
  PlainTable table{
      "How the laboratory made its tests, and how they are repeated. Simulations run at rates far above a "
      "laboratory's.",
      {{"Test", "", ColumnKind::head},
       {"Experiment", "", ColumnKind::text},
       {"Specimens", ""},
       {"Size", "mm", ColumnKind::text},
       {"Stress", "MPa", ColumnKind::text},
       {"Laboratory's rate", "mm/s"},
       {"Simulated rate", "mm/s"},
       {"Particles' edge", "mm"},
       {"Plane", "", ColumnKind::text},
       {"Specimens' preparation", "", ColumnKind::text}},
      {}};
  for (const Value& entry : data.shown["tests"].items()) {
    const Value c = entry["conditions"];
    if (!c.exists()) continue;
    const std::string id = entry["id"].text();
    const auto test =
        std::find_if(data.tests.begin(), data.tests.end(), [&](const ShownTest& t) { return t.id == id; });
    table.rows.push_back(
        {{id, feature_words(word(test->experiment)), std::to_string(entry["specimens"].count()),
          size_words(c["size_mm"]), stress_words(*test), known(c["laboratory_rate_mm_per_s"]),
          known(c["rate_mm_per_s"]), figures(c["edge_mm"].number()), c["plane"].text(), preparation_words(c)},
         html::RowTone::plain});
  }
  return table;
}

PlainTable instruments_table(const ConfrontationData& data) {
  PlainTable table{
      "Standard deviations of the laboratory's instruments: noise of single rows and zeros are each "
      "specimen's own, scales are all specimens'. Noise and zeros in percent of the largest value, scales of each "
      "value.",
      {{"Tests", "", ColumnKind::head},
       {"Load, noise", "%"},
       {"Path, noise", "%"},
       {"Sideways, noise", "%"},
       {"Load, scale", "%"},
       {"Path, scale", "%"},
       {"Load, zero", "%"},
       {"Path, zero", "mm"},
       {"Declared", "", ColumnKind::text}},
      {}};
  for (const Value& entry : data.shown["tests"].items()) {
    if (!entry["instrument"].exists()) continue;
    const std::vector<std::string> cells = instrument_cells(entry);
    const auto same = std::find_if(table.rows.begin(), table.rows.end(), [&](const PlainRow& row) {
      return std::equal(cells.begin(), cells.end(), row.cells.begin() + 1);
    });
    if (same != table.rows.end()) {
      same->cells.front() += ", " + entry["id"].text();
      continue;
    }
    PlainRow row{{entry["id"].text()}, html::RowTone::plain};
    row.cells.insert(row.cells.end(), cells.begin(), cells.end());
    table.rows.push_back(std::move(row));
  }
  return table;
}

PlainTable features_table(const ConfrontationData& data) {
  PlainTable table{
      "What the compared features are.", {{"Feature", "", ColumnKind::head}, {"What", "", ColumnKind::prose}}, {}};
  std::set<std::string> told;
  for (const ShownSlot& slot : data.slots) {
    for (const ShownTest& test : data.tests) {
      const FeatureKind* kind = test.id == slot.test ? find_feature_kind(test.experiment, slot.feature) : nullptr;
      const std::string what = kind ? std::string(kind->what) : "";
      if (kind && told.insert(slot.feature + what).second)
        table.rows.push_back({{feature_words(slot.feature), what}, html::RowTone::plain});
    }
  }
  return table;
}

}  // namespace asperity::app
