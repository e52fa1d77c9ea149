#pragma once
#include "core/config/run_config.hpp"
#include "core/geometry/mesh.hpp"
#include "core/geometry/outline.hpp"

namespace asperity {

/// Width and height in mm; the frame is that of Mesh.
struct Rectangle {
  double width;
  double height;
};

/// Diameter in mm; the frame is that of Mesh.
struct Disc {
  double diameter;
};

Outline outline_of(const Rectangle& rectangle);

/// Two half circles that meet at the poles (0, 0) and (0, diameter), so that a mesh always has a vertex where each
/// platen first touches.
Outline outline_of(const Disc& disc);

Outline outline_of(const ExperimentConfig& experiment);

/// The specimen of an experiment filled with particles of the asked kind. The mesh depends on the two configs alone:
/// the same seed gives the same bytes, another seed another arrangement. Triangles are ordered along a Hilbert curve.
/// Throws Error(numerical) naming seed and figures where the asked quality is out of reach.
Mesh make_mesh(const ExperimentConfig& experiment, const ParticleConfig& particles);

}  // namespace asperity
