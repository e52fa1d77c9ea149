#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/contact/bonded_fast.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h:
#include <hwy/highway.h>

#include "core/contact/bonded_kernels.hpp"
#include "core/contact/consistent_law.hpp"
#include "core/contact/law_simd.inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace asperity::HWY_NAMESPACE {

Contacts kind_of(const BondedContacts& contacts) {
  const LawParameters& p = contacts.law;
  const bool varied = !contacts.strengths.empty() || p.envelope_exponent != 1.0 || p.closure_share != 0.0;
  return varied ? Contacts::varied : Contacts::base;
}

/// Contacts of one register: the first one and how many lanes are contacts that take part.
struct Batch {
  const ContactEdge* edges;
  std::size_t count;  ///< Lanes beyond it repeat the last contact.
  const ContactEdge& edge(std::size_t lane) const { return edges[lane < count ? lane : count - 1]; }
};

template <int ContactEdge::*Node>
HWY_INLINE Points node_positions(const Batch& batch, const Vec2* position) {
  return load_points([&](std::size_t lane) { return &position[batch.edge(lane).*Node].x; });
}

HWY_INLINE Real lengths(const Batch& batch) {
  HWY_ALIGN double length[kLanes];
  for (std::size_t lane = 0; lane < kLanes; ++lane) length[lane] = batch.edge(lane).length;
  return hn::Load(kDoubles, length);
}

HWY_INLINE State load_state(const PackedPoints& b, std::size_t q, std::size_t lane) {
  const auto row = [&](const PackedPoints::Rows& rows) { return hn::Load(kDoubles, rows[q].data() + lane); };
  return {row(b.normal),      row(b.shear),    row(b.slip),   row(b.hardening),      row(b.integrity_n),
          row(b.integrity_s), row(b.friction), row(b.damage), row(b.fracture_energy)};
}

HWY_INLINE void store_state(const State& s, const Outcome& out, PackedPoints& b, std::size_t q, std::size_t lane) {
  const auto row = [&](Real value, PackedPoints::Rows& rows) { hn::Store(value, kDoubles, rows[q].data() + lane); };
  row(s.normal, b.normal);
  row(s.shear, b.shear);
  if (out.yields) {
    row(s.slip, b.slip);
    row(s.hardening, b.hardening);
  }
  if (out.weakens) row(s.integrity_n, b.integrity_n);
  if (out.rubs) {
    row(s.integrity_s, b.integrity_s);
    row(s.friction, b.friction);
  }
  if (out.softens) row(s.damage, b.damage);
  if (out.yields || out.weakens || out.rubs) row(s.fracture_energy, b.fracture_energy);
}

/// Blocks ahead that are fetched while one is worked on: a large model's step otherwise waits for memory.
constexpr std::size_t kAhead = 2;

/// Memory and slots of a block that comes later. They are fetched a few lines at a time: all at once would take every
/// place that waits for memory.
struct Later {
  const char *rows, *slots;
  Later(const BondedContacts& contacts, std::size_t first, std::span<const Vec2> forces) {
    const std::size_t block = std::min(first / kPacked + kAhead, contacts.memory.packed.size() - 1);
    rows = reinterpret_cast<const char*>(&contacts.memory.packed[block]);
    slots = reinterpret_cast<const char*>(&forces[2 * contact_slot(block * kPacked, 0)]);
  }
  HWY_INLINE static void fetch(const char* lines, std::size_t from, std::size_t to) {
    constexpr std::size_t kLine = 64;
    for (std::size_t line = from; line < to; ++line) __builtin_prefetch(lines + line * kLine, 1, 2);
  }
};

/// Lanes of unbroken contacts, of which a point breaks now, one bit each.
template <Contacts kKind>
HWY_INLINE unsigned update_batch(PackedPoints& block, std::size_t lane, const Batch& batch, const Vec2* position,
                                 const Strengths& strengths, const Law& law, const Later& later, double* forces) {
  const Points l1 = node_positions<&ContactEdge::left1>(batch, position);
  const Points l2 = node_positions<&ContactEdge::left2>(batch, position);
  const Points r1 = node_positions<&ContactEdge::right1>(batch, position);
  const Points r2 = node_positions<&ContactEdge::right2>(batch, position);
  const Points midline = set(0.5) * ((l2 - l1) + (r2 - r1));
  const Real inverse_length = hn::Div(set(1.0), hn::Sqrt(dot(midline, midline)));
  const Points tangent = inverse_length * midline;
  const Points normal{tangent.y, Neg(tangent.x)};
  const Points gap1 = r1 - l1, gap2 = r2 - l2;
  const Real near = set(kNearGauss), far = set(kFarGauss);

  State s0 = load_state(block, 0, lane), s1 = load_state(block, 1, lane);
  Later::fetch(later.rows, 0, 6);
  const Points at0 = near * gap1 + far * gap2, at1 = far * gap1 + near * gap2;
  const Real normal0 = dot(at0, normal), normal1 = dot(at1, normal);
  const Pressed pressed0 = press<kKind>(normal0, strengths, law);
  const Pressed pressed1 = press<kKind>(normal1, strengths, law);  // beside the other: powers have long latencies
  const Outcome o0 = update_points(s0, normal0, dot(at0, tangent), pressed0, strengths, law);
  Later::fetch(later.rows, 6, 12);
  const Outcome o1 = update_points(s1, normal1, dot(at1, tangent), pressed1, strengths, law);
  Later::fetch(later.rows, 12, 18);
  store_state(s0, o0, block, 0, lane);
  store_state(s1, o1, block, 1, lane);
  const Real spent = Add(o0.friction_energy, o1.friction_energy);
  double* friction_energy = block.friction_energy.data() + lane;
  if (any(hn::Gt(spent, Zero(kDoubles)))) {
    hn::Store(Add(hn::Load(kDoubles, friction_energy), spent), kDoubles, friction_energy);
  }

  // Eqs. (C17), (C18)
  const auto moment = [](const Outcome& o, const State& s) {
    return Sub(Mul(o.traction.n, s.shear), Mul(o.traction.s, s.normal));
  };
  const Real area = Mul(set(0.5), lengths(batch));
  const Real couple = Mul(Mul(Mul(set(0.5), area), Add(moment(o0, s0), moment(o1, s1))), inverse_length);
  Later::fetch(later.slots, 0, 16);
  const auto end_force = [&](Real w0, Real w1) {
    const Real n = Add(Mul(w0, o0.traction.n), Mul(w1, o1.traction.n));
    const Real t = Add(Mul(w0, o0.traction.s), Mul(w1, o1.traction.s));
    return Mul(area, n) * normal + Mul(area, t) * tangent;
  };
  const Points f1 = end_force(near, far), f2 = end_force(far, near), turn = couple * normal;
  const Points left1 = f1 - turn, left2 = f2 + turn, right2 = turn - f2,
               right1 = Points{Zero(kDoubles), Zero(kDoubles)} - (f1 + turn);
  hn::StoreInterleaved4(left1.x, left1.y, left2.x, left2.y, kDoubles, forces + 4 * lane);
  hn::StoreInterleaved4(right2.x, right2.y, right1.x, right1.y, kDoubles, forces + 4 * (kPacked + lane));
  HWY_ALIGN std::uint8_t bits[8] = {};
  hn::StoreMaskBits(kDoubles, hn::Or(o0.breaks, o1.breaks), bits);
  return bits[0];
}

/// Reads the modes of an edge's points that have just failed: D is 1.
edge_update::Breakage breakage_of(const BondedContacts& contacts, std::size_t c) {
  edge_update::Breakage breakage{static_cast<int>(c), {}};
  const std::array<PointState, 2> points = contacts.memory.load(c);
  const LawParameters law = law_of(contacts, c);
  for (std::size_t q = 0; q < 2; ++q) {
    if (points[q].damage >= 1.0)
      breakage.points[q] = consistent_law::break_mode(points[q].normal, points[q].hardening, law);
  }
  return breakage;
}

/// The strengths of a register's contacts.
template <Contacts kKind>
HWY_INLINE Strengths strengths_of(const BondedContacts& contacts, std::size_t contact, const Law& law) {
  if (kKind == Contacts::base || contacts.strengths.empty()) return law.strengths;
  return scaled(law.strengths, hn::Load(kDoubles, &contacts.strengths[contact / kPacked].factor[contact % kPacked]));
}

/// Eight contacts with the vector kernel; the lanes of unbroken contacts of which a point breaks now, one bit each.
template <Contacts kKind>
HWY_INLINE unsigned update_packed(BondedContacts& contacts, std::size_t first, std::size_t count,
                                  const ContactPass& pass, const Law& law) {
  PackedPoints& block = contacts.memory.packed[first / kPacked];
  double* forces = &pass.forces[2 * contact_slot(first, 0)].x;
  const Later later(contacts, first, pass.forces);
  unsigned breaks = 0;
  for (std::size_t lane = 0; lane < count; lane += kLanes) {
    const Batch batch{&contacts.edges[first + lane], std::min(kLanes, count - lane)};
    const Strengths strengths = strengths_of<kKind>(contacts, first + lane, law);
    breaks |= update_batch<kKind>(block, lane, batch, pass.position->data(), strengths, law, later, forces) << lane;
  }
  return breaks;
}

/// Copies one contact's memory from one block to another.
void copy_lane(const PackedPoints& from, PackedPoints& to, std::size_t lane) {
  const auto rows = [&](const PackedPoints::Rows& source, PackedPoints::Rows& target) {
    for (std::size_t q = 0; q < 2; ++q) target[q][lane] = source[q][lane];
  };
  rows(from.normal, to.normal);
  rows(from.shear, to.shear);
  rows(from.slip, to.slip);
  rows(from.hardening, to.hardening);
  rows(from.integrity_n, to.integrity_n);
  rows(from.integrity_s, to.integrity_s);
  rows(from.friction, to.friction);
  rows(from.damage, to.damage);
  rows(from.fracture_energy, to.fracture_energy);
  to.friction_energy[lane] = from.friction_energy[lane];
}

/// The same where some, given by their bits, are broken and keep their memory.
template <Contacts kKind>
unsigned update_packed_but(unsigned broken, BondedContacts& contacts, std::size_t first, std::size_t count,
                           const ContactPass& pass, const Law& law) {
  const PackedPoints kept = contacts.memory.packed[first / kPacked];
  const unsigned breaks = update_packed<kKind>(contacts, first, count, pass, law);
  for (std::size_t lane = 0; broken >> lane; ++lane) {
    if (broken >> lane & 1) copy_lane(kept, contacts.memory.packed[first / kPacked], lane);
  }
  return breaks & ~broken;
}

constexpr auto kScalarLaw = [](PointState& s, double n, double t, const LawParameters& p) {
  consistent_law::update(s, n, t, p);
};

/// One block of packed points.
template <Contacts kKind>
void update_block(BondedContacts& contacts, std::size_t first, const ContactPass& pass, const Law& law,
                  PassChanges& changes) {
  const std::size_t count = std::min(kPacked, pass.end - first);
  const unsigned all = (1u << count) - 1;
  unsigned broken = 0;
  for (std::size_t lane = 0; lane < count; ++lane) {
    broken |= static_cast<unsigned>(contacts.broken_index[first + lane] >= 0) << lane;
  }
  unsigned breaks = 0;
  if (broken == 0) {
    breaks = all & update_packed<kKind>(contacts, first, count, pass, law);
  } else if (broken != all) {
    breaks = all & update_packed_but<kKind>(broken, contacts, first, count, pass, law);
  }
  for (std::size_t lane = 0; (broken | breaks) >> lane; ++lane) {
    const std::size_t c = first + lane;
    if (breaks >> lane & 1) changes.begun.push_back(breakage_of(contacts, c));
    if (broken >> lane & 1) {
      changes.count += edge_update::update_broken_edge(contacts, c, *pass.position, pass.time, kScalarLaw, pass.forces);
    }
  }
}

template <Contacts kKind>
PassChanges update_blocks(BondedContacts& contacts, const ContactPass& pass) {
  PassChanges changes;
  const Law law(contacts.law);
  for (std::size_t first = pass.begin; first < pass.end; first += kPacked) {
    update_block<kKind>(contacts, first, pass, law, changes);
  }
  return changes;
}

PassChanges update_range(BondedContacts& contacts, const ContactPass& pass) {
  const bool varied = kind_of(contacts) == Contacts::varied;
  return varied ? update_blocks<Contacts::varied>(contacts, pass) : update_blocks<Contacts::base>(contacts, pass);
}

}  // namespace asperity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asperity {
HWY_EXPORT(update_range);

PassChanges update_contacts_fast(BondedContacts& contacts, const ContactPass& pass) {
  return HWY_DYNAMIC_DISPATCH(update_range)(contacts, pass);
}
}  // namespace asperity
#endif
