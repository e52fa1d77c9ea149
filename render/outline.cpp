#include "render/outline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::render {
namespace {

constexpr double kSamePlacePerMm = 1e3;  // edges whose middles round to the same micrometre are the same

struct Edge {
  std::array<long long, 3> middle;  ///< x, y and, of a joint, the half: its halves' edges lie upon each other.
  std::array<int, 2> nodes;
  int triangle;
};

/// Every triangle's edges; those at one place follow one another.
std::vector<Edge> all_edges(const Frame& frame) {
  const auto before_loading = [&](int node) {
    const auto i = static_cast<std::size_t>(node);
    return frame.position[i] - frame.displacement[i];
  };
  std::vector<Edge> edges;
  edges.reserve(3 * frame.triangles.size());
  for (std::size_t t = 0; t < frame.triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::array<int, 2> nodes{frame.triangles[t][c], frame.triangles[t][(c + 1) % 3]};
      const Vec2 twice = before_loading(nodes[0]) + before_loading(nodes[1]);
      const long long half = frame.half.empty() ? 0 : frame.half[t];
      edges.push_back({{std::llround(kSamePlacePerMm * twice.x), std::llround(kSamePlacePerMm * twice.y), half},
                       nodes,
                       static_cast<int>(t)});
    }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return std::pair(a.middle, a.nodes) < std::pair(b.middle, b.nodes); });
  return edges;
}

}  // namespace

std::vector<std::array<int, 2>> outline_edges(const Frame& frame) {
  const std::vector<Edge> edges = all_edges(frame);
  std::vector<std::array<int, 2>> outline;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool shared = (i > 0 && edges[i - 1].middle == edges[i].middle) ||
                        (i + 1 < edges.size() && edges[i + 1].middle == edges[i].middle);
    if (!shared) outline.push_back(edges[i].nodes);
  }
  return outline;
}

std::vector<std::array<int, 2>> adjacent_triangles(const Frame& frame) {
  const std::vector<Edge> edges = all_edges(frame);
  std::vector<std::array<int, 2>> pairs;
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i - 1].middle == edges[i].middle) pairs.push_back({edges[i - 1].triangle, edges[i].triangle});
  return pairs;
}

}  // namespace asperity::render
