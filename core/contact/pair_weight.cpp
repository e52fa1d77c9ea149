#include "core/contact/pair_weight.hpp"

#include <span>

namespace asperity {
namespace {

constexpr int kNone = -1;

std::span<const int> chain_of(const GeneralContacts& general, const MemberPair& pair) {
  return std::span(general.chain_contacts).subspan(pair.chain_begin, pair.chain_size);
}

/// Product of the weights of a chain's contacts, all but one of them.
double product(const BondedContacts& bonded, std::span<const int> chain, int without) {
  double result = 1.0;
  for (int contact : chain) {
    if (contact != without) result *= bonded.weight(contact);
  }
  return result;
}

}  // namespace

double pair_weight(const GeneralContacts& general, const BondedContacts& bonded, const MemberPair& pair) {
  if (pair.chain_size == 0) return 1.0;
  return 1.0 - product(bonded, chain_of(general, pair), kNone);
}

void share_potential(const GeneralContacts& general, const BondedContacts& bonded, const MemberPair& pair,
                     double potential, std::vector<double>& set_free) {
  const std::span<const int> chain = chain_of(general, pair);
  for (int contact : chain) set_free[contact] += product(bonded, chain, contact) * potential;
}

}  // namespace asperity
