#pragma once
#include <vector>

#include "core/integrator/system.hpp"

namespace asperity {

/// Radius about the disc's centre over its diameter within which the centre's stress is averaged.
inline constexpr double kCentreRadius = 0.1;

/// A node of the rim with the half of a rim edge that it stands for.
struct RimEnd {
  int node = 0;
  double length_mm = 0;
};

/// What is read off a Brazilian disc beside the platens' reactions, found on the disc at rest; Eqs. (M14), (M15).
struct DiscGauge {
  std::vector<int> centre;  ///< Triangles whose centroid lies within kCentreRadius diameters of the centre.
  std::vector<RimEnd> rim;
  double diameter_mm = 0;  ///< 0: no disc.
};

/// Stresses in MPa; NaN where no triangle lies at the centre.
struct DiscReading {
  double centre_tension_mpa = 0;      ///< Mean horizontal stress at the centre, tension positive.
  double centre_compression_mpa = 0;  ///< Mean vertical stress at the centre, compression positive.
  double contact_half_angle_deg = 0;  ///< Half the angle under which a platen's contact is seen, mean of both platens.
};

/// The gauge of a disc that stands on y = 0, its centre at x = 0.
DiscGauge make_disc_gauge(const BondedContacts& contacts, const Particles& particles, double diameter_mm);

/// Zero where there is no disc.
DiscReading read_disc_gauge(const DiscGauge& gauge, const System& system);

}  // namespace asperity
