#include "core/measurement/crack_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "core/base/disjoint_sets.hpp"
#include "core/base/units.hpp"

namespace asperity {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// Angle (rad) from the loading axis, in [-pi/2, pi/2].
double angle_from_load(Vec2 along) {
  const Vec2 up = along.y < 0.0 ? Vec2{-along.x, -along.y} : along;
  return std::atan2(up.x, up.y);
}

/// Half the angle of a vector of doubled angles, in degrees; +90 rather than -90.
double halved_deg(double cosine, double sine) {
  const double angle = 0.5 * std::atan2(sine, cosine) / units::kRadPerDeg;
  return angle <= -90.0 ? 90.0 : angle;
}

/// The pattern's mesh vertices, ascending, and each crack's two as indices into them.
struct Graph {
  std::vector<int> vertices;
  std::vector<std::array<int, 2>> ends;

  explicit Graph(const CrackPattern& pattern) {
    for (const CrackLine& crack : pattern) vertices.insert(vertices.end(), crack.vertex.begin(), crack.vertex.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (const CrackLine& crack : pattern) ends.push_back({index_of(crack.vertex[0]), index_of(crack.vertex[1])});
  }
  int index_of(int vertex) const {
    return static_cast<int>(std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin());
  }
};

/// Dijkstra's distances from a set of vertices along cracks, and the crack by which each vertex is reached.
struct Reached {
  std::vector<double> distance;
  std::vector<int> by;  ///< -1 at the start and where nothing leads.
};

Reached reach(const Graph& graph, const CrackPattern& pattern, const std::vector<int>& start) {
  std::vector<std::vector<int>> cracks(graph.vertices.size());
  for (int c = 0; c < static_cast<int>(pattern.size()); ++c) {
    for (const int v : graph.ends[c]) cracks[v].push_back(c);
  }
  Reached result{std::vector<double>(cracks.size(), std::numeric_limits<double>::infinity()),
                 std::vector<int>(cracks.size(), -1)};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const int v : start) {
    result.distance[v] = 0.0;
    queue.emplace(0.0, v);
  }
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > result.distance[v]) continue;
    for (const int c : cracks[v]) {
      const int next = graph.ends[c][0] == v ? graph.ends[c][1] : graph.ends[c][0];
      const double there = distance + pattern[c].length();
      if (there >= result.distance[next]) continue;
      result.distance[next] = there;
      result.by[next] = c;
      queue.emplace(there, next);
    }
  }
  return result;
}

/// Indices of the graph's vertices whose place a condition accepts.
std::vector<int> accepted(const Graph& graph, const CrackPattern& pattern, const std::function<bool(Vec2)>& condition) {
  std::vector<int> found;
  for (std::size_t c = 0; c < pattern.size(); ++c) {
    for (int k = 0; k < 2; ++k) {
      if (condition(pattern[c].end[k])) found.push_back(graph.ends[c][k]);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

CrackPattern crack_pattern(const BondedContacts& contacts, const Particles& p, double until_s) {
  CrackPattern pattern;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (!contacts.is_crack(c) || contacts.break_time(c) > until_s) continue;
    const ContactEdge& e = contacts.edges[c];
    pattern.push_back({{p.vertex[e.left1], p.vertex[e.left2]},
                       {p.reference(e.left1), p.reference(e.left2)},
                       edge_break_mode(contacts.points(c))});
  }
  return pattern;
}

double total_length(const CrackPattern& pattern) {
  double length = 0.0;
  for (const CrackLine& crack : pattern) length += crack.length();
  return length;
}

CrackPattern select(const CrackPattern& pattern, const std::function<bool(const CrackLine&)>& condition) {
  CrackPattern picked;
  std::copy_if(pattern.begin(), pattern.end(), std::back_inserter(picked), condition);
  return picked;
}

double length_share(const CrackPattern& pattern, const std::function<bool(const CrackLine&)>& condition) {
  if (pattern.empty()) return kNothing;
  return total_length(select(pattern, condition)) / total_length(pattern);
}

AxialStatistics axial_statistics(const CrackPattern& pattern) {
  if (pattern.empty()) return {kNothing, kNothing, kNothing, kNothing};
  double length = 0.0, cosine = 0.0, sine = 0.0, deviation = 0.0;
  for (const CrackLine& crack : pattern) {
    const double angle = angle_from_load(crack.end[1] - crack.end[0]), l = crack.length();
    length += l;
    cosine += l * std::cos(2.0 * angle);
    sine += l * std::sin(2.0 * angle);
    deviation += l * std::abs(angle);
  }
  return {halved_deg(cosine, sine), std::hypot(cosine, sine) / length, cosine / length,
          deviation / length / units::kRadPerDeg};
}

CrackPattern largest_cluster(const CrackPattern& pattern) {
  const Graph graph(pattern);
  DisjointSets sets(graph.vertices.size());
  for (const auto& ends : graph.ends) sets.join(ends[0], ends[1]);
  std::vector<double> length(graph.vertices.size(), 0.0);
  for (std::size_t c = 0; c < pattern.size(); ++c) length[sets.find(graph.ends[c][0])] += pattern[c].length();
  const auto longest = static_cast<int>(std::max_element(length.begin(), length.end()) - length.begin());
  CrackPattern cluster;
  for (std::size_t c = 0; c < pattern.size(); ++c) {
    if (sets.find(graph.ends[c][0]) == longest) cluster.push_back(pattern[c]);
  }
  return cluster;
}

PrincipalDirection principal_direction(const CrackPattern& pattern) {
  if (pattern.empty()) return {kNothing, kNothing};
  const double length = total_length(pattern);
  Vec2 centre;
  for (const CrackLine& crack : pattern) centre += (crack.length() / length) * crack.middle();
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const CrackLine& crack : pattern) {
    const double l = crack.length();
    const Vec2 arm = crack.middle() - centre, along = crack.end[1] - crack.end[0];
    xx += l * (arm.x * arm.x + along.x * along.x / 12.0);
    xy += l * (arm.x * arm.y + along.x * along.y / 12.0);
    yy += l * (arm.y * arm.y + along.y * along.y / 12.0);
  }
  const double mean = 0.5 * (xx + yy), radius = std::hypot(0.5 * (yy - xx), xy);
  constexpr double kRounding = 1e-12;
  const double across = std::max(0.0, mean - radius);
  const double elongation =
      across > kRounding * mean ? std::sqrt((mean + radius) / across) : std::numeric_limits<double>::infinity();
  return {halved_deg(yy - xx, 2.0 * xy), elongation};
}

CrackPattern shortest_path(const CrackPattern& pattern, const std::function<bool(Vec2)>& from,
                           const std::function<bool(Vec2)>& to) {
  const Graph graph(pattern);
  const Reached reached = reach(graph, pattern, accepted(graph, pattern, from));
  const std::vector<int> goals = accepted(graph, pattern, to);
  const auto nearest = std::min_element(goals.begin(), goals.end(),
                                        [&](int a, int b) { return reached.distance[a] < reached.distance[b]; });
  CrackPattern path;
  if (nearest == goals.end()) return path;
  for (int v = *nearest; reached.by[v] >= 0;) {
    const int c = reached.by[v];
    path.push_back(pattern[c]);
    v = graph.ends[c][0] == v ? graph.ends[c][1] : graph.ends[c][0];
  }
  return path;
}

}  // namespace asperity
