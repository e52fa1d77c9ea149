#pragma once
#include <optional>
#include <string>

#include "core/measurement/curve_shape.hpp"

/// What is read off one curve, each a function of its shape alone. Loads in the curve's unit, paths in its path's.
namespace asperity {

/// A value, or why there is none.
struct FeatureValue {
  std::optional<double> value;
  std::string absent;  ///< One clause; empty where there is a value.
};

/// Stated shares and windows of the features, fractions of the peak load unless said otherwise.
namespace feature_limits {
inline constexpr double kInitialLow = 0.05, kInitialHigh = 0.2;  ///< Initial stiffness.
inline constexpr double kLateLow = 0.55, kLateHigh = 0.85;       ///< Late stiffness.
inline constexpr double kToeLoad = 0.02;                         ///< The toe's travel is read here.
inline constexpr double kLeastToe = 0.01;                        ///< Over the path to the peak: less is no toe.
inline constexpr double kStiffnessLost = 0.1;  ///< Share of the secant stiffness whose loss ends the linear part.
inline constexpr double kFallBegins = 0.95;
inline constexpr double kDropSpan = 0.2;  ///< Over the path from toe to peak.
inline constexpr double kSofteningHigh = 0.9, kSofteningLow = 0.5;
inline constexpr double kLateShare = 0.25;  ///< Last share of the path, of which the residual is the mean.
inline constexpr double kSteady = 0.2;      ///< The residual's line falls by less than this over it.
inline constexpr double kDropShare = 0.1;   ///< A fall by this share is a drop.
inline constexpr double kRateShare = 0.3;   ///< Share of the peak's displacement from which dilation rates count.
inline constexpr double kEventOnset = 0.1;  ///< Share of the events at the peak.
}  // namespace feature_limits

// Peak: Eq. (F4).
FeatureValue largest_load(const CurveShape& shape);
FeatureValue peak_load(const CurveShape& shape);           ///< Total.
FeatureValue peak_path(const CurveShape& shape);           ///< As recorded.
FeatureValue peak_path_from_toe(const CurveShape& shape);  ///< Eq. (F6).
FeatureValue splitting_strength(const CurveShape& shape);  ///< Eq. (M7).
FeatureValue first_drop_stress(const CurveShape& shape);   ///< Eq. (M28).

// Loading: Eqs. (F5)-(F11).
FeatureValue window_stiffness(const CurveShape& shape);
FeatureValue initial_stiffness(const CurveShape& shape);
FeatureValue late_stiffness_ratio(const CurveShape& shape);
FeatureValue toe_offset(const CurveShape& shape);
FeatureValue toe_travel(const CurveShape& shape);
FeatureValue toe_extent(const CurveShape& shape);
FeatureValue nonlinearity_load(const CurveShape& shape);  ///< Total.

// Compression's gauges: Eqs. (M4)-(M6), (F12)-(F14).
FeatureValue gauge_modulus(const CurveShape& shape);  ///< GPa
FeatureValue gauge_ratio(const CurveShape& shape);
FeatureValue lateral_ratio(const CurveShape& shape);       ///< Of lateral strain to path in the modulus window.
FeatureValue late_lateral_ratio(const CurveShape& shape);  ///< In the late window.
FeatureValue peak_lateral_strain(const CurveShape& shape);
FeatureValue lateral_nonlinearity_load(const CurveShape& shape);  ///< Total.

// Behind the peak: Eqs. (F15)-(F17).
FeatureValue drop_share(const CurveShape& shape);
FeatureValue softening_path(const CurveShape& shape);
FeatureValue residual_load(const CurveShape& shape);  ///< Total.

// Drops: Eq. (F18).
FeatureValue drop_count(const CurveShape& shape);
FeatureValue largest_drop(const CurveShape& shape);
FeatureValue rise_after_drop(const CurveShape& shape);

// Dilation of a joint: Eqs. (F19)-(F21).
FeatureValue peak_dilation(const CurveShape& shape);
FeatureValue end_dilation(const CurveShape& shape);
FeatureValue dilation_rate_before_peak(const CurveShape& shape);
FeatureValue dilation_rate_after_peak(const CurveShape& shape);
FeatureValue dilation_difference_at_peak(const CurveShape& shape);
FeatureValue dilation_difference_rate(const CurveShape& shape);

// Acoustic events: Eq. (F22).
FeatureValue events_at_peak(const CurveShape& shape);
FeatureValue event_share_at_half(const CurveShape& shape);
FeatureValue event_share_at_four_fifths(const CurveShape& shape);
FeatureValue event_onset(const CurveShape& shape);

// Loops: Eqs. (F1), (F23)-(F25).
FeatureValue loop_count(const CurveShape& shape);
FeatureValue unloading_stiffness(const CurveShape& shape);
FeatureValue reloading_stiffness(const CurveShape& shape);
FeatureValue reload_toe_travel(const CurveShape& shape);
FeatureValue permanent_path(const CurveShape& shape);

}  // namespace asperity
