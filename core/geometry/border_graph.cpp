#include "core/geometry/border_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

namespace asperity {
namespace {

double length_of(const GrainBorders& borders, const std::array<int, 2>& border) {
  return norm(borders.corners[border[1]].at - borders.corners[border[0]].at);
}

bool on_outline(const GrainCorner& corner) { return corner.side >= 0; }

/// Replaces corners by those they are merged into; drops borders without length, duplicates, and those that repeat a
/// piece of the outline.
void rename_corners(GrainBorders& borders, const std::vector<int>& merged_into) {
  std::set<std::array<int, 2>> known;
  for (std::size_t i = 0; i < borders.loop.size(); ++i) {
    const auto [low, high] = std::minmax(borders.loop[i], borders.loop[(i + 1) % borders.loop.size()]);
    known.insert({low, high});
  }
  std::vector<std::array<int, 2>> kept;
  for (const auto& [a, b] : borders.inner) {
    const auto [low, high] = std::minmax(merged_into[a], merged_into[b]);
    if (low != high && known.insert({low, high}).second) kept.push_back({low, high});
  }
  borders.inner = kept;
}

std::vector<int> unmerged(const GrainBorders& borders) {
  std::vector<int> itself(borders.corners.size());
  std::iota(itself.begin(), itself.end(), 0);
  return itself;
}

void add_outline_corners(GrainBorders& borders, const Outline& outline) {
  for (int s = 0; s < static_cast<int>(outline.sides.size()); ++s)
    borders.corners.push_back({outline.sides[s].start, s, 0.0, true});
}

std::vector<int> ordered_along_outline(const GrainBorders& borders) {
  std::vector<int> order;
  for (int c = 0; c < static_cast<int>(borders.corners.size()); ++c)
    if (on_outline(borders.corners[c])) order.push_back(c);
  const auto key = [&](int c) {
    const GrainCorner& corner = borders.corners[c];
    return std::tuple(corner.side, corner.along, !corner.fixed, c);
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  return order;
}

/// Merges two corners and says which one is left; 'a' moves where neither is bound to the outline.
int merge(GrainBorders& borders, int a, int b) {
  if (on_outline(borders.corners[a])) return a;
  if (on_outline(borders.corners[b])) return b;
  borders.corners[a].at = 0.5 * (borders.corners[a].at + borders.corners[b].at);
  return a;
}

/// One round: merges the short borders, shortest first, each corner at most once. False where there was none.
bool collapse_once(GrainBorders& borders, double shortest_mm) {
  std::vector<std::array<int, 2>> order = borders.inner;
  std::stable_sort(order.begin(), order.end(),
                   [&](const auto& a, const auto& b) { return length_of(borders, a) < length_of(borders, b); });
  std::vector<int> merged_into = unmerged(borders);
  std::vector<bool> touched(borders.corners.size(), false);
  bool any = false;
  for (const auto& [a, b] : order) {
    // A border that spans the outline from side to side stays: merging its ends would move the outline.
    const bool bound = on_outline(borders.corners[a]) && on_outline(borders.corners[b]);
    if (bound || touched[a] || touched[b] || length_of(borders, {a, b}) >= shortest_mm) continue;
    const int left = merge(borders, a, b);
    merged_into[a] = merged_into[b] = left;
    touched[a] = touched[b] = any = true;
  }
  rename_corners(borders, merged_into);
  return any;
}

}  // namespace

void close_along_outline(GrainBorders& borders, const Outline& outline, double shortest_mm) {
  add_outline_corners(borders, outline);
  std::vector<int> merged_into = unmerged(borders);
  // Each side starts with the outline's own corner, which swallows what is near it; the last on a side looks ahead.
  const std::vector<int> order = ordered_along_outline(borders);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const GrainCorner& corner = borders.corners[order[i]];
    const double beyond = outline.sides[corner.side].length() - corner.along;
    const int next_side = (corner.side + 1) % static_cast<int>(outline.sides.size());
    if (!corner.fixed && beyond < shortest_mm) {
      merged_into[order[i]] = static_cast<int>(borders.corners.size() - outline.sides.size()) + next_side;
      continue;
    }
    const bool near = !borders.loop.empty() && borders.corners[borders.loop.back()].side == corner.side &&
                      corner.along - borders.corners[borders.loop.back()].along < shortest_mm;
    if (near)
      merged_into[order[i]] = borders.loop.back();
    else
      borders.loop.push_back(order[i]);
  }
  rename_corners(borders, merged_into);
}

void collapse_short(GrainBorders& borders, double shortest_mm) {
  while (collapse_once(borders, shortest_mm)) {
  }
}

BorderSplitter::BorderSplitter(const GrainBorders& borders, double edge_mm)
    : borders_(borders), edge_mm_(edge_mm), point_(borders.corners.size(), -1) {}

int BorderSplitter::point_of(int corner) {
  if (point_[corner] < 0) {
    point_[corner] = static_cast<int>(set_.points.size());
    set_.points.push_back({borders_.corners[corner].at, Freedom::fixed});
  }
  return point_[corner];
}

template <class At>
void BorderSplitter::add_pieces(int from, int to, double length, const At& at) {
  const int pieces = std::max(1, static_cast<int>(std::lround(length / edge_mm_)));
  int last = point_of(from);
  for (int i = 1; i < pieces; ++i) {
    const int next = static_cast<int>(set_.points.size());
    set_.points.push_back({at(length * i / pieces), Freedom::fixed});
    set_.segments.push_back({last, next});
    last = next;
  }
  set_.segments.push_back({last, point_of(to)});
}

void BorderSplitter::add_line(int from, int to) {
  const Vec2 a = borders_.corners[from].at, d = borders_.corners[to].at - a;
  const double length = norm(d);
  add_pieces(from, to, length, [&](double along) { return a + (along / length) * d; });
}

void BorderSplitter::add_arc(int from, int to, const Outline& outline) {
  const GrainCorner& start = borders_.corners[from];
  const Side& side = outline.sides[start.side];
  const double end = borders_.corners[to].side == start.side ? borders_.corners[to].along : side.length();
  add_pieces(from, to, end - start.along, [&](double along) { return side.at(start.along + along); });
}

}  // namespace asperity
