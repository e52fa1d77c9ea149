#pragma once
#include "core/config/run_config.hpp"

/// Closed-form estimates that the cross checks need before there is a mesh. The contact folder, which stands to the
/// right, has the closed forms that runs use.
namespace asperity {

/// k_t in MPa/mm: the one given, or the paper's Eq 12 (plane stress), 13 (plane strain).
double estimated_tensile_stiffness(const RunConfig& config);

/// G_f in N/mm: the one given, or the tensile part of the paper's Eq 34.
double estimated_fracture_energy(const RunConfig& config);

/// Energy under the hardening branch in N/mm, below which delta_ut would come before delta_ct: Eq. (K4).
double hardening_energy(const RunConfig& config);

/// Critical time step in s of equilateral triangles of the mean edge, or the mass scaling's step if that is larger:
/// Eqs. (K1)-(K3). The power iteration on the mesh gives about this (within 2 % for the paper's specimen).
double estimated_critical_step(const RunConfig& config);

/// Area of the specimen in mm2 over that of an equilateral triangle of the mean edge.
double estimated_triangles(const RunConfig& config);

/// The disc's diameter, or the smaller of the compression specimen's width and height, in mm.
double smallest_dimension(const RunConfig& config);

}  // namespace asperity
