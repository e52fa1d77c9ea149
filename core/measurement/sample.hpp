#pragma once
#include "core/measurement/disc_gauge.hpp"
#include "core/measurement/joint_gauge.hpp"

namespace asperity {

/// One row of curves.csv and energy.csv. Stresses compression positive, strains shortening (axial) and widening
/// (lateral) positive, energies N mm of the whole thickness.
struct Sample {
  double time_s = 0;
  double closure_mm = 0;                             ///< Approach of the platens since the hydrostatic state.
  double axial_strain = 0;                           ///< Closure over height or diameter.
  double gauge_axial_strain = 0;                     ///< Compression: between two bands on the specimen.
  double lateral_strain = 0;                         ///< Compression: of the flanks at mid-height.
  double stress_mpa = 0;                             ///< Axial stress (total), or 2 P / (pi D t) for the disc.
  double load_n_per_mm = 0;                          ///< Mean of both platens, per mm of thickness.
  double reaction_bottom_n = 0, reaction_top_n = 0;  ///< Means over the sample's steps.
  double confining_pressure_mpa = 0;
  DiscReading disc;    ///< Of a disc, at the sample's last step.
  JointReading joint;  ///< Of a joint.
  int cracks_tension = 0, cracks_shear = 0, contacts_softening = 0;
  EnergyBalance energy;
};

}  // namespace asperity
