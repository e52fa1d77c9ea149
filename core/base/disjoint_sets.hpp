#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

namespace asperity {

/// Disjoint sets of 0 ... n - 1 (union-find with path halving). A set is named by its smallest member, so the result
/// does not depend on the order of joining.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(int a, int b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  /// The name of every member's set.
  std::vector<int> names() {
    for (int i = 0; i < static_cast<int>(parent_.size()); ++i) parent_[i] = find(i);
    return parent_;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace asperity
