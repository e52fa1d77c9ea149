#pragma once
#include "core/integrator/system.hpp"

/// Motion of the rigid bodies about the specimen: blocks, and platens that a drive line pulls or that turn. Internal to
/// core/integrator.
namespace asperity {

/// Velocities of all bodies half a step ahead under what their nodes found in the last sums; a block's nodes get its
/// velocity. Serial, in fixed order.
void move_bodies(System& system);

/// Positions of bodies and drive lines one step ahead.
void advance_bodies(System& system);

/// Work of the platens on the specimen over half a step at the velocities of the last step, Eq. (I7).
double platen_work(const System& system);

}  // namespace asperity
