#include "core/measurement/feature_parts.hpp"

namespace asperity {

using namespace feature_limits;
using namespace feature_parts;

namespace {

std::string no_events(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return why;
  return shape.first.events.empty() ? "acoustic_events was not recorded" : "";
}

/// Events before the load first reaches a share of the peak, over those at the peak; Eq. (F22).
FeatureValue share_at(const CurveShape& shape, double share) {
  const FeatureValue all = events_at_peak(shape);
  if (!all.value) return all;
  if (*all.value <= 0.0) return absent("no event before the peak");
  const auto there = find_crossing(shape.branch, share * shape.peak, Direction::rising, 0, shape.peak_row + 1);
  if (!there) return absent("the load does not reach the share before the peak");
  const std::vector<double>& events = shape.first.events;
  const double before = there->row > 0 ? events[there->row - 1] : 0.0;
  return {(before + there->share * (events[there->row] - before)) / *all.value, ""};
}

}  // namespace

FeatureValue events_at_peak(const CurveShape& shape) {
  const std::string why = no_events(shape);
  if (!why.empty()) return {std::nullopt, why};
  return {shape.first.events[shape.peak_row], ""};
}

FeatureValue event_share_at_half(const CurveShape& shape) { return share_at(shape, 0.5); }
FeatureValue event_share_at_four_fifths(const CurveShape& shape) { return share_at(shape, 0.8); }

FeatureValue event_onset(const CurveShape& shape) {
  const FeatureValue all = events_at_peak(shape);
  if (!all.value) return all;
  if (*all.value <= 0.0) return absent("no event before the peak");
  std::size_t row = 0;
  while (shape.first.events[row] < kEventOnset * *all.value) ++row;
  return {shape.branch.smooth_load[row] / shape.peak, ""};
}

}  // namespace asperity
