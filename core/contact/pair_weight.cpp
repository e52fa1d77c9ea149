#include "core/contact/pair_weight.hpp"

namespace asperity {
namespace {

/// Product of the weights of a chain's contacts, all but one of them.
double chain_weight(const GeneralContacts& general, const BondedContacts& bonded, int begin, int size, int without) {
  double product = 1.0;
  for (int i = begin; i < begin + size; ++i) {
    const int contact = general.chain_contacts[i];
    if (contact != without) product *= bonded.hand_over[contact].weight;
  }
  return product;
}

constexpr int kNone = -1;

}  // namespace

double pair_weight(const GeneralContacts& general, const BondedContacts& bonded, const MemberPair& pair) {
  double weight = 1.0;
  int begin = pair.chain_begin;
  for (int size : pair.chain_size) {
    if (size > 0) weight *= 1.0 - chain_weight(general, bonded, begin, size, kNone);
    begin += size;
  }
  return weight;
}

void share_potential(const GeneralContacts& general, const BondedContacts& bonded, const MemberPair& pair,
                     double potential, std::vector<double>& gained) {
  const int second = pair.chain_begin + pair.chain_size[0];
  const std::array<int, 2> begin{pair.chain_begin, second};
  for (int chain = 0; chain < 2; ++chain) {
    const int size = pair.chain_size[chain], other_size = pair.chain_size[1 - chain];
    const double rest = other_size > 0 ? 1.0 - chain_weight(general, bonded, begin[1 - chain], other_size, kNone) : 1.0;
    for (int i = begin[chain]; i < begin[chain] + size; ++i) {
      const int contact = general.chain_contacts[i];
      gained[contact] += rest * chain_weight(general, bonded, begin[chain], size, contact) * potential;
    }
  }
}

}  // namespace asperity
