#include "core/measurement/fragments.hpp"

#include <algorithm>

namespace asperity {

Fragments find_fragments(const BondedContacts& contacts, const Particles& p, double time_s) {
  const std::vector<int> root = bonded_pieces(contacts, p, time_s).names();
  std::vector<double> area(root.size(), 0.0);
  std::vector<int> roots;
  for (std::size_t t = 0; t < root.size(); ++t) {
    if (root[t] == static_cast<int>(t)) roots.push_back(root[t]);
    area[root[t]] += p.shape(t).area;
  }
  std::stable_sort(roots.begin(), roots.end(), [&](int a, int b) { return area[a] > area[b]; });
  Fragments fragments;
  std::vector<int> number(root.size(), 0);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    number[roots[i]] = static_cast<int>(i);
    fragments.area_mm2.push_back(area[roots[i]]);
  }
  for (int r : root) fragments.of_triangle.push_back(number[r]);
  return fragments;
}

}  // namespace asperity
