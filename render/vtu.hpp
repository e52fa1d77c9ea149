#pragma once
#include <filesystem>
#include <string>

#include "core/measurement/frame.hpp"

namespace asperity::render {

/// The bytes of a frame's VTU file of particles: appended raw, zlib, UInt64 headers, double points.
std::string fields_vtu(const Frame& frame);

/// The bytes of a frame's VTU file of cracks: one VTK_LINE for each softening or broken contact.
std::string cracks_vtu(const Frame& frame);

/// The bytes of a frame's VTU file of contact forces: one VTK_LINE for each, from particle to particle.
std::string contacts_vtu(const Frame& frame);

/// Fills everything but cracks and contacts. Errors: Error(output) with the path and what is wrong.
void read_fields_vtu(const std::filesystem::path& path, Frame& frame);

/// Fills the cracks. Errors: as read_fields_vtu.
void read_cracks_vtu(const std::filesystem::path& path, Frame& frame);

/// Fills the contacts. Errors: as read_fields_vtu.
void read_contacts_vtu(const std::filesystem::path& path, Frame& frame);

/// In-plane principal stresses of (xx, yy, zz, xy), in its unit, tension positive.
struct PrincipalStress {
  double major = 0, minor = 0;
  double max_shear() const { return 0.5 * (major - minor); }
};
PrincipalStress principal_stress(const std::array<double, 4>& stress);

}  // namespace asperity::render
