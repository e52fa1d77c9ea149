#include "render/fragment_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "render/outline.hpp"
#include "render/style.hpp"

namespace asperity::render {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

using Neighbours = std::map<int, std::set<int>>;

Neighbours neighbouring_fragments(const Frame& frame) {
  Neighbours neighbours;
  for (const auto& [t, u] : adjacent_triangles(frame)) {
    const int a = frame.fragment[at(t)], b = frame.fragment[at(u)];
    if (a == b) continue;
    neighbours[a].insert(b);
    neighbours[b].insert(a);
  }
  return neighbours;
}

/// The muted colour that fewest of the neighbours have; the search begins at another one for each `place`.
Colour muted_colour(const std::set<int>& neighbours, const std::map<int, Colour>& coloured, std::size_t place) {
  constexpr std::size_t n = style::kSmallFragments.size();
  std::array<int, n> taken{};
  for (const int neighbour : neighbours) {
    const auto found = coloured.find(neighbour);
    for (std::size_t i = 0; i < n && found != coloured.end(); ++i)
      taken[i] += found->second == style::kSmallFragments[i];
  }
  std::size_t best = place % n;
  for (std::size_t step = 1; step < n; ++step)
    if (const std::size_t i = (place + step) % n; taken[i] < taken[best]) best = i;
  return style::kSmallFragments[best];
}

}  // namespace

std::vector<FragmentShare> fragments_by_area(const Frame& frame) {
  std::map<int, double> areas;
  double all = 0;
  for (std::size_t i = 0; i < frame.triangles.size(); ++i) {
    const auto& t = frame.triangles[i];
    const Vec2 a = frame.position[at(t[0])], b = frame.position[at(t[1])], c = frame.position[at(t[2])];
    const double area = 0.5 * std::abs(cross(b - a, c - a));
    areas[frame.fragment[i]] += area;
    all += area;
  }
  std::vector<FragmentShare> shares;
  for (const auto& [fragment, area] : areas) shares.push_back({fragment, all > 0 ? area / all : 0});
  std::stable_sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.share > b.share; });
  return shares;
}

std::map<int, Colour> fragment_colours(const Frame& frame, const std::vector<FragmentShare>& order) {
  Neighbours neighbours = neighbouring_fragments(frame);
  std::map<int, Colour> colours;
  for (std::size_t place = 0; place < order.size(); ++place) {
    const int fragment = order[place].fragment;
    colours[fragment] = place == 0                          ? style::kLargestFragment
                        : place <= style::kFragments.size() ? style::kFragments[place - 1]
                                                            : muted_colour(neighbours[fragment], colours, place);
  }
  return colours;
}

}  // namespace asperity::render
