#include "core/experiment/summarise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/config/mechanism_declaration.hpp"
#include "core/experiment/crack_entries.hpp"
#include "core/experiment/failure_entries.hpp"
#include "core/experiment/joint_results.hpp"
#include "core/measurement/capture.hpp"
#include "core/measurement/results.hpp"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kClosureLimit = 1e-3;

bool compression(const Model& model) { return is_compression(model.config.experiment.type); }
bool sheared(const Model& model) { return model.config.experiment.type == ExperimentType::direct_shear; }

/// What was added to the base model, with every parameter's value; entries that are off are none.
Json mechanism_entries(const RunConfig& config) {
  Json entries = Json::array();
  for (const MechanismConfig& entry : config.mechanisms) {
    if (is_off(entry)) continue;
    Json j = {{"type", entry.type}};
    for (const auto& [key, value] : mechanism_values(*find_mechanism(entry.type), entry)) j[key] = value;
    entries.push_back(std::move(j));
  }
  return entries;
}

Json experiment_entries(const Model& model, const RunState& state) {
  const ExperimentConfig& e = model.config.experiment;
  Json j;
  j["type"] = experiment_name(e.type);
  j["plane"] = e.plane == PlaneCondition::stress ? "stress" : "strain";
  if (compression(model)) {
    j["width_mm"] = e.width_mm;
    j["height_mm"] = e.height_mm;
  } else if (sheared(model)) {
    j["joint_length_mm"] = model.joint.profile.length();
    j["teeth"] = model.joint.profile.teeth.size();
    j["breakable"] = model.config.joint.breakable;
    if (model.config.extensions.strips > 1) j["strips"] = model.config.extensions.strips;
  } else {
    j["diameter_mm"] = e.diameter_mm;
  }
  if (Json entries = mechanism_entries(model.config); !entries.empty()) j["mechanisms"] = std::move(entries);
  j["triangles"] = model.mesh.triangles.size();
  j["contacts"] = model.system.contacts.size();
  j["time_step_s"] = model.system.time_step;
  j["critical_time_step_s"] = model.critical_time_step;
  j["added_mass_fraction"] = model.added_mass_fraction;
  if (e.loading.elastic_start_fraction > 0.0) {
    const double rate = e.loading.closing_rate_mm_per_s;
    j["elastic_start_closure_mm"] = state.loading.elastic_start_closure_mm;
    j["elastic_start_steps_saved"] =
        std::llround(state.loading.elastic_start_closure_mm / rate / model.system.time_step);
  }
  j["stopped"] = describe(state.stop);
  return j;
}

Json compression_results(const Model& model, const RunState& state, const Peak& peak) {
  Json j;
  const auto moduli = fit_moduli(state.samples, peak, model.config);
  j["youngs_modulus_gpa"] = moduli ? Json(moduli->youngs_modulus_gpa) : Json();
  j["poissons_ratio"] = moduli ? Json(moduli->poissons_ratio) : Json();
  j["peak_axial_stress_mpa"] = peak.stress_mpa;
  j["peak_axial_strain"] = peak.axial_strain;
  j["peak_passed"] = !peak.at_end;
  j["confining_pressure_mpa"] = model.config.experiment.confining_pressure_mpa;
  add_crack_stresses(model, state, peak, j);
  return j;
}

Json brazilian_results(const Model& model, const RunState& state, const Peak& peak) {
  const Sample& s = state.samples[peak.index];
  const auto drop = first_drop(state.samples, model.config.measurement.peak_strain_limit);
  return {{"tensile_strength_mpa", peak.stress_mpa},
          {"peak_load_n_per_mm", s.load_n_per_mm},
          {"peak_closure_mm", s.closure_mm},
          {"peak_passed", !peak.at_end},
          {"first_drop_stress_mpa", drop ? Json(*drop) : Json()},
          {"centre_tension_at_peak_mpa", s.disc.centre_tension_mpa},
          {"centre_compression_at_peak_mpa", s.disc.centre_compression_mpa},
          {"contact_half_angle_at_peak_deg", s.disc.contact_half_angle_deg}};
}

Json results_of(const Model& model, const RunState& state, const Peak& peak) {
  if (sheared(model)) return joint_results(model, state, peak);
  return compression(model) ? compression_results(model, state, peak) : brazilian_results(model, state, peak);
}

Json energy_entries(const EnergyBalance& e) {
  return {{"external_work_n_mm", e.external_work},
          {"elastic_n_mm", e.elastic},
          {"recoverable_contacts_n_mm", e.recoverable},
          {"fracture_n_mm", e.fracture},
          {"friction_n_mm", e.friction},
          {"damping_n_mm", e.damping},
          {"kinetic_n_mm", e.kinetic},
          {"plasticity_n_mm", e.plasticity},
          {"created_by_law_n_mm", e.created_by_law},
          {"relative_closure_error", relative_closure_error(e)}};
}

/// General contacts alive at the end, and the deepest overlap of the whole run.
Json contact_entries(const Model& model) {
  const GeneralContacts& general = model.system.general;
  return {{"general_contacts", general.touches.size()},
          {"broken_contacts_with_own_pair", general.handing_over.size()},
          {"largest_overlap_mm", general.largest_depth},
          {"largest_overlap_over_edge", general.largest_depth / model.config.particles.edge_mm},
          {"largest_overlap_handing_over_mm", general.largest_depth_handing_over},
          {"largest_seat_mm", general.largest_seat},
          {"searches", general.searches}};
}

/// Largest kinetic over stored energy between a tenth of the peak and the peak itself: how quasi-static the loading
/// was.
double loading_kinetic_ratio(const RunState& state, const Peak& peak) {
  double largest = 0.0;
  for (std::size_t i = 0; i <= peak.index; ++i) {
    const Sample& s = state.samples[i];
    const double stored = s.energy.elastic + s.energy.recoverable;
    if (s.stress_mpa > 0.1 * peak.stress_mpa && stored > 0.0) largest = std::max(largest, s.energy.kinetic / stored);
  }
  return largest;
}

std::vector<std::string> find_warnings(const Model& model, const RunState& state, const Peak& peak) {
  std::vector<std::string> warnings;
  const EnergyBalance& e = state.samples.back().energy;
  const bool literal = model.config.contacts.law.reading == LawReading::literal;
  if (literal) {
    warnings.push_back(fmt::format(
        "the literal contact law itself added {:.4g} N mm to the model, {:.3g} % of the external work; it has "
        "no energy potential (the default law has)",
        e.created_by_law, 100.0 * e.created_by_law / e.external_work));
  } else if (relative_closure_error(e) > kClosureLimit) {
    warnings.push_back(fmt::format("the energy account is open by {:.3g} % of the external work (limit {:.3g} %)",
                                   100.0 * relative_closure_error(e), 100.0 * kClosureLimit));
  }
  if (peak.at_end) {
    warnings.push_back(sheared(model) ? "no peak was passed: the largest shear stress stands at the end"
                                      : fmt::format("no peak was passed: the largest stress stands at the end of the "
                                                    "range searched (axial strain {:.4g}); "
                                                    "the strength is a lower bound",
                                                    peak.axial_strain));
  }
  const double ratio = loading_kinetic_ratio(state, peak);
  if (ratio > kQuasiStaticKineticShare) {
    warnings.push_back(fmt::format(
        "kinetic energy reached {:.3g} of the stored energy before the peak (limit {:.3g}): load more slowly", ratio,
        kQuasiStaticKineticShare));
  }
  const double mass_bound = model.config.integration.mass_scaling.added_mass_bound;
  if (model.added_mass_fraction > mass_bound) {
    warnings.push_back(fmt::format("mass scaling added {:.3g} % to the specimen's mass (limit {:.3g} %)",
                                   100.0 * model.added_mass_fraction, 100.0 * mass_bound));
  }
  return warnings;
}

}  // namespace

double relative_closure_error(const EnergyBalance& energy) {
  return energy.external_work != 0.0 ? std::abs(energy.error() / energy.external_work) : 0.0;
}

std::string describe(StopReason reason) {
  switch (reason) {
    case StopReason::running:
      return "running";
    case StopReason::strain:
      return "reached the stop strain";
    case StopReason::fraction_of_peak:
      return "fell below the stop fraction of the peak";
    case StopReason::time:
      return "reached the stop time";
    case StopReason::shear_displacement:
      return "reached the stop shear displacement";
    case StopReason::interrupted:
      return "interrupted";
  }
  return "";
}

Summary summarise(const Model& model, const RunState& state) {
  const Peak peak = find_peak(state.samples, peak_limit(model.config));
  Summary summary;
  summary.experiment = experiment_entries(model, state);
  summary.results = results_of(model, state, peak);
  summary.energy = energy_entries(state.samples.back().energy);
  summary.energy["kinetic_over_stored_before_peak"] = loading_kinetic_ratio(state, peak);
  summary.cracks = crack_entries(model, state.samples.back());
  summary.failure_mode = sheared(model) ? tooth_entries(model, state) : failure_entries(model, state, peak);
  summary.contacts = contact_entries(model);
  summary.warnings = find_warnings(model, state, peak);
  return summary;
}

}  // namespace asperity
