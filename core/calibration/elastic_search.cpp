#include "core/calibration/elastic_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/units.hpp"

namespace asperity {
namespace {

/// Eq. (K27) for the task's window and law.
double hardening(const ElasticTask& task) {
  if (task.reading == ElasticReading::initial) return 1.0;
  const ContactConfig& c = task.config.contacts;
  const bool pressed = c.law.reading == LawReading::consistent || c.law.shear_peak == ShearPeak::coulomb;
  return shear_hardening(modulus_window(task.config, task.target.uniaxial_strength_mpa), c.cohesion_mpa,
                         pressed ? std::tan(c.friction_angle_deg * units::kRadPerDeg) : 0.0);
}

}  // namespace

ElasticSearch::ElasticSearch(const ElasticTask& task)
    : bounds_(task.bounds),
      policy_(task.ratio),
      plane_(task.config.experiment.plane),
      edge_mm_(task.config.particles.edge_mm),
      hardening_(hardening(task)),
      tolerance_(task.tolerance),
      target_{task.target.youngs_modulus_gpa * units::kMpaPerGpa, task.target.poissons_ratio},
      greatest_modulus_(bounds_.greatest_modulus_factor * target_.youngs_modulus) {
  trial_.contacts = stiffness_by_rule(task.stiffness, target_material(task), edge_mm_, plane_);
  start(ElasticUnknowns::particle, estimate());
}

/// 1/E' and nu'/E', 1/MPa.
Vec2 ElasticSearch::compliance(Elasticity material) const {
  const Elasticity e = plane_elasticity(material, plane_);
  return {1.0 / e.youngs_modulus, e.poissons_ratio / e.youngs_modulus};
}

/// What the particles need by the closed form with the present contacts; the first is not positive where those alone
/// are too compliant.
Vec2 ElasticSearch::estimate() const {
  const ContactStiffness hardened{trial_.contacts.k_t, trial_.contacts.ratio / hardening_};
  return compliance(estimate_particle(target_, hardened, edge_mm_, plane_));
}

ElasticTrial ElasticSearch::trial_at(Vec2 x) const {
  ElasticTrial next = trial_;
  const double in_plane = unknowns_ == ElasticUnknowns::particle
                              ? x.y / x.x
                              : plane_elasticity({1.0, trial_.particle.poissons_ratio}, plane_).poissons_ratio;
  next.particle = material_elasticity({1.0 / x.x, in_plane}, plane_);
  if (unknowns_ == ElasticUnknowns::ratio) {
    next.contacts.ratio = contact_share(edge_mm_) * hardening_ / (x.y * trial_.contacts.k_t);
  }
  return next;
}

/// With the closed form's slopes.
void ElasticSearch::start(ElasticUnknowns unknowns, Vec2 x) {
  unknowns_ = unknowns;
  slopes_ = {{1.0, 0.0}, {0.0, 1.0}};
  if (unknowns == ElasticUnknowns::ratio) {
    slopes_ = {{1.0, 1.0}, {plane_elasticity({1.0, trial_.particle.poissons_ratio}, plane_).poissons_ratio, 1.0}};
  }
  last_x_.reset();
  propose(x);
}

void ElasticSearch::hold_poissons_ratio(double value) {
  trial_.particle.poissons_ratio = value;
  if (policy_ == RatioPolicy::fixed) return start(ElasticUnknowns::modulus, {estimate().x, 0.0});
  const double ratio = hardening_ * estimate_stiffness_ratio(target_, value, trial_.contacts.k_t, edge_mm_, plane_);
  const double low = bounds_.least_stiffness_ratio, high = bounds_.greatest_stiffness_ratio;
  if (ratio <= 0.0 || ratio > high) return hold_stiffness_ratio(high);
  if (ratio < low) return hold_stiffness_ratio(low);
  trial_.contacts.ratio = ratio;
  start(ElasticUnknowns::ratio, {estimate().x, contact_share(edge_mm_) * hardening_ / (ratio * trial_.contacts.k_t)});
}

void ElasticSearch::hold_stiffness_ratio(double value) {
  trial_.contacts.ratio = value;
  start(ElasticUnknowns::modulus, {estimate().x, 0.0});
}

Vec2 ElasticSearch::Slopes::solve(Vec2 v) const {
  const double determinant = cross(first, second);
  return {(v.x * second.y - v.y * first.y) / determinant, (first.x * v.y - second.x * v.x) / determinant};
}

/// Makes x the next trial, or what its bounds leave of it.
void ElasticSearch::propose(Vec2 x) {
  const ElasticTrial next = trial_at(x);
  const bool real = x.x > 0.0;
  if (unknowns_ == ElasticUnknowns::particle) {
    // In the plane, where the order of Poisson's ratios holds below -1 too.
    const double low = bounds_.least_poissons_ratio, high = bounds_.greatest_poissons_ratio;
    if (!real || x.y / x.x < plane_elasticity({1.0, low}, plane_).poissons_ratio) return hold_poissons_ratio(low);
    if (x.y / x.x > plane_elasticity({1.0, high}, plane_).poissons_ratio) return hold_poissons_ratio(high);
  }
  if (unknowns_ == ElasticUnknowns::ratio) {
    const double ratio = next.contacts.ratio;
    if (x.y <= 0.0 || ratio > bounds_.greatest_stiffness_ratio)
      return hold_stiffness_ratio(bounds_.greatest_stiffness_ratio);
    if (ratio < bounds_.least_stiffness_ratio) return hold_stiffness_ratio(bounds_.least_stiffness_ratio);
  }
  x_ = x;
  trial_ = next;
  at_greatest_modulus_ = !real || next.particle.youngs_modulus > greatest_modulus_;
  if (at_greatest_modulus_) trial_.particle.youngs_modulus = greatest_modulus_;
}

/// Broyden's update: the least change that explains what the last step did.
void ElasticSearch::update_slopes(Vec2 y) {
  if (last_x_) {
    const Vec2 dx = x_ - *last_x_;
    const Vec2 missed = (1.0 / dot(dx, dx)) * (y - *last_y_ - slopes_.times(dx));
    slopes_.first += missed.x * dx;
    slopes_.second += missed.y * dx;
  }
  last_x_ = x_;
  last_y_ = y;
}

bool ElasticSearch::advance(Elasticity assembly) {
  if (at_greatest_modulus_) return false;
  Vec2 y = compliance(assembly), wanted = compliance(target_);
  if (unknowns_ == ElasticUnknowns::modulus) {
    wanted = compliance({target_.youngs_modulus, assembly.poissons_ratio});  // E alone counts, whatever nu is
    y.y = wanted.y = 0.0;
    if (std::abs(y.x / wanted.x - 1.0) < kStopShare * tolerance_) return false;
  }
  update_slopes(y);
  const Vec2 x = x_ + slopes_.solve(wanted - y);
  if (!std::isfinite(x.x) || !std::isfinite(x.y)) return false;
  propose(x);
  return true;
}

}  // namespace asperity
