#include "core/contact/law_paths.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/closed_forms.hpp"
#include "core/contact/cohesive_frictional_law.hpp"
#include "core/contact/consistent_law.hpp"
#include "core/contact/literal_law.hpp"

namespace asperity {
namespace {

constexpr int kSteps = 1500;            // of a path's whole length
constexpr int kHalvings = 60;           // of a bisection: to the last bit
constexpr double kJustClosed = 1e-12;   // parts of delta_ct
constexpr double kFirstStep = 0.01;     // of a search, parts of the critical separation
constexpr double kStepGrowth = 1.01;    // of a search
constexpr double kLongestSearch = 1e6;  // critical separations: no law's softening reaches as far

/// Separation of a contact point: normal, shear; mm.
struct Separation {
  double normal, shear;
};

PathPoint seen(const PointState& s, PathLeg leg) {
  return {s.normal, s.shear, s.traction_n, s.traction_s, s.damage, s.broken != BreakMode::none, leg};
}

/// A contact point that is moved and watched.
class Driver {
 public:
  explicit Driver(const DrivenLaw& law) : law_(law) { path_.push_back(seen(state_, PathLeg::loading)); }

  void step(Separation to, PathLeg leg = PathLeg::loading) {
    update_point(state_, to.normal, to.shear, law_);
    path_.push_back(seen(state_, leg));
  }

  /// In a straight line, in steps no longer than `step` (mm).
  void move(Separation to, double step_mm, PathLeg leg = PathLeg::loading) {
    const Separation from{state_.normal, state_.shear};
    const double way = std::hypot(to.normal - from.normal, to.shear - from.shear);
    const int steps = std::max(1, static_cast<int>(std::ceil(way / step_mm)));
    for (int i = 1; i < steps; ++i) {
      const double part = static_cast<double>(i) / steps;
      step({std::lerp(from.normal, to.normal, part), std::lerp(from.shear, to.shear, part)}, leg);
    }
    step(to, leg);
  }

  /// Back in slip until the shear traction is gone.
  void unload_shear(double step_mm) {
    while (state_.traction_s > 0.0 && state_.shear > 0.0)
      step({state_.normal, std::max(0.0, state_.shear - step_mm)}, PathLeg::unloading);
  }

  /// Forgets the path so far, so that it begins at the present point.
  void begin_here() { path_ = {seen(state_, PathLeg::loading)}; }

  const PointState& state() const { return state_; }
  LawPath take() { return std::move(path_); }

 private:
  const DrivenLaw& law_;
  PointState state_;
  LawPath path_;
};

using Condition = std::function<bool(const PointState&)>;

/// The last point of a straight way between a state and a separation at which the condition does not hold yet.
PathPoint last_before(const PointState& from, Separation to, const DrivenLaw& law, const Condition& holds) {
  double without = 0.0, with = 1.0;
  PointState found = from;
  for (int i = 0; i < kHalvings; ++i) {
    const double part = 0.5 * (without + with);
    PointState s = from;
    update_point(s, std::lerp(from.normal, to.normal, part), std::lerp(from.shear, to.shear, part), law);
    if (holds(s)) {
      with = part;
    } else {
      without = part;
      found = s;
    }
  }
  return seen(found, PathLeg::loading);
}

double size_of(const PathPoint& p, bool open) {
  return open ? std::hypot(p.normal_traction, p.shear_traction) : std::abs(p.shear_traction);
}

/// Follows `way` (separation over a parameter that grows from 0, 1 being critical) until the bond breaks.
template <class Way>
LawLimits follow(const DrivenLaw& law, PointState s, bool open, const Way& way) {
  LawLimits limits;
  bool damaged = false;
  const auto consider = [&](const PathPoint& p) {
    if (size_of(p, open) > size_of(limits.strongest, open)) limits.strongest = p;
  };
  for (double at = kFirstStep; at < kLongestSearch; at = std::max(at + kFirstStep, at * kStepGrowth)) {
    const PointState before = s;
    update_point(s, way(at).normal, way(at).shear, law);
    if (!damaged && s.damage > 0.0) {
      limits.first_damage = last_before(before, way(at), law, [](const PointState& p) { return p.damage > 0.0; });
      consider(limits.first_damage);
      damaged = true;
    }
    if (s.broken != BreakMode::none) {
      limits.last_bonded =
          last_before(before, way(at), law, [](const PointState& p) { return p.broken != BreakMode::none; });
      break;
    }
    consider(seen(s, PathLeg::loading));
  }
  return limits;
}

Separation mixed_separation(const DrivenLaw& law, double angle, double size) {
  return {size * std::cos(angle) * law.parameters.delta_ct, size * std::sin(angle) * law.parameters.delta_cs};
}

}  // namespace

DrivenLaw driven_law(const RunConfig& config) {
  return {law_parameters(config), config.contacts.law.reading, config.contacts.law.form};
}

DrivenLaw driven_law(RunConfig config, const LawConfig& law) {
  config.contacts.law = law;
  return driven_law(config);
}

void update_point(PointState& s, double normal, double shear, const DrivenLaw& law) {
  if (law.reading == LawReading::literal) {
    literal_law::update(s, normal, shear, law.parameters);
  } else if (law.form == LawForm::cohesive_frictional) {
    cohesive_frictional_law::update(s, normal, shear, law.parameters);
  } else {
    consistent_law::update(s, normal, shear, law.parameters);
  }
}

LawPath opening_path(const DrivenLaw& law, double last, const std::vector<double>& unload_at,
                     const std::vector<double>& through) {
  std::vector<double> stops = through;
  stops.insert(stops.end(), unload_at.begin(), unload_at.end());
  stops.push_back(last);
  std::sort(stops.begin(), stops.end());
  Driver driver(law);
  for (const double stop : stops) {
    driver.move({stop, 0.0}, last / kSteps);
    if (std::find(unload_at.begin(), unload_at.end(), stop) == unload_at.end()) continue;
    driver.move({0.0, 0.0}, last / kSteps, PathLeg::unloading);
    driver.move({stop, 0.0}, last / kSteps, PathLeg::reloading);
  }
  return driver.take();
}

double closed_separation(const DrivenLaw& law, double pressure) {
  const auto pressure_at = [&](double normal) {
    PointState s;
    update_point(s, normal, 0.0, law);
    return -s.traction_n;
  };
  double less = -kJustClosed * law.parameters.delta_ct, more = less;
  while (pressure_at(more) < pressure) more *= 2.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (less + more);
    (pressure_at(middle) < pressure ? less : more) = middle;
  }
  return more;
}

LawPath closing_path(const DrivenLaw& law, double pressure) {
  const double last = closed_separation(law, pressure);
  Driver driver(law);
  driver.move({last, 0.0}, -last / kSteps);
  return driver.take();
}

LawPath shear_path(const DrivenLaw& law, double pressure, double last, const std::vector<double>& unload_at) {
  const double normal = closed_separation(law, pressure);
  Driver driver(law);
  driver.step({normal, 0.0});
  driver.begin_here();
  for (const double slip : unload_at) {
    driver.move({normal, slip}, last / kSteps);
    driver.unload_shear(last / kSteps);
    driver.move({normal, slip}, last / kSteps, PathLeg::reloading);
  }
  driver.move({normal, last}, last / kSteps);
  return driver.take();
}

LawLimits limits_in_opening(const DrivenLaw& law, double angle) {
  return follow(law, {}, true, [&](double size) { return mixed_separation(law, angle, size); });
}

LawLimits limits_under_pressure(const DrivenLaw& law, double pressure) {
  PointState s;
  const double normal = closed_separation(law, pressure);
  update_point(s, normal, 0.0, law);
  LawLimits limits = follow(law, s, false, [&](double size) {
    return Separation{normal, size * law.parameters.delta_cs};
  });
  limits.friction = shear_path(law, pressure, 2.0 * limits.last_bonded.slip).back().shear_traction;
  return limits;
}

LawPath mixed_path(const DrivenLaw& law, double angle) {
  const PathPoint end = limits_in_opening(law, angle).last_bonded;
  Driver driver(law);
  driver.move({end.opening, end.slip}, std::hypot(end.opening, end.slip) / kSteps);
  return driver.take();
}

double loading_work(const LawPath& path) {
  double work = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PathPoint &a = path[i - 1], &b = path[i];
    if (b.leg != PathLeg::loading) continue;
    work += 0.5 * (a.normal_traction + b.normal_traction) * (b.opening - a.opening) +
            0.5 * (a.shear_traction + b.shear_traction) * (b.slip - a.slip);
  }
  return work;
}

}  // namespace asperity
