#include "core/measurement/fragments.hpp"

#include <algorithm>

#include "core/base/disjoint_sets.hpp"

namespace asperity {
namespace {

std::vector<int> connected_triangles(const BondedContacts& contacts, const Particles& p) {
  DisjointSets pieces(p.triangle_count());
  std::vector<int> first_of_grain(p.triangle_count(), -1);
  for (int t = 0; t < static_cast<int>(p.triangle_count()); ++t) {
    int& first = first_of_grain[p.grain[t]];
    if (first < 0) first = t;
    pieces.join(first, t);
  }
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.break_time[c] < 0.0) pieces.join(contacts.edges[c].left_triangle, contacts.edges[c].right_triangle);
  }
  return pieces.names();
}

}  // namespace

Fragments find_fragments(const BondedContacts& contacts, const Particles& p) {
  const std::vector<int> root = connected_triangles(contacts, p);
  std::vector<double> area(root.size(), 0.0);
  std::vector<int> roots;
  for (std::size_t t = 0; t < root.size(); ++t) {
    if (root[t] == static_cast<int>(t)) roots.push_back(root[t]);
    area[root[t]] += p.shapes[t].area;
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
