#include "core/contact/pieces.hpp"

namespace asperity {

DisjointSets bonded_pieces(const BondedContacts& contacts, const Particles& p, double time_s) {
  DisjointSets pieces(p.triangle_count());
  std::vector<int> first_of_grain(p.triangle_count(), -1);
  for (int t = 0; t < static_cast<int>(p.triangle_count()); ++t) {
    int& first = first_of_grain[p.grain[t]];
    if (first < 0) first = t;
    pieces.join(first, t);
  }
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const bool holds = !contacts.is_broken(c) || contacts.break_time(c) > time_s;
    if (holds) pieces.join(contacts.edges[c].left_triangle(), contacts.edges[c].right_triangle());
  }
  return pieces;
}

}  // namespace asperity
