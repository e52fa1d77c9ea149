#include <algorithm>
#include <cmath>

#include "core/base/units.hpp"
#include "core/contact/corner_walk.hpp"
#include "core/contact/general_contact.hpp"
#include "core/contact/surface_wear.hpp"
#include "core/geometry/near_boxes.hpp"

namespace asperity {
namespace {

/// The skin over the mean edge: wide enough that searches are rare, narrow enough that few pairs are listed in vain.
constexpr double kSkin = 0.2;

/// Depth over the mean edge at which the pressure has doubled, Eq. (C40): eight times what faces under the plaster's
/// strength overlap, so that flat contacts stay linear while a corner, whose contact is short, sinks in less.
constexpr double kStiffeningDepth = 0.03;

bool exposed(const BondedContacts& bonded, int edge) {
  const int joint = bonded.joint(edge);
  return joint == kOutline || (joint >= 0 && bonded.is_broken(joint));
}

int vertex_at(const Particles& particles, int corner) {
  return particles.vertex[particles.triangles[corner / 3][corner % 3]];
}

std::vector<std::uint8_t> exposed_vertices(const BondedContacts& bonded, const Particles& particles) {
  std::vector<std::uint8_t> marked(particles.vertices.size(), 0);
  for (int edge = 0; edge < static_cast<int>(3 * particles.triangle_count()); ++edge) {
    if (!exposed(bonded, edge)) continue;
    marked[vertex_at(particles, edge)] = marked[vertex_at(particles, following_edge(edge))] = 1;
  }
  return marked;
}

std::vector<ContactMember> find_members(const BondedContacts& bonded, const Particles& particles) {
  const std::vector<std::uint8_t> marked = exposed_vertices(bonded, particles);
  std::vector<ContactMember> members;
  for (int t = 0; t < static_cast<int>(particles.triangle_count()); ++t) {
    const int first = 3 * t;
    if (!marked[vertex_at(particles, first)] && !marked[vertex_at(particles, first + 1)] &&
        !marked[vertex_at(particles, first + 2)]) {
      continue;
    }
    ContactMember member{t, {-1, -1, -1}, {-1, -1, -1}, {-1, -1, -1}};
    for (int k = 0; k < 3; ++k) {
      if (!exposed(bonded, first + k)) continue;
      const bool outline = bonded.joint(first + k) == kOutline;
      member.surface[k] = static_cast<int>(outline ? SurfaceKind::outline : SurfaceKind::fracture);
    }
    members.push_back(member);
  }
  return members;
}

/// The exposed edge that goes on where an exposed edge ends: round the end's vertex until the material stops.
int next_exposed(const BondedContacts& bonded, int edge) {
  int candidate = following_edge(edge);
  while (!exposed(bonded, candidate)) candidate = following_edge(bonded.partner(candidate));
  return candidate;
}

void link_surface(GeneralContacts& general, const BondedContacts& bonded, std::size_t triangles) {
  std::vector<int> member_of(triangles, -1);
  for (std::size_t m = 0; m < general.members.size(); ++m) member_of[general.members[m].triangle] = static_cast<int>(m);
  for (std::size_t m = 0; m < general.members.size(); ++m) {
    ContactMember& member = general.members[m];
    for (int k = 0; k < 3; ++k) {
      if (member.surface[k] < 0) continue;
      const int next = next_exposed(bonded, 3 * member.triangle + k);
      member.next[k] = 3 * member_of[next / 3] + next % 3;
      general.members[member_of[next / 3]].previous[next % 3] = static_cast<int>(3 * m) + k;
    }
  }
}

std::vector<Box> reach(const GeneralContacts& general, const Particles& particles) {
  std::vector<Box> boxes;
  boxes.reserve(general.members.size());
  const Vec2 half{0.5 * general.skin, 0.5 * general.skin};
  for (const ContactMember& member : general.members) {
    const Box box = bounding_box(particles.corners(member.triangle));
    boxes.push_back({box.low - half, box.high + half});
  }
  return boxes;
}

/// Whether one edge of `in` keeps all corners of the other triangle farther away than the skin.
bool apart(const PresentTriangle& in, const PresentTriangle& other, double skin) {
  for (int k = 0; k < 3; ++k) {
    const double reach = -skin * norm(in.gradient[k]);
    if (in.depth(k, other.x[0]) < reach && in.depth(k, other.x[1]) < reach && in.depth(k, other.x[2]) < reach) {
      return true;
    }
  }
  return false;
}

/// Overlap over the mean edge that counts in full, Eq. (C54): several times what faces under stress
/// overlap.
constexpr double kPlay = 0.01;

/// How the joints between two triangles hold them together, the firmest first.
enum class Hold { intact, handing_over, cut };

/// A fan between two triangles that is narrower than this at rest can close so that the two meet through it.
constexpr double kWidestFan = 150.0 * units::kRadPerDeg;

/// Fills a pair's chain, the broken contacts between its triangles that are still handing over.
class ChainFinder {
 public:
  ChainFinder(const BondedContacts& bonded, const Particles& particles, std::vector<int>& list)
      : bonded_(bonded), particles_(particles), list_(list) {}

  /// False where the two are held together for good.
  bool operator()(int triangle_a, int triangle_b, MemberPair& pair) {
    pair.chain_begin = static_cast<int>(list_.size());
    const Hold hold = find(triangle_a, triangle_b);
    if (hold == Hold::cut) list_.resize(pair.chain_begin);
    pair.chain_size = static_cast<int>(list_.size()) - pair.chain_begin;
    return hold != Hold::intact;
  }

 private:
  Hold find(int triangle_a, int triangle_b) {
    for (int k = 0; k < 3; ++k) {
      const int partner = bonded_.partner(3 * triangle_a + k);
      if (partner >= 0 && partner / 3 == triangle_b) return follow(bonded_.joint(3 * triangle_a + k));
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const int a = 3 * triangle_a + i, b = 3 * triangle_b + j;
        if (vertex_at(particles_, a) == vertex_at(particles_, b)) return around(a, b);
      }
    }
    return Hold::cut;
  }

  /// One way round a vertex.
  struct Way {
    Hold hold;
    bool narrow;  ///< The two can meet through it.
  };

  /// Both ways round a vertex, from corner a to b and from b to a. The narrow ones count, and of two the looser one,
  /// since the triangles meet through it. Where neither is narrow they cannot meet here while either way holds.
  Hold around(int a, int b) {
    const std::size_t before = list_.size();
    const Way one = follow_way(a, b);
    const std::size_t middle = list_.size();
    const Way other = follow_way(b, a);
    if (one.narrow && other.narrow) return std::max(one.hold, other.hold);
    if (!one.narrow && !other.narrow) return std::min(one.hold, other.hold);
    if (one.narrow) {
      list_.resize(middle);
      return one.hold;
    }
    list_.erase(list_.begin() + before, list_.begin() + middle);
    return other.hold;
  }

  /// The joints counter-clockwise from one corner at a vertex to another; a way that is cut leaves nothing on the list.
  Way follow_way(int from, int to) {
    const std::size_t before = list_.size();
    Way way{Hold::intact, true};
    double width = 0.0;
    for (int corner = from; corner != to; corner = next_corner(bonded_, corner)) {
      if (corner != from) width += corner_angle(particles_, corner);
      const int joint = bonded_.joint(arriving_edge(corner));
      way.narrow = way.narrow && joint != kOutline && width <= kWidestFan;
      way.hold = std::max(way.hold, joint == kOutline ? Hold::cut : follow(joint));
      if (joint == kOutline) break;
    }
    if (way.hold == Hold::cut) list_.resize(before);
    return way;
  }

  Hold follow(int joint) {
    if (joint < 0 || !bonded_.is_broken(joint)) return Hold::intact;
    if (bonded_.weight(joint) == 0.0) return Hold::cut;
    list_.push_back(joint);
    return Hold::handing_over;
  }

  const BondedContacts& bonded_;
  const Particles& particles_;
  std::vector<int>& list_;
};

void list_pairs(GeneralContacts& general, const BondedContacts& bonded, const Particles& particles) {
  general.chain_contacts.clear();
  ChainFinder find_chains(bonded, particles, general.chain_contacts);
  for (const auto& [a, b] : near_boxes(reach(general, particles))) {
    const PresentTriangle &ta = general.frames[a], &tb = general.frames[b];
    if (apart(ta, tb, general.skin) || apart(tb, ta, general.skin)) continue;
    MemberPair pair{a, b};
    if (find_chains(general.members[a].triangle, general.members[b].triangle, pair)) {
      general.pairs.push_back(pair);
    } else {
      general.chain_contacts.resize(pair.chain_begin);
    }
  }
}

/// What a pair remembers from one list to the next.
struct PairMemory {
  std::array<int, 2> triangles;
  double seat;
  int touch;
};

std::array<int, 2> triangles_of(const GeneralContacts& general, const MemberPair& pair) {
  return {general.members[pair.a].triangle, general.members[pair.b].triangle};
}

std::vector<PairMemory> remember_pairs(const GeneralContacts& general) {
  std::vector<PairMemory> memories;
  for (const MemberPair& pair : general.pairs) {
    memories.push_back({triangles_of(general, pair), pair.seat, pair.touch});
  }
  return memories;
}

/// Gives seats and live touches to the pairs of the new list; both lists are sorted by triangles.
void carry_over(GeneralContacts& general, const std::vector<PairMemory>& memories) {
  std::vector<std::array<int, 2>> new_pair_of_touch;  // in the order of the touches: {touch, pair}
  auto pair = general.pairs.begin();
  for (const PairMemory& memory : memories) {
    while (pair != general.pairs.end() && triangles_of(general, *pair) < memory.triangles) ++pair;
    if (pair == general.pairs.end() || triangles_of(general, *pair) != memory.triangles) continue;
    pair->seat = memory.seat;
    if (memory.touch >= 0) new_pair_of_touch.push_back({memory.touch, static_cast<int>(pair - general.pairs.begin())});
  }
  std::sort(new_pair_of_touch.begin(), new_pair_of_touch.end());
  std::vector<Touch> kept;  // all, unless two triangles parted by more than the skin in one step
  for (const auto& [touch, index] : new_pair_of_touch) {
    general.pairs[index].touch = static_cast<int>(kept.size());
    kept.push_back(general.touches[touch]);
    kept.back().pair = index;
  }
  general.touches = std::move(kept);
}

/// Over the triangles outside elastic parts, which may be much coarser; over all where there are only those. mm.
double mean_particle_edge(const Particles& particles) {
  const std::vector<std::uint8_t>& bulk = particles.in_bulk;
  const bool all = std::find(bulk.begin(), bulk.end(), 0) == bulk.end();
  double length = 0.0, edges = 0.0;
  for (std::size_t t = 0; t < particles.triangle_count(); ++t) {
    if (!all && bulk[t]) continue;
    const auto& n = particles.triangles[t];
    for (int k = 0; k < 3; ++k) length += norm(particles.reference(n[(k + 1) % 3]) - particles.reference(n[k]));
    edges += 3.0;
  }
  return length / edges;
}

}  // namespace

GeneralContacts make_general_contacts(const Particles& particles, const GeneralContactLaw& law) {
  GeneralContacts general;
  general.law = law;
  if (!law.enabled) return general;
  if (wears(law)) general.wear.assign(3 * particles.triangle_count(), 0.0);
  const double mean_edge = mean_particle_edge(particles);
  general.skin = kSkin * mean_edge;
  general.play = kPlay * mean_edge;
  general.stiffening = 1.0 / (kStiffeningDepth * kStiffeningDepth * mean_edge * mean_edge);
  return general;
}

void search_pairs(GeneralContacts& general, const BondedContacts& bonded, const Particles& particles,
                  const ParallelLoops& loops) {
  const std::vector<PairMemory> memories = remember_pairs(general);
  general.members = find_members(bonded, particles);
  link_surface(general, bonded, particles.triangle_count());
  update_frames(general, particles, loops);
  general.pairs.clear();
  list_pairs(general, bonded, particles);
  carry_over(general, memories);
  general.handing_over.clear();
  for (std::size_t c = 0; c < bonded.size(); ++c) {
    if (bonded.is_broken(c) && bonded.weight(c) > 0.0) general.handing_over.push_back(static_cast<int>(c));
  }
  general.travel = 0.0;
  general.search_due = 0;
  ++general.searches;
}

}  // namespace asperity
