// Elastic forces of triangles and the motion of free nodes in vector registers, for the kernels of core/integrator.
// Include once in every kernel file, after foreach_target.h; the guard lets it through once for each instruction set.
#if defined(ASPERITY_INTEGRATOR_MOTION_SIMD_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_INTEGRATOR_MOTION_SIMD_INL
#undef ASPERITY_INTEGRATOR_MOTION_SIMD_INL
#else
#define ASPERITY_INTEGRATOR_MOTION_SIMD_INL
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "core/base/simd_points.inl.hpp"
#include "core/integrator/system.hpp"

HWY_BEFORE_NAMESPACE();
namespace asperity::HWY_NAMESPACE {

using hn::Add;
using hn::Mul;
using hn::Sub;

constexpr Doubles kDoubles;
constexpr std::size_t kBlock = PackedShapes::kSize;

HWY_INLINE Real set(double value) { return hn::Set(kDoubles, value); }

/// Triangles or nodes of one register.
struct Batch {
  std::size_t first, count;  ///< Lanes beyond the count repeat the last one.
  std::size_t at(std::size_t lane) const { return first + (lane < count ? lane : count - 1); }
};

/// Row of packed shapes.
HWY_INLINE Real shape_row(const PackedShapes::Row& row, const Batch& batch) {
  return hn::Load(kDoubles, row.data() + batch.first % kBlock);
}

using Corners = std::array<Points, 3>;

/// Elastic constants of the triangles in a register.
struct Elasticity {
  Real c11, c12, twice_shear;
  explicit Elasticity(const ElasticConstants& c) : c11(set(c.c11)), c12(set(c.c12)), twice_shear(set(2.0 * c.shear)) {}
  Elasticity(const ElasticConstants& in, const ElasticConstants& out, const hn::Mask<Doubles>& inside)
      : c11(hn::IfThenElse(inside, set(in.c11), set(out.c11))),
        c12(hn::IfThenElse(inside, set(in.c12), set(out.c12))),
        twice_shear(hn::IfThenElse(inside, set(2.0 * in.shear), set(2.0 * out.shear))) {}
};

/// A triangle's motion against its shape: gradients, rotation and Biot strain, Eq. P2.
struct Strain {
  Points gp, gq;
  Real cosine, sine, e11, e22, e12;
};

/// biot_state() of core/particles up to the strain, operation by operation.
HWY_INLINE Strain biot_strain(const PackedShapes& shape, const Batch& batch, const Corners& x) {
  const Points p = x[1] - x[0], q = x[2] - x[0];
  const Points gp{shape_row(shape.g1x, batch), shape_row(shape.g1y, batch)};
  const Points gq{shape_row(shape.g2x, batch), shape_row(shape.g2y, batch)};
  const Real xx = Add(Mul(p.x, gp.x), Mul(q.x, gq.x)), xy = Add(Mul(p.x, gp.y), Mul(q.x, gq.y));
  const Real yx = Add(Mul(p.y, gp.x), Mul(q.y, gq.x)), yy = Add(Mul(p.y, gp.y), Mul(q.y, gq.y));
  const Real a = Add(xx, yy), b = Sub(yx, xy);
  const Real r = hn::Div(set(1.0), hn::Sqrt(Add(Mul(a, a), Mul(b, b))));
  const Real cosine = Mul(a, r), sine = Mul(b, r);
  return {gp,
          gq,
          cosine,
          sine,
          Sub(Add(Mul(cosine, xx), Mul(sine, yx)), set(1.0)),
          Sub(Sub(Mul(cosine, yy), Mul(sine, xy)), set(1.0)),
          Add(Mul(cosine, xy), Mul(sine, yy))};
}

/// Biot stress with its skew part, Eq. P8, as t12 and t21.
struct BiotStress {
  Real t11, t22, t12, t21;
};

/// corner_forces() of core/particles, operation by operation.
HWY_INLINE Corners corner_forces(const PackedShapes& shape, const Batch& batch, const Strain& s, const BiotStress& t) {
  const Real p11 = Sub(Mul(s.cosine, t.t11), Mul(s.sine, t.t21)), p12 = Sub(Mul(s.cosine, t.t12), Mul(s.sine, t.t22));
  const Real p21 = Add(Mul(s.sine, t.t11), Mul(s.cosine, t.t21)), p22 = Add(Mul(s.sine, t.t12), Mul(s.cosine, t.t22));
  const Real minus_area = hn::Neg(shape_row(shape.area, batch));
  const auto force = [&](const Points& g) {
    return Points{Mul(minus_area, Add(Mul(p11, g.x), Mul(p12, g.y))),
                  Mul(minus_area, Add(Mul(p21, g.x), Mul(p22, g.y)))};
  };
  const Points f1 = force(s.gp), f2 = force(s.gq);
  return {Points{Sub(hn::Neg(f1.x), f2.x), Sub(hn::Neg(f1.y), f2.y)}, f1, f2};
}

HWY_INLINE Corners elastic_forces(const PackedShapes& shape, const Batch& batch, const Corners& x,
                                  const Elasticity& c) {
  const Strain s = biot_strain(shape, batch, x);
  const Real t12 = Mul(c.twice_shear, s.e12);
  return corner_forces(
      shape, batch, s,
      {Add(Mul(c.c11, s.e11), Mul(c.c12, s.e22)), Add(Mul(c.c12, s.e11), Mul(c.c11, s.e22)), t12, t12});
}

/// set_stress() of core/particles.
HWY_INLINE BiotStress plastic_stress(const Elasticity& c, Real e11, Real e22, Real e12, Real difference, Real shear) {
  const Real t11 = Add(Mul(c.c11, e11), Mul(c.c12, e22)), t22 = Add(Mul(c.c12, e11), Mul(c.c11, e22));
  const Real t12 = Mul(c.twice_shear, e12);
  const Real twist = Sub(Mul(Sub(t11, t22), shear), Mul(Mul(set(2.0), t12), difference));
  const Real spin = hn::Div(hn::Neg(twist), Add(Add(set(2.0), e11), e22));
  return {t11, t22, Add(t12, spin), Sub(t12, spin)};
}

/// update_triangle() of core/particles, operation by operation; lanes of infinite half_yield stay elastic.
HWY_INLINE Corners yielding_forces(const PackedShapes& shape, PackedPlasticity& memory, const Batch& batch,
                                   const Corners& x, const Elasticity& c, Real virgin) {
  const Strain s = biot_strain(shape, batch, x);
  const std::size_t at = batch.first % kBlock;
  Real difference = hn::Load(kDoubles, memory.difference.data() + at);
  Real shear = hn::Load(kDoubles, memory.shear.data() + at);
  Real e11 = Sub(s.e11, difference), e22 = Add(s.e22, difference), e12 = Sub(s.e12, shear);
  const Real t11 = Add(Mul(c.c11, e11), Mul(c.c12, e22)), t22 = Add(Mul(c.c12, e11), Mul(c.c11, e22));
  const Real square = Add(Mul(difference, difference), Mul(shear, shear));
  const Real half_yield = Mul(virgin, Add(set(1.0), Mul(set(kLocking), square)));
  const Real t12 = Mul(c.twice_shear, e12), half = Mul(set(0.5), Sub(t11, t22));
  const Real radius = hn::Sqrt(Add(Mul(half, half), Mul(t12, t12)));
  const hn::Mask<Doubles> yields = hn::Gt(radius, half_yield);
  if (!hn::AllFalse(kDoubles, yields)) {
    const Real compliance = hn::Div(set(1.0), c.twice_shear);
    const Real excess = hn::IfThenElseZero(yields, Mul(compliance, Sub(set(1.0), hn::Div(half_yield, radius))));
    const Real normal = Mul(excess, half), sheared = Mul(excess, t12);
    difference = Add(difference, normal);
    shear = Add(shear, sheared);
    e11 = Sub(e11, normal);
    e22 = Add(e22, normal);
    e12 = Sub(e12, sheared);
    const Real spent = Mul(Mul(Mul(set(2.0), half_yield), compliance), Sub(radius, half_yield));
    const Real work = hn::Load(kDoubles, memory.work.data() + at);
    hn::Store(Add(work, hn::IfThenElseZero(yields, spent)), kDoubles, memory.work.data() + at);
    hn::Store(difference, kDoubles, memory.difference.data() + at);
    hn::Store(shear, kDoubles, memory.shear.data() + at);
  }
  return corner_forces(shape, batch, s, plastic_stress(c, e11, e22, e12, difference, shear));
}

/// Lanes whose bits are set.
HWY_INLINE hn::Mask<Doubles> lanes_of(unsigned bits) {
  HWY_ALIGN double flags[kLanes];
  for (std::size_t lane = 0; lane < kLanes; ++lane) flags[lane] = bits >> lane & 1 ? 1.0 : 0.0;
  return hn::Gt(hn::Load(kDoubles, flags), set(0.0));
}

/// Numbers that every node needs.
struct Step {
  Real dt, half_dt, two_over_dt, damping;
  explicit Step(const System& system)
      : dt(set(system.time_step)),
        half_dt(set(0.5 * system.time_step)),
        two_over_dt(set(2.0 / system.time_step)),
        damping(set(system.local_damping)) {}
};

/// Eq. (I4), as damping_force() does.
HWY_INLINE Real damping_force(Real force, Real coefficient, Real mean_velocity, Real impulse) {
  const Real limit = Mul(impulse, hn::Abs(mean_velocity));
  return hn::Neg(hn::CopySign(hn::Min(Mul(coefficient, hn::Abs(force)), limit), mean_velocity));
}

/// Sums of eight lanes, so that they do not depend on how many a register holds.
struct LaneSums {
  HWY_ALIGN double damping[kBlock] = {}, kinetic[kBlock] = {}, fastest[kBlock] = {};
};

/// What three nodes of a triangle add to them.
struct Addends {
  Real damping, kinetic, fastest;
};

/// Eqs. (I1)-(I4), as move_free_node() does.
HWY_INLINE Points move_free_nodes(const Points& before, const Points& force, Real m, const Step& step, Addends& sums) {
  const Real per_mass = hn::Div(step.dt, m);
  const Points trial = before + per_mass * force;
  const Points mean = set(0.5) * (before + trial);
  const Real impulse = Mul(m, step.two_over_dt);
  const Points damping{damping_force(force.x, step.damping, mean.x, impulse),
                       damping_force(force.y, step.damping, mean.y, impulse)};
  const Points v = trial + per_mass * damping;
  sums.damping = Sub(sums.damping, Mul(step.half_dt, dot(damping, before + v)));
  sums.kinetic = Add(sums.kinetic, Mul(Mul(set(0.5), m), dot(before, v)));
  sums.fastest = hn::Max(sums.fastest, dot(v, v));
  return v;
}

constexpr unsigned kAllLanes = (1u << kLanes) - 1;

/// Adds the lanes in `bits`.
HWY_INLINE void add_lanes(Addends addends, unsigned bits, LaneSums& sums, std::size_t lane) {
  if (bits != kAllLanes) {
    const hn::Mask<Doubles> counted = lanes_of(bits);
    addends = {hn::IfThenElseZero(counted, addends.damping), hn::IfThenElseZero(counted, addends.kinetic),
               hn::IfThenElseZero(counted, addends.fastest)};
  }
  const auto add = [&](double* sum, Real value) { hn::Store(Add(hn::Load(kDoubles, sum), value), kDoubles, sum); };
  add(sums.damping + lane, addends.damping);
  add(sums.kinetic + lane, addends.kinetic);
  hn::Store(hn::Max(hn::Load(kDoubles, sums.fastest + lane), addends.fastest), kDoubles, sums.fastest + lane);
}

/// Adds all eight lanes, in their order.
HWY_INLINE void add_to(NodeSums& sums, const LaneSums& lanes) {
  for (std::size_t lane = 0; lane < kBlock; ++lane) {
    sums.damping += lanes.damping[lane];
    sums.kinetic += lanes.kinetic[lane];
    sums.fastest = std::max(sums.fastest, lanes.fastest[lane]);
  }
}

}  // namespace asperity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
