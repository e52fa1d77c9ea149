#pragma once
#include <cstdint>
#include <vector>

#include "core/config/run_config.hpp"
#include "core/geometry/joint_profile.hpp"
#include "core/geometry/mesh.hpp"

namespace asperity {

/// Where a triangle of a joint lies.
enum class JointZone : std::uint8_t { lower_elastic, lower_particles, upper_particles, upper_elastic };

/// The two halves of a joint, closed upon each other: separate components of one mesh, whose vertices along the joint
/// stand twice at exactly the same places. The lower half spans -lower_height_mm to the profile, the upper one the
/// profile to upper_height_mm, both 0 to the profile's length.
struct JointMesh {
  Mesh mesh;
  std::vector<JointZone> zone;  ///< Of each triangle.
  JointProfile profile;
};

/// Particle zones hold irregular triangles of mean edge particles.edge_mm, each a grain of its own; the elastic rest of
/// each half is one grain of triangles that grow from there to coarse_edge_mm, Eq. (G12). Triangles with an edge on a
/// zone's outer border belong to the elastic grain: contacts in one line would be a plane of weakness that no rock has.
/// With breakable false the mesh is the same, but all of a half is its elastic grain. Depends on the configurations
/// alone: the same seed gives the same bytes. Throws Error(config) with all of joint_faults; Error(numerical) naming
/// seed and figures where the asked quality (mean within 3 %, 25 degrees in particles and 20 in the rest, sharper
/// corners of the outline aside) is out of reach.
JointMesh make_joint_mesh(const JointConfig& joint, const ParticleConfig& particles);

}  // namespace asperity
