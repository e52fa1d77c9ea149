#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/base/vec2.hpp"

namespace asperity {

/// State of a contact edge in the crack network. The numbers are those of the VTU array `mode`.
enum class CrackMode : int { softening = 0, tension = 1, shear = 2, defect = 3 };

/// One softening or broken contact edge, or one open before the test, in its present position (mm), midway between the two particles.
struct CrackSegment {
  Vec2 a, b;
  CrackMode mode = CrackMode::softening;
  double damage = 0;         ///< Eq 5, 0 to 1, mean of the edge's two contact points.
  double opening_mm = 0;     ///< Mean normal separation.
  double slip_mm = 0;        ///< Mean shear displacement.
  double break_time_s = -1;  ///< -1 while it only softens.
  double energy_n_mm = 0;    ///< Fracture energy spent on it.
};

/// How the two particles of a contact hold together. The numbers are those of the VTU array `kind`.
enum class ContactKind : int {
  bonded = 0,   ///< The bond is not broken.
  broken = 1,   ///< Broken; the two still touch as the pair they were.
  general = 2,  ///< Never bonded to one another: found by the search for new contacts.
};

/// The force between two particles, in N for the specimen's thickness.
struct ContactForce {
  Vec2 a, b;            ///< Present centroids of the two particles, mm.
  Vec2 point;           ///< Where they touch, mm.
  double normal_n = 0;  ///< Normal force, compression positive; tension (negative) in bonded contacts alone.
  double shear_n = 0;   ///< Magnitude of the shear force.
  ContactKind kind = ContactKind::bonded;
};

/// The measured curve up to an instant; stresses compression positive, strains shortening positive.
struct CurveHistory {
  std::vector<double> axial_strain, lateral_strain, stress_mpa;
};

/// The arcs of curved jaws; their apexes are the platens' y.
struct FrameJaws {
  double radius_mm = 0;  ///< 0: flat platens.
  double centre_x_mm = 0, half_width_mm = 0;
  bool operator==(const FrameJaws&) const = default;
};

/// Where the two halves of a joint stand.
struct FrameJoint {
  double length_mm = 0;    ///< 0: no joint.
  double rise_mm = 0;      ///< Height of the profile: the most that intact halves can dilate.
  double range_mm = 0;     ///< Shear displacement at which the test ends.
  double shear_mm = 0;     ///< Of the lower block; behind a compliant drive less than in curves.csv.
  double dilation_mm = 0;  ///< As in curves.csv.
  double lift_mm = 0;      ///< Of the upper block since the start: dilation and what the normal load did.
  int strips = 1;          ///< Stacked along y.
  double pitch_mm = 0;     ///< From one strip to the next.
  bool operator==(const FrameJoint&) const = default;
};

/// Everything a picture or a VTU file shows of one instant. Positions mm, velocities mm/s, stresses MPa (tension
/// positive).
struct Frame {
  int index = 0;
  double time_s = 0;
  std::string experiment;   ///< "brazilian", "uniaxial", "triaxial", "direct_shear".
  std::string name;         ///< The config's name.
  double axial_strain = 0;  ///< As in curves.csv; of a joint: shear displacement over its length.
  double stress_mpa = 0;    ///< Axial stress, 2P/(pi D t) for the disc (compression positive), or shear stress.
  double confining_pressure_mpa = 0;
  std::vector<Vec2> position, displacement, velocity;  ///< Per node; every particle owns its nodes.
  std::vector<std::array<int, 3>> triangles;           ///< Node indices.
  std::vector<std::array<double, 4>> stress;           ///< Per triangle: xx, yy, zz, xy.
  std::vector<double> damage;                          ///< Per triangle: mean of its contacts' damage.
  std::vector<int> grain, fragment;                    ///< Per triangle; fragment 0 is the largest by area.
  std::vector<CrackSegment> cracks;
  std::vector<ContactForce> contacts;    ///< Those that carry force.
  std::array<double, 2> platen_y{0, 0};  ///< Bottom and top platen.
  FrameJaws jaws;
  FrameJoint joint;
  std::vector<int> half;  ///< Per triangle of a joint: 0 lower, 1 upper; empty otherwise.
  CurveHistory curve;
};

}  // namespace asperity
