#pragma once
#include <algorithm>

#include "core/contact/general_contact.hpp"

/// Forces of one touch: normal, Coulomb and viscous, with what they spend; Eqs. (C43), (C47)-(C50).
namespace asperity {

/// Energies spent in one step (N mm per mm of thickness), and the deepest overlaps (mm), Eq. (C52).
struct StepLosses {
  double friction = 0, damping = 0, deepest = 0, deepest_handing_over = 0, deepest_seat = 0;
  StepLosses& operator+=(const StepLosses& o) {
    friction += o.friction;
    damping += o.damping;
    deepest = std::max(deepest, o.deepest);
    deepest_handing_over = std::max(deepest_handing_over, o.deepest_handing_over);
    deepest_seat = std::max(deepest_seat, o.deepest_seat);
    return *this;
  }
};

/// Everything one touch needs besides its own memory.
struct TouchContext {
  const GeneralContacts& general;
  const Particles& particles;
  double time_step;
};

/// Forces of a touch at the present positions; brings its memory up to date and adds what was spent.
PairForces touch_force(const TouchContext& context, Touch& touch, StepLosses& losses);

/// Books what a touch that ended still held, and what it did over half of the last step.
void end_touch(const TouchContext& context, Touch& touch, StepLosses& losses);

}  // namespace asperity
