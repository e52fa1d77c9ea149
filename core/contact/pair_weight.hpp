#pragma once
#include <vector>

#include "core/contact/general_contact.hpp"

namespace asperity {

/// Weight of a pair, Eq. (C46).
double pair_weight(const GeneralContacts& general, const BondedContacts& bonded, const MemberPair& pair);

/// Adds to each bonded contact of the pair's chain the energy it sets free as its own weight falls, -dW/dw times the
/// pair's potential (N mm per mm of thickness); Eq. (C48).
void share_potential(const GeneralContacts& general, const BondedContacts& bonded, const MemberPair& pair,
                     double potential, std::vector<double>& set_free);

}  // namespace asperity
