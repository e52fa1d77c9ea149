#include "core/integrator/outer_surface.hpp"

#include <algorithm>
#include <limits>

#include "core/contact/pieces.hpp"
#include "core/geometry/moderate.hpp"

namespace asperity {
namespace {

/// An edge that faces the side one looks from: its heights, and how far behind it lies at both.
struct SeenEdge {
  double low, high;
  double depth_low, depth_high;
  std::size_t index;  ///< In the list of exposed edges.

  double depth(double y) const {
    const double t = (y - low) / (high - low);
    return (1.0 - t) * depth_low + t * depth_high;
  }
};

/// The heights at which one edge is the outermost.
struct Piece {
  double low, high;
  std::size_t edge;
};

/// What is seen from one side, from below to above; heights may be missing.
using Profile = std::vector<Piece>;

void append(Profile& profile, const Piece& piece) {
  if (piece.low >= piece.high) return;
  if (!profile.empty() && profile.back().edge == piece.edge && profile.back().high == piece.low) {
    profile.back().high = piece.high;
  } else {
    profile.push_back(piece);
  }
}

/// The nearer of two edges between two heights, with a cut where they cross.
void append_nearer(Profile& profile, const std::vector<SeenEdge>& seen, std::size_t a, std::size_t b, double low,
                   double high) {
  const double behind_low = seen[a].depth(low) - seen[b].depth(low);
  const double behind_high = seen[a].depth(high) - seen[b].depth(high);
  if (behind_low <= 0.0 && behind_high <= 0.0) return append(profile, {low, high, a});
  if (behind_low >= 0.0 && behind_high >= 0.0) return append(profile, {low, high, b});
  const double cut = std::clamp(low + (high - low) * (behind_low / (behind_low - behind_high)), low, high);
  append(profile, {low, cut, behind_low < 0.0 ? a : b});
  append(profile, {cut, high, behind_low < 0.0 ? b : a});
}

/// What is left of a profile's piece above y; beyond the last one a piece that no height reaches.
Piece rest_of(const Profile& profile, std::size_t i, double y) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if (i == profile.size()) return {kNever, kNever, 0};
  return {std::max(profile[i].low, y), profile[i].high, profile[i].edge};
}

/// What is seen of two profiles one before the other: one pass over both.
Profile nearer(const std::vector<SeenEdge>& seen, const Profile& a, const Profile& b) {
  Profile result;
  double y = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    const Piece p = rest_of(a, i, y), q = rest_of(b, j, y);
    if (p.low == q.low) {
      y = std::min(p.high, q.high);
      append_nearer(result, seen, p.edge, q.edge, p.low, y);
    } else {
      const Piece& alone = p.low < q.low ? p : q;
      y = std::min(alone.high, std::max(p.low, q.low));
      append(result, {alone.low, y, alone.edge});
    }
    if (p.high <= y) ++i;
    if (q.high <= y) ++j;
  }
  return result;
}

/// The outermost of the edges `begin` to `end`, by halves.
Profile outermost(const std::vector<SeenEdge>& seen, std::size_t begin, std::size_t end) {
  if (begin == end) return {};
  if (end - begin == 1) return {{seen[begin].low, seen[begin].high, begin}};
  const std::size_t middle = begin + (end - begin) / 2;
  return nearer(seen, outermost(seen, begin, middle), outermost(seen, middle, end));
}

/// The carrying edges that face the left (`side` 1) or the right (-1).
std::vector<SeenEdge> edges_facing(double side, const std::vector<Vec2>& position, std::span<const ExposedEdge> exposed,
                                   std::span<const std::uint8_t> carries) {
  std::vector<SeenEdge> seen;
  for (std::size_t i = 0; i < exposed.size(); ++i) {
    if (carries[exposed[i].triangle] == 0) continue;
    const Vec2 first = position[exposed[i].nodes[0]], second = position[exposed[i].nodes[1]];
    if (!(side * (first.y - second.y) > 0.0)) continue;
    const Vec2 low = side > 0.0 ? second : first, high = side > 0.0 ? first : second;
    seen.push_back({low.y, high.y, side * low.x, side * high.x, i});
  }
  return seen;
}

/// Eq. (I16), for the edges that face one side.
void add_shares(const std::vector<SeenEdge>& seen, std::vector<double>& share) {
  for (const Piece& piece : outermost(seen, 0, seen.size())) share[seen[piece.edge].index] += piece.high - piece.low;
  for (const SeenEdge& e : seen) share[e.index] = std::min(1.0, share[e.index] / (e.high - e.low));
}

}  // namespace

std::vector<std::uint8_t> carrying_triangles(const BondedContacts& contacts, const Particles& particles,
                                             std::span<const std::uint8_t> on_platen,
                                             std::span<const std::array<int, 2>> touching) {
  DisjointSets groups = bonded_pieces(contacts, particles);
  for (const auto& pair : touching) groups.join(pair[0], pair[1]);
  const std::vector<int> group = groups.names();
  std::vector<std::uint8_t> held(group.size(), 0), carries;
  for (std::size_t t = 0; t < group.size(); ++t) {
    if (on_platen[t] != 0) held[group[t]] = 1;
  }
  for (int g : group) carries.push_back(held[g]);
  return carries;
}

std::vector<int> joined_nodes(const BondedContacts& contacts, std::size_t node_count) {
  DisjointSets groups(node_count);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.is_broken(c)) continue;
    groups.join(contacts.edges[c].left1, contacts.edges[c].right1);
    groups.join(contacts.edges[c].left2, contacts.edges[c].right2);
  }
  return groups.names();
}

std::vector<Vec2> closed_positions(const std::vector<Vec2>& position, const std::vector<int>& joined) {
  std::vector<Vec2> sum(position.size());
  std::vector<int> count(position.size(), 0);
  for (std::size_t i = 0; i < position.size(); ++i) {
    sum[joined[i]] += position[i];
    ++count[joined[i]];
  }
  std::vector<Vec2> closed;
  closed.reserve(position.size());
  for (int group : joined) closed.push_back((1.0 / count[group]) * sum[group]);
  return closed;
}

std::vector<LoadedEdge> find_loaded_edges(const std::vector<Vec2>& position, std::span<const ExposedEdge> exposed,
                                          std::span<const std::uint8_t> carries) {
  require_moderate(position);
  std::vector<double> share(exposed.size(), 0.0);
  for (double side : {1.0, -1.0}) add_shares(edges_facing(side, position, exposed, carries), share);
  std::vector<LoadedEdge> loaded;
  for (std::size_t i = 0; i < exposed.size(); ++i) {
    if (share[i] > 0.0 && !exposed[i].under_platen) loaded.push_back({exposed[i].nodes, share[i]});
  }
  return loaded;
}

}  // namespace asperity
