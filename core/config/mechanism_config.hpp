#pragma once
#include <limits>
#include <map>
#include <optional>
#include <string>

/// What a run's mechanisms are, and what they add to the base model: plain data. The library of mechanisms lies in
/// core/mechanism; a JSON file names them under "mechanisms".
namespace asperity {

/// One entry of "mechanisms": its type and the numbers the user gave.
struct MechanismConfig {
  std::string type;
  std::optional<double> amplitude;           ///< 0: the base model, 1: the declared strong value; unset: 1.
  std::map<std::string, double> parameters;  ///< By key; what is not given follows from the amplitude.
  bool operator==(const MechanismConfig&) const = default;
};

/// How the friction of a kind of surface falls with the way it has slid; core/contact README, Eqs. C55, C56.
struct FrictionWear {
  double residual_share = 1.0;        ///< Of tan(phi) that is left in the end; 1: none.
  double slip_mm = 1.0;               ///< Of the exponential.
  double reference_stress_mpa = 0.0;  ///< Slip counts in proportion to the normal stress over this one; 0: by itself.
  bool operator==(const FrictionWear&) const = default;
};

/// What mechanisms add to the base model, which has the values below. No JSON key stands for any of them: mechanisms
/// alone set them, before a model is built.
struct ModelExtensions {
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  std::optional<double> peak_friction_angle_deg;  ///< Of the intact contact's shear strength; unset: phi_c.
  double envelope_exponent = 1.0;                 ///< Of the shear strength over pressure; 1: straight.
  double closure_stiffness_ratio = 1.0;           ///< Contact's normal stiffness at first closing over k_t.
  double closure_length_mm = 0.0;                 ///< Closing after which it has risen.
  FrictionWear fracture_wear, outline_wear;
  double frame_stiffness_n_per_mm = kNone;  ///< Between drive and platens, or drive and shear box.
  double seating_mm = 0.0;                  ///< Closing of the seats under a load without bound.
  double seating_stress_mpa = 1.0;          ///< At which half of it has closed.
  double tilt_deg = 0.0;                    ///< Of the upper platen, fixed.
  std::optional<double> hinge_offset_mm;  ///< The upper platen turns about a hinge so far from the axis; unset: fixed.
  double mismatch_mm = 0.0;               ///< The upper half is shifted so far along the joint.
  int strips = 1;                         ///< Out of plane, each with its own mesh.
  double normal_stiffness_mpa_per_mm = 0.0;        ///< Of a spring above the upper half, per plan area of the joint.
  double rotation_stiffness_n_mm_per_rad = kNone;  ///< Against the upper half's turning, per mm of thickness.
  double yield_stress_mpa = kNone;  ///< Of the particles: largest difference of in-plane principal stresses.
  bool operator==(const ModelExtensions&) const = default;
};

}  // namespace asperity
