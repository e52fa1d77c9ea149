#pragma once
#include "core/contact/general_contact.hpp"

/// Friction of surfaces that falls with the way they have slid, Eqs. (C55), (C56).
namespace asperity {

/// Whether any kind of surface wears.
bool wears(const GeneralContactLaw& law);

/// tan(phi) of a surface that has worn so far (mm), Eq. (C55).
double worn_friction(const SurfaceLaw& law, double wear);

/// What a surface wears (mm) as it slides so far (mm) under a normal force on a length of contact; Eq. (C56). `normal`
/// (N per mm of thickness) is that of one entry: the other triangle's edge carries as much.
double wear_of_slip(const FrictionWear& wear, double slip, double normal, double length);

/// Adds what each edge has worn in the last update: the mean over its entries' lengths.
void add_wear(GeneralContacts& general);

}  // namespace asperity
