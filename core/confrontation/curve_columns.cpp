#include "core/confrontation/curve_columns.hpp"

namespace asperity {
namespace {

constexpr ColumnKind kCompression[] = {
    {"axial_strain", Quantity::strain, &Curve::path, true, "closure over height, or the strain of the gauge"},
    {"axial_stress", Quantity::stress, &Curve::load, true, "total axial stress, compression positive"},
    {"gauge_axial_strain", Quantity::strain, &Curve::gauge_strain, false, "strain of a gauge beside axial_strain"},
    {"lateral_strain", Quantity::strain, &Curve::lateral_strain, false, "positive outwards"},
    {"acoustic_events", Quantity::count, &Curve::events, false, "cumulative count"},
};
constexpr ColumnKind kDisc[] = {
    {"platen_displacement", Quantity::length, &Curve::path, true, "approach of the platens"},
    {"load", Quantity::line_load, &Curve::load, true, "load over thickness, compression positive"},
    {"acoustic_events", Quantity::count, &Curve::events, false, "cumulative count"},
};
constexpr ColumnKind kJoint[] = {
    {"shear_displacement", Quantity::length, &Curve::path, true, "of the lower half against the upper"},
    {"shear_stress", Quantity::stress, &Curve::load, true, "on the plan area"},
    {"dilation", Quantity::length, &Curve::dilation_mm, false, "mean rise of the upper half"},
    {"dilation_front", Quantity::length, &Curve::dilation_front_mm, false, "rise of the end the lower half moves to"},
    {"dilation_rear", Quantity::length, &Curve::dilation_rear_mm, false, "rise of the other end"},
    {"acoustic_events", Quantity::count, &Curve::events, false, "cumulative count"},
};

}  // namespace

std::span<const ColumnKind> curve_columns(ExperimentType experiment) {
  switch (experiment) {
    case ExperimentType::brazilian:
      return kDisc;
    case ExperimentType::direct_shear:
      return kJoint;
    case ExperimentType::uniaxial:
    case ExperimentType::triaxial:
      break;
  }
  return kCompression;
}

}  // namespace asperity
