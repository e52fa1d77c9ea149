#pragma once
#include "core/integrator/system.hpp"

namespace asperity {

/// Steps between two looks at the outer surface.
inline constexpr std::int64_t kFlankInterval = 64;

/// Brings the loaded edges to the present outer surface once contacts have broken, every kFlankInterval steps; Eqs.
/// (I15), (I16). Pieces that touch neither a platen nor a held piece carry nothing. Call after the contacts' update.
void follow_outer_surface(System& system);

/// Sets the nodes' loads to the pressure on the loaded edges at the present positions, Eq. (I17).
void apply_flank_pressure(System& system);

}  // namespace asperity
