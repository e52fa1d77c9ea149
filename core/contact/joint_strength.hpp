#pragma once
#include <limits>
#include <optional>
#include <vector>

/// Closed forms of the shear strength of a saw-tooth rock joint; numbers in brackets are those of
/// core/contact/README.md. Stresses in MPa, angles in degrees, lengths in mm; normal stress is compressive and >= 0.
/// All strengths are shear forces over the joint's plan area. Infinity means "not this way": a joint too steep to
/// slide, or one without teeth to shear.
namespace asperity {

/// A saw-tooth joint and what its rock and its surface resist with.
struct ToothedJoint {
  /// One symmetric tooth; its crest is flat where the base is longer than 2 height / tan(angle).
  struct Tooth {
    double base_mm = 0;    ///< Length along the joint's plane.
    double height_mm = 0;  ///< Of the crest above the plane.
    double angle_deg = 0;  ///< Of both flanks against the plane.
  };
  double length_mm = 0;           ///< Plan length, flat parts included; above 0.
  std::vector<Tooth> teeth;       ///< Empty for a flat joint.
  double joint_friction_deg = 0;  ///< Of the joint's surface, phi_j.
  double cohesion_mpa = 0;        ///< Of the intact rock, C.
  double friction_deg = 0;        ///< Of the intact rock, phi.
};

/// Teeth of one angle, which carry together.
struct ToothGroup {
  double angle_deg = 0;
  double base_mm = 0;    ///< Sum of their bases.
  double crest_deg = 0;  ///< Rise from a tooth's loaded foot to the far end of its crest, the least of the group.
};

enum class JointFailure { sliding, shearing };

/// What one group of teeth bears if it carries the whole normal force.
struct ToothStage {
  ToothGroup group;
  double dilation_slope = 0;   ///< tan i of the flank, while it slides.
  double sliding_mpa = 0;      ///< Eq. (C61)
  double base_shear_mpa = 0;   ///< Eq. (C62)
  double plane_deg = 0;        ///< Of the weakest failure plane against the base, Eq. (C64).
  double plane_shear_mpa = 0;  ///< Eq. (C63) on that plane: never above base_shear_mpa.
  double transition_mpa = 0;   ///< Normal stress at which sliding gives way to shearing, Eq. (C65).
  JointFailure failure = JointFailure::sliding;
  double strength_mpa = 0;  ///< The less of sliding_mpa and plane_shear_mpa.
};

/// What stands for the intact rock in Eq. (C66).
enum class IntactStrength { mohr_coulomb, fairhurst };

/// Constants of Ladanyi & Archambault (1970).
struct LadanyiArchambaultParameters {
  double sheared_exponent = 1.5;                ///< K1
  double dilation_exponent = 4.0;               ///< K2
  std::optional<double> transition_stress_mpa;  ///< sigma_T; the rock's uniaxial strength if not given.
  IntactStrength intact = IntactStrength::mohr_coulomb;
  double tensile_strength_mpa = 0;  ///< For Fairhurst's parabola only; above 0 there.
};

/// Eqs. (C66) to (C68) at one normal stress.
struct LadanyiArchambaultStrength {
  double shear_mpa = 0;
  double sheared_area = 0;    ///< a_s, share of the plan area that is sheared through.
  double dilation_slope = 0;  ///< v
  double intact_mpa = 0;      ///< S_R
};

/// All closed forms of one joint at one normal stress.
struct JointStrength {
  double normal_stress_mpa = 0;
  double uniaxial_strength_mpa = 0;              ///< Eq. (C60)
  JointFailure failure = JointFailure::sliding;  ///< Of the steepest teeth, which are mobilised first.
  double strength_mpa = 0;                       ///< At which they fail.
  std::vector<ToothStage> stages;                ///< Steepest first, Eq. (C71); one of angle 0 for a flat joint.
  double staged_peak_mpa = 0;                    ///< Largest strength of the stages.
  double together_mpa = 0;                       ///< All teeth sheared at once, Eq. (C70).
  LadanyiArchambaultStrength ladanyi_archambault;
  double residual_low_mpa = 0, residual_high_mpa = 0;  ///< Friction on sheared bases, Eq. (C69).
};

/// Shear strength against normal stress, one entry of every column for each normal stress; MPa. For a plot, skip
/// infinite values.
struct StrengthEnvelope {
  std::vector<double> normal_stress, sliding, base_shear, plane_shear, strength, staged_peak, together,
      ladanyi_archambault, residual_low, residual_high;
};

namespace closed_forms {

/// Uniaxial compressive strength of a Mohr-Coulomb rock, Eq. (C60); MPa.
double uniaxial_strength(double cohesion_mpa, double friction_deg);

/// Patton's (1966) sliding up a flank, Eq. (C61); infinite where phi_j + i reaches 90 degrees.
double sliding_strength(double normal_stress_mpa, double joint_friction_deg, double angle_deg);

/// Teeth sheared through at their base, Eq. (C62).
double base_shear_strength(const ToothedJoint& joint, double base_mm, double normal_stress_mpa);

/// Teeth sheared through on planes that rise by plane_deg from the loaded feet of their flanks, Eq. (C63).
double plane_shear_strength(const ToothedJoint& joint, const ToothGroup& group, double plane_deg,
                            double normal_stress_mpa);

/// The plane of least strength between the base and the crest, Eq. (C64); degrees.
double weakest_plane(const ToothedJoint& joint, const ToothGroup& group, double normal_stress_mpa);

/// Normal stress above which the teeth shear rather than slide, Eq. (C65); infinite where they always slide.
double transition_stress(const ToothedJoint& joint, const ToothGroup& group);

/// Ladanyi & Archambault (1970), Eqs. (C66) to (C68), with the steepest teeth's angle as i.
LadanyiArchambaultStrength ladanyi_archambault(const ToothedJoint& joint, double normal_stress_mpa,
                                               const LadanyiArchambaultParameters& parameters = {});

}  // namespace closed_forms

/// Teeth by angle, steepest first; angles within 0.01 degrees are one group, teeth without slope or base none.
std::vector<ToothGroup> tooth_groups(const ToothedJoint& joint);

/// What each group bears alone, steepest first, down to the first that slides, Eq. (C71).
std::vector<ToothStage> tooth_sequence(const ToothedJoint& joint, double normal_stress_mpa);

/// Every closed form at one normal stress.
JointStrength joint_strength(const ToothedJoint& joint, double normal_stress_mpa,
                             const LadanyiArchambaultParameters& parameters = {});

/// Every closed form against normal stress.
StrengthEnvelope strength_envelope(const ToothedJoint& joint, const std::vector<double>& normal_stresses_mpa,
                                   const LadanyiArchambaultParameters& parameters = {});

}  // namespace asperity
