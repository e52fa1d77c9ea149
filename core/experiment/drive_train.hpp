#pragma once
#include "core/experiment/model.hpp"

/// What lies between the drive and the specimen: compliance of the frame and seating, Eqs. (E20), (E21).
namespace asperity {

/// Gives the platens, or the driven block, their lines where the configuration asks for any. Call once the time step
/// stands: a body that it could not follow is made heavier.
void make_drive_lines(Model& model);

/// From now on the drive moves the bodies through their lines, which begin unstretched under what the bodies bear.
/// Nothing where there are none.
void tie_drive(System& system);

inline bool is_tied(const System& system) { return system.lines[0].tied != 0; }

/// Sets the drive's velocity for the coming step: the rate (mm/s) at which platens approach...
void set_closing_rate(System& system, double rate);

/// ...or at which the lower half is driven along x.
void set_shear_rate(System& system, double rate);

/// Displacement of the drive since it was tied, mm.
double drive_displacement(const System& system);

/// The specimen's part in its own and the lines' compliance at the first load: the platens' share in the closing rate
/// when a test begins in motion. 1 without lines.
double specimen_share(const Model& model);

}  // namespace asperity
