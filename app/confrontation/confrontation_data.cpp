#include "app/confrontation/confrontation_data.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.hpp"
#include "core/config/enum_words.hpp"

namespace asperity::app {
namespace {

std::optional<double> optional_number(const Value& value) {
  return value.exists() ? std::optional<double>(value.number()) : std::nullopt;
}

ExperimentType experiment_of(const Value& value, const std::string& test) {
  for (const ExperimentType type :
       {ExperimentType::uniaxial, ExperimentType::triaxial, ExperimentType::brazilian, ExperimentType::direct_shear}) {
    if (word(type) == value.text()) return type;
  }
  throw Error(ErrorKind::config, {{"shown.json: /tests/" + test + "/experiment", "is no experiment", value.text(),
                                   "uniaxial, triaxial, brazilian or direct_shear", ""}});
}

std::vector<ShownCurve> read_curves(const Value& list) {
  std::vector<ShownCurve> curves;
  for (const Value& entry : list.items()) {
    ShownCurve curve{
        entry["specimen"].text(), entry["path"].numbers(), entry["load"].numbers(), entry["folder"].text(), {},
        entry["reason"].text()};
    if (curve.path.size() != curve.load.size())
      throw Error(ErrorKind::config, {{"shown.json: a curve", "has path and load of different lengths",
                                       std::to_string(curve.path.size()), std::to_string(curve.load.size()), ""}});
    for (const auto& [name, value] : entry["features"].entries()) curve.features[name] = value.number();
    curve.kinetic = optional_number(entry["kinetic_over_stored"]).value_or(0.0);
    curves.push_back(std::move(curve));
  }
  return curves;
}

ShownTest read_test(const Value& entry) {
  ShownTest test;
  test.id = entry["id"].text();
  test.experiment = experiment_of(entry["experiment"], test.id);
  test.kept_back = entry["use"].text() == "hold_out";
  test.path_is_gauge = entry["path_is_gauge"].truth();
  test.confining_pressure_mpa = optional_number(entry["confining_pressure_mpa"]);
  test.normal_stress_mpa = optional_number(entry["normal_stress_mpa"]);
  for (const auto& [name, values] : entry["features"].entries()) test.features[name] = values.numbers();
  test.measured = read_curves(entry["measured"]);
  test.base = read_curves(entry["base"]);
  test.extension = read_curves(entry["extension"]);
  return test;
}

ShownCandidate read_candidate(const Value& entry, std::size_t slots) {
  ShownCandidate candidate{entry["id"].text(),
                           entry["suspect"].truth(),
                           entry["two_sided"].truth(),
                           entry["whole"].truth(),
                           entry["most"].number(),
                           entry["explained"].number(),
                           entry["absorbed_share"].number(),
                           entry["detectable"].number(),
                           entry["projected"].numbers()};
  if (candidate.projected.size() != slots)
    throw Error(ErrorKind::config,
                {{"shown.json: /candidates/" + candidate.id + "/projected", "has another length than there are slots",
                  std::to_string(candidate.projected.size()), std::to_string(slots), ""}});
  return candidate;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

ConfrontationData confrontation_data(const std::filesystem::path& folder, Value verdict, Value shown, Value manifest) {
  ConfrontationData data{folder, std::move(verdict), std::move(shown), std::move(manifest), {}, {}, {}, {}};
  for (const Value& entry : data.shown["tests"].items()) data.tests.push_back(read_test(entry));
  for (const Value& entry : data.shown["slots"].items())
    data.slots.push_back({entry["test"].text(), entry["feature"].text(), entry["projected"].number(),
                          entry["z_base"].number(), entry["z_extension"].number()});
  for (const Value& entry : data.shown["candidates"].items())
    data.candidates.push_back(read_candidate(entry, data.slots.size()));
  for (const Value& id : data.shown["extension"].items()) data.extension.push_back(id.text());
  return data;
}

const ShownCandidate* find_candidate(const ConfrontationData& data, const std::string& id) {
  for (const ShownCandidate& candidate : data.candidates) {
    if (candidate.id == id) return &candidate;
  }
  return nullptr;
}

std::vector<std::string> leading_candidates(const ConfrontationData& data, std::size_t most) {
  std::vector<std::string> ids;
  for (const Value& single : data.verdict["candidates"].items()) ids.push_back(single["id"].text());
  if (ids.empty()) {
    std::vector<ShownCandidate> sorted = data.candidates;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const ShownCandidate& a, const ShownCandidate& b) { return a.explained > b.explained; });
    for (const ShownCandidate& candidate : sorted) {
      if (candidate.explained > 0.0) ids.push_back(candidate.id);
    }
  }
  if (ids.size() > most) ids.resize(most);
  return ids;
}

double explaining_amplitude(const ConfrontationData& data, const ShownCandidate& candidate) {
  std::vector<double> residual;
  for (const ShownSlot& slot : data.slots) residual.push_back(slot.projected);
  const double square = product(candidate.projected, candidate.projected);
  const double amplitude = square > 0.0 ? product(candidate.projected, residual) / square : 0.0;
  return candidate.two_sided ? amplitude : std::max(0.0, amplitude);
}

double cosine(const std::vector<double>& a, const std::vector<double>& b) {
  const double lengths = std::sqrt(product(a, a) * product(b, b));
  return lengths > 0.0 ? product(a, b) / lengths : NAN;
}

}  // namespace asperity::app
