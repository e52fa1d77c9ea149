#include "core/experiment/crack_entries.hpp"

#include "core/measurement/crack_pattern.hpp"
#include "core/measurement/crack_stresses.hpp"
#include "core/measurement/event_magnitudes.hpp"
#include "core/measurement/fragment_sizes.hpp"
#include "core/measurement/fragments.hpp"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

/// Mean of cos 2 theta from the loading axis of the cracks of one mode; null without a crack.
Json order_parameter(const CrackPattern& pattern, BreakMode mode) {
  const CrackPattern chosen = select(pattern, [&](const CrackLine& line) { return line.mode == mode; });
  return chosen.empty() ? Json() : Json(axial_statistics(chosen).order_parameter);
}

void add_fragments(const Model& model, Json& j) {
  const std::vector<double> areas = find_fragments(model.system.contacts, model.system.particles).area_mm2;
  double area = 0.0;
  for (const double a : areas) area += a;
  j["fragments"] = areas.size();
  j["largest_fragment_share"] = areas.front() / area;
  j["fragment_d50_mm"] = passing_size(areas, 0.5);
  j["fragment_d80_mm"] = passing_size(areas, 0.8);
}

void add_events(const Model& model, Json& j) {
  std::vector<double> energies;
  for (const AcousticEvent& event : group_events(run_cracks(model), model.config))
    energies.push_back(event.energy_n_mm);
  const auto statistics = magnitude_statistics(event_magnitudes(energies));
  j["acoustic_events"] = energies.size();
  j["completeness_magnitude"] = statistics ? Json(statistics->completeness) : Json();
  j["events_above_completeness"] = statistics ? statistics->complete : 0;
  j["b_value"] = statistics ? or_null(statistics->b) : Json();
  j["b_value_error"] = statistics ? or_null(statistics->error) : Json();
}

}  // namespace

std::vector<Crack> run_cracks(const Model& model) {
  std::vector<Crack> cracks = list_cracks(model.system.contacts, model.system.particles);
  for (Crack& crack : cracks) crack.energy_n_mm *= strip_thickness(model.config);
  return cracks;
}

Json crack_entries(const Model& model, const Sample& last) {
  Json j{{"tension", last.cracks_tension}, {"shear", last.cracks_shear}, {"softening", last.contacts_softening}};
  add_fragments(model, j);
  const CrackPattern pattern = crack_pattern(model.system.contacts, model.system.particles, last.time_s);
  j["tension_order_parameter"] = order_parameter(pattern, BreakMode::tension);
  j["shear_order_parameter"] = order_parameter(pattern, BreakMode::shear);
  add_events(model, j);
  return j;
}

void add_crack_stresses(const Model& model, const RunState& state, const Peak& peak, Json& results) {
  std::vector<double> path, stress, axial, lateral;
  for (const Sample& s : state.samples) {
    path.push_back(s.closure_mm);
    stress.push_back(s.stress_mpa);
    axial.push_back(s.gauge_axial_strain);
    lateral.push_back(s.lateral_strain);
  }
  const auto found =
      crack_stresses({path, {stress, axial, lateral}}, peak.index, elastic_window(model.config, peak.stress_mpa),
                     model.config.experiment.confining_pressure_mpa);
  results["crack_initiation_stress_mpa"] = found ? or_null(found->initiation_mpa) : Json();
  results["crack_damage_stress_mpa"] = found ? or_null(found->damage_mpa) : Json();
}

}  // namespace asperity
