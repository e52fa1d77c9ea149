#include "core/experiment/failure_entries.hpp"

#include <algorithm>

#include "core/measurement/failure_mode.hpp"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

Json crack_entries(const CrackTotals& cracks, const AxialStatistics& orientation) {
  return {{"tension_cracks", cracks.tension},
          {"shear_cracks", cracks.shear},
          {"crack_length_mm", cracks.length_mm},
          {"tension_share_of_length", cracks.tension_share},
          {"order_parameter", orientation.order_parameter},
          {"mean_orientation_deg", orientation.mean_deg},
          {"orientation_resultant", orientation.resultant},
          {"mean_deviation_from_load_deg", orientation.mean_deviation_deg}};
}

void add_disc_entries(Json& j, const DiscFailure& failure, double diameter_mm) {
  j.update(crack_entries(failure.cracks, failure.orientation));
  j["tension_share_in_central_band"] = failure.tension_in_central_band;
  j["crack_share_near_platens"] = failure.near_platens;
  j["splits"] = failure.splits();
  j["split_length_over_diameter"] = failure.splits() ? Json(total_length(failure.path) / diameter_mm) : Json();
  j["split_tension_share"] = failure.path_tension_share();
  j["split_offset_over_diameter"] = failure.path_offset_mm() / diameter_mm;
}

void add_compression_entries(Json& j, const CompressionFailure& failure) {
  j.update(crack_entries(failure.cracks, failure.orientation));
  j["cluster_share_of_length"] = failure.cluster_share;
  j["cluster_angle_deg"] = failure.cluster.angle_deg;
  j["cluster_elongation"] = failure.cluster.elongation;
  j["cluster_width_share"] = failure.cluster_width_share;
  j["cluster_height_share"] = failure.cluster_height_share;
  j["cluster_spans_width"] = failure.spans_width();
  j["cluster_spans_height"] = failure.spans_height();
  j["band_angle_deg"] = failure.bands.angle_deg[0];
  j["band_share_of_length"] = failure.bands.share[0];
  j["second_band_angle_deg"] = failure.bands.angle_deg[1];
  j["second_band_share_of_length"] = failure.bands.share[1];
  j["band_concentration"] = failure.bands.concentration;
  j["band_significance"] = failure.bands.significance;
}

/// What had broken at a sample.
Json failure_at(const Model& model, const Sample& sample) {
  const System& system = model.system;
  const ExperimentConfig& e = model.config.experiment;
  const CrackPattern pattern = crack_pattern(system.contacts, system.particles, sample.time_s);
  Json j{{"verdict", ""}, {"time_s", sample.time_s}, {"axial_strain", sample.axial_strain}};
  if (e.type == ExperimentType::brazilian) {
    const DiscFailure failure = disc_failure(pattern, e.diameter_mm);
    j["verdict"] = failure.verdict();
    add_disc_entries(j, failure, e.diameter_mm);
  } else {
    const CompressionFailure failure = compression_failure(pattern, e.width_mm, e.height_mm);
    j["verdict"] = failure.verdict();
    add_compression_entries(j, failure);
  }
  const FragmentShares shares = fragment_shares(find_fragments(system.contacts, system.particles, sample.time_s));
  j["largest_fragment_share"] = shares.largest;
  j["second_fragment_share"] = shares.second;
  return j;
}

}  // namespace

const Sample* half_peak_sample(const std::vector<Sample>& samples, const Peak& peak, double confining_pressure_mpa) {
  const double half = confining_pressure_mpa + 0.5 * (peak.stress_mpa - confining_pressure_mpa);
  const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(peak.index);
  const auto found = std::find_if(begin, samples.end(), [&](const Sample& s) { return s.stress_mpa <= half; });
  return found == samples.end() ? nullptr : &*found;
}

Json failure_entries(const Model& model, const RunState& state, const Peak& peak) {
  const Sample* half = half_peak_sample(state.samples, peak, model.config.experiment.confining_pressure_mpa);
  return {{"at_half_peak", half ? failure_at(model, *half) : Json()},
          {"at_end", failure_at(model, state.samples.back())}};
}

}  // namespace asperity
