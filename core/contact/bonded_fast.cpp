#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/contact/bonded_fast.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h:
#include <hwy/highway.h>

#include "core/base/simd_points.inl.hpp"
#include "core/contact/bonded_kernels.hpp"
#include "core/contact/consistent_law.hpp"

HWY_BEFORE_NAMESPACE();
namespace asperity::HWY_NAMESPACE {

using hn::Add;
using hn::AllFalse;
using hn::And;
using hn::IfThenElse;
using hn::IfThenElseZero;
using hn::Max;
using hn::Min;
using hn::Mul;
using hn::Neg;
using hn::Sub;
using hn::Zero;
using Lanes = hn::Mask<Doubles>;

constexpr Doubles kDoubles;

HWY_INLINE Real set(double value) { return hn::Set(kDoubles, value); }
HWY_INLINE bool any(Lanes lanes) { return !AllFalse(kDoubles, lanes); }
HWY_INLINE Real clamp(Real value, Real limit) { return Max(Neg(limit), Min(value, limit)); }

/// LawParameters in every lane, with the products and inverses the kernel needs.
struct Law {
  Real k_t, k_s, inverse_k_s, half_k_t, half_inverse_k_s;
  Real cohesion, slope;  ///< e c_c and e tan(phi_c): the normalised curve's factor is their sum over the pressure.
  Real tan_phi, c_c, inverse_delta_ct, range, shear_range;
  explicit Law(const LawParameters& p)
      : k_t(set(p.k_t)),
        k_s(set(p.k_s)),
        inverse_k_s(set(1.0 / p.k_s)),
        half_k_t(set(0.5 * p.k_t)),
        half_inverse_k_s(set(0.5 / p.k_s)),
        cohesion(set(consistent_law::kE * p.c_c)),
        slope(set(consistent_law::kE * p.tan_phi)),
        tan_phi(set(p.tan_phi)),
        c_c(set(p.c_c)),
        inverse_delta_ct(set(p.inverse_delta_ct)),
        range(set(p.kappa_ut - 1.0)),
        shear_range(set(p.kappa_us - 1.0)) {}
};

/// S of Eqs. (D5), (D6) with (1 - D) for `intact`.
HWY_INLINE Real secant_factor(Real kappa, Real intact) {
  const Real one = set(1.0);
  const Real hardening = unit_exp(Min(kappa, one));
  const Lanes beyond = hn::Gt(kappa, one);
  if (HWY_LIKELY(!any(beyond))) return hardening;
  return IfThenElse(beyond, hn::Div(intact, Mul(set(consistent_law::kE), kappa)), hardening);
}

/// path_work() of the scalar law.
HWY_INLINE Real path_work(Real from, Real to, Real path) {
  return Max(Zero(kDoubles), Mul(Mul(set(0.5), Add(from, to)), path));
}

/// One row of points in registers.
struct State {
  Real normal, shear, slip, hardening, integrity_n, integrity_s, friction, damage, fracture_energy;
};

struct Traction {
  Real n, s;
};

/// What one update of eight points leaves behind besides their state.
struct Outcome {
  Traction traction;
  Real friction_energy;  ///< Spent now.
  Lanes breaks;
  // Which rows have changed in any lane: the others are not written back, which spares a large model's memory.
  bool yields = false, rubs = false, weakens = false, softens = false;
};

/// Eq. (D7).
HWY_INLINE void slide_broken_share(State& s, Real shear, Real pressure, const Law& p, Outcome& out) {
  const Real share = Sub(set(1.0), s.integrity_s);
  const Lanes acts = hn::Gt(share, Zero(kDoubles));
  if (!any(acts)) return;
  out.rubs = true;
  const Real stiffness = Mul(share, p.k_s);
  const Real trial = Add(s.friction, Mul(stiffness, Sub(shear, s.shear)));
  const Real after = clamp(trial, Mul(Mul(share, pressure), p.tan_phi));
  const Lanes slides = And(acts, hn::Ne(trial, after));
  if (any(slides)) {
    const Real path = IfThenElseZero(slides, hn::Div(Sub(trial, after), stiffness));
    out.friction_energy = Add(out.friction_energy, path_work(s.friction, after, path));
  }
  s.friction = IfThenElse(acts, after, s.friction);
}

/// Eq. (D8).
HWY_INLINE void hand_over(State& s, Real integrity_s, Real stress_before, Real stress, Real limit, Real moved,
                          const Law& p, Outcome& out) {
  const Real part = Sub(s.integrity_s, integrity_s), share = Sub(set(1.0), s.integrity_s);
  if (!any(hn::Gt(part, Zero(kDoubles)))) return;
  out.rubs = true;
  const Real kept = clamp(stress, limit);
  const Real lost = Max(Zero(kDoubles), Sub(Mul(stress_before, stress), Mul(kept, kept)));
  s.fracture_energy = Add(s.fracture_energy, Mul(Mul(p.half_inverse_k_s, part), lost));
  const Lanes shared = hn::Gt(share, Zero(kDoubles));
  if (any(shared)) {
    // part share / (part + share) (kept - friction / share)^2 with one division
    const Real gap = Sub(Mul(kept, share), s.friction);
    const Real equalised = hn::Div(Mul(Mul(p.half_inverse_k_s, part), Mul(gap, gap)), Mul(share, Add(part, share)));
    s.fracture_energy = Add(s.fracture_energy, IfThenElseZero(shared, equalised));
  }
  const Real taken = Mul(part, kept);
  out.friction_energy = Add(out.friction_energy, path_work(Zero(kDoubles), taken, moved));
  s.friction = Add(s.friction, taken);
  s.integrity_s = integrity_s;
}

/// consistent_law::update() of unbroken points.
HWY_INLINE Outcome update_points(State& s, Real normal, Real shear, const Law& p) {
  const Real zero = Zero(kDoubles), one = set(1.0);
  const Real pressure = Max(zero, Neg(Mul(p.k_t, normal)));
  Outcome out{{zero, zero}, zero, hn::Lt(zero, zero)};
  slide_broken_share(s, shear, pressure, p, out);

  // Eqs. (D2), (D3)
  const Real stress_before = Mul(p.k_s, Sub(s.shear, s.slip));
  const Real traction_before = Mul(s.integrity_s, stress_before);
  const Real trial = Mul(p.k_s, Sub(shear, s.slip));
  const Real strength = Add(p.cohesion, Mul(pressure, p.slope));
  Real shear_secant = secant_factor(s.hardening, one);
  const Real yield = Mul(Mul(strength, s.hardening), shear_secant);
  const Real excess = Sub(hn::Abs(trial), yield);
  const Lanes yields = hn::Gt(excess, zero);
  Real slipped = zero;
  out.yields = any(yields);
  if (out.yields) {
    s.hardening = IfThenElse(yields, Add(s.hardening, hn::Div(excess, strength)), s.hardening);
    shear_secant = secant_factor(s.hardening, one);
    const Real held = hn::CopySign(Mul(Mul(strength, s.hardening), shear_secant), trial);
    slipped = IfThenElseZero(yields, Mul(Sub(trial, held), p.inverse_k_s));
    s.slip = Add(s.slip, slipped);
  }

  // Eqs. (D4)-(D6)
  const Real opening = Max(zero, normal);
  const Lanes open = hn::Gt(opening, zero);
  const Real stress = Mul(p.k_s, Sub(shear, s.slip));
  const bool any_open = any(open);
  Real kappa = s.hardening, kappa_n2 = zero;
  if (any_open) {
    const Real kappa_n = Mul(opening, p.inverse_delta_ct);
    kappa_n2 = Mul(kappa_n, kappa_n);
    kappa = IfThenElse(open, hn::Sqrt(Add(kappa_n2, Mul(s.hardening, s.hardening))), kappa);
  }
  const Lanes softens = hn::Gt(kappa, one);
  out.softens = any(softens);
  if (out.softens) {
    const Real beyond = Sub(kappa, one), tension_share = hn::Div(kappa_n2, Mul(kappa, kappa));
    const Real shear_range = Mul(p.shear_range, hn::Div(p.c_c, Add(p.c_c, Mul(pressure, p.tan_phi))));
    const Real range = Add(Mul(p.range, tension_share), Mul(shear_range, Sub(one, tension_share)));
    const Real present = IfThenElse(hn::Ge(beyond, range), one, hn::Div(beyond, range));
    s.damage = Max(s.damage, IfThenElseZero(softens, present));
  }
  const Real intact = Sub(one, s.damage);
  Real g_s = intact, factor = Mul(intact, shear_secant);
  if (any_open) {
    const Real mixed = secant_factor(kappa, intact);
    factor = IfThenElse(open, mixed, factor);
    g_s = IfThenElse(open, hn::Div(mixed, shear_secant), g_s);
  }
  const Real g_n = Min(s.integrity_n, factor);
  out.weakens = any(hn::Lt(g_n, s.integrity_n));
  if (any_open) {
    const Real released = Mul(Mul(Max(zero, s.normal), opening), Sub(s.integrity_n, g_n));
    s.fracture_energy = Add(s.fracture_energy, Mul(p.half_k_t, released));
  }
  s.integrity_n = g_n;
  hand_over(s, Min(s.integrity_s, g_s), stress_before, stress, Mul(pressure, p.tan_phi), Sub(shear, s.shear), p, out);
  s.fracture_energy = Add(s.fracture_energy, path_work(traction_before, Mul(s.integrity_s, stress), slipped));

  out.traction.n = Sub(Mul(Mul(s.integrity_n, p.k_t), opening), pressure);
  out.traction.s = Add(Mul(s.integrity_s, stress), s.friction);
  out.breaks = hn::Ge(s.damage, one);
  s.normal = normal;
  s.shear = shear;
  return out;
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
HWY_INLINE unsigned update_batch(PackedPoints& block, std::size_t lane, const Batch& batch, const Vec2* position,
                                 const Law& law, const Later& later, double* forces) {
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
  const Outcome o0 = update_points(s0, dot(at0, normal), dot(at0, tangent), law);
  Later::fetch(later.rows, 6, 12);
  const Outcome o1 = update_points(s1, dot(at1, normal), dot(at1, tangent), law);
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
  for (std::size_t q = 0; q < 2; ++q) {
    if (points[q].damage >= 1.0)
      breakage.points[q] = consistent_law::break_mode(points[q].normal, points[q].hardening, contacts.law);
  }
  return breakage;
}

/// Eight contacts with the vector kernel; the lanes of unbroken contacts of which a point breaks now, one bit each.
HWY_INLINE unsigned update_packed(BondedContacts& contacts, std::size_t first, std::size_t count,
                                  const ContactPass& pass, const Law& law) {
  PackedPoints& block = contacts.memory.packed[first / kPacked];
  double* forces = &pass.forces[2 * contact_slot(first, 0)].x;
  const Later later(contacts, first, pass.forces);
  unsigned breaks = 0;
  for (std::size_t lane = 0; lane < count; lane += kLanes) {
    const Batch batch{&contacts.edges[first + lane], std::min(kLanes, count - lane)};
    breaks |= update_batch(block, lane, batch, pass.position->data(), law, later, forces) << lane;
  }
  return breaks;
}

/// The same where some, given by their bits, are broken and keep their memory.
unsigned update_packed_but(unsigned broken, BondedContacts& contacts, std::size_t first, std::size_t count,
                           const ContactPass& pass, const Law& law) {
  std::array<std::array<PointState, 2>, kPacked> kept;
  for (std::size_t lane = 0; broken >> lane; ++lane) kept[lane] = contacts.memory.load(first + lane);
  const unsigned breaks = update_packed(contacts, first, count, pass, law);
  for (std::size_t lane = 0; broken >> lane; ++lane) {
    if (broken >> lane & 1) contacts.memory.store(first + lane, kept[lane]);
  }
  return breaks & ~broken;
}

constexpr auto kScalarLaw = [](PointState& s, double n, double t, const LawParameters& p) {
  consistent_law::update(s, n, t, p);
};

/// One block of packed points.
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
    breaks = all & update_packed(contacts, first, count, pass, law);
  } else if (broken != all) {
    breaks = all & update_packed_but(broken, contacts, first, count, pass, law);
  }
  for (std::size_t lane = 0; (broken | breaks) >> lane; ++lane) {
    const std::size_t c = first + lane;
    if (breaks >> lane & 1) changes.begun.push_back(breakage_of(contacts, c));
    if (broken >> lane & 1) {
      changes.count += edge_update::update_broken_edge(contacts, c, *pass.position, pass.time, kScalarLaw, pass.forces);
    }
  }
}

PassChanges update_range(BondedContacts& contacts, const ContactPass& pass) {
  PassChanges changes;
  const Law law(contacts.law);
  for (std::size_t first = pass.begin; first < pass.end; first += kPacked) {
    update_block(contacts, first, pass, law, changes);
  }
  return changes;
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
