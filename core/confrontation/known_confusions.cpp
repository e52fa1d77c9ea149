#include "core/confrontation/known_confusions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace asperity {
namespace {

using Made = bool (*)(const MeasuredData&);

struct Confusion {
  std::string one, other, test;
  /// Of those that were named wrongly in laboratories with a known cause (docs/confrontation.md): the further test that
  /// tells them apart, and whether it was made.
  std::string design = {};
  Made made = nullptr;

  bool named_wrongly() const { return made != nullptr; }
};

/// Whether there are two fitted tests of one kind that differ so.
bool any_two(const MeasuredData& data, bool (*differ)(const MeasuredTest&, const MeasuredTest&)) {
  for (const MeasuredTest& a : data.tests) {
    for (const MeasuredTest& b : data.tests) {
      const bool fitted = a.use != TestUse::hold_out && b.use != TestUse::hold_out;
      if (fitted && a.experiment == b.experiment && differ(a, b)) return true;
    }
  }
  return false;
}

bool cores_of_two_directions(const MeasuredData& data) {
  return any_two(data, [](const MeasuredTest& a, const MeasuredTest& b) {
    constexpr double kTurned = 45.0, kHalfTurn = 180.0;
    const double between = std::abs(a.preparation.core_angle_deg - b.preparation.core_angle_deg);
    return std::min(between, kHalfTurn - between) >= kTurned;
  });
}

bool specimens_of_two_sizes(const MeasuredData& data) {
  return any_two(data, [](const MeasuredTest& a, const MeasuredTest& b) {
    constexpr double kLarger = 1.8;
    const auto larger = [](const std::optional<double>& x, const std::optional<double>& y) {
      return x && y && *x >= kLarger * *y;
    };
    const bool disc = larger(a.diameter_mm, b.diameter_mm);
    return disc || (larger(a.width_mm, b.width_mm) && larger(a.height_mm, b.height_mm));
  });
}

const Confusion kConfusions[] = {
    {"platen_friction", "shear_softening", "uniaxial compression between lubricated platens"},
    {"seating", "crack_closure", "unloading and loading again: a seat has closed then, cracks close anew"},
    {"strength_scatter", "initial_defects", "specimens of another size, and counts of acoustic events", "half_size",
     specimens_of_two_sizes},
    {"strength_scatter", "weak_plane", "cores drilled in another direction", "rotated_core", cores_of_two_directions},
    {"mesh_size", "initial_defects", "runs with finer particles, and specimens of another size", "half_size",
     specimens_of_two_sizes},
    {"joint_wear", "slip_weakening", "a second pass over the same joint"},
    {"out_of_plane_strips", "block_rotation", "gauges of the dilation in front and at the rear"},
    {"out_of_plane_strips", "shear_softening", "joints of another width, and of one tooth"},
    {"block_rotation", "shear_softening", "gauges of the dilation in front and at the rear, and joints of one tooth"}};

bool among(const std::vector<std::string>& causes, const std::string& id) {
  return std::find(causes.begin(), causes.end(), id) != causes.end();
}

/// Whether any test has a gauge on the specimen, as a column, as the path itself, or behind a number.
bool has_gauge(const MeasuredData& data) {
  const auto on_curve = [](const SpecimenCurve& s) { return !s.curve.gauge_strain.empty(); };
  return std::any_of(data.tests.begin(), data.tests.end(), [&](const MeasuredTest& t) {
    return path_is_gauge(t) || t.results.contains("youngs_modulus_gpa") ||
           std::any_of(t.curves.begin(), t.curves.end(), on_curve);
  });
}

/// Whatever was named wrongly for this one, or this one for it; `tested`: by the test that tells the two apart.
std::vector<std::string> named_wrongly(const std::string& id, const MeasuredData& data, bool tested) {
  std::vector<std::string> others;
  for (const Confusion& c : kConfusions) {
    if (!c.named_wrongly() || c.made(data) != tested) continue;
    if (c.one == id) others.push_back(c.other);
    if (c.other == id) others.push_back(c.one);
  }
  return others;
}

}  // namespace

std::vector<std::string> doubles_of(const std::string& id, const MeasuredData& data) {
  return named_wrongly(id, data, false);
}

std::vector<std::string> tested_doubles_of(const std::string& id, const MeasuredData& data) {
  return named_wrongly(id, data, true);
}

bool is_made(const std::string& design, const MeasuredData& data) {
  return std::any_of(std::begin(kConfusions), std::end(kConfusions),
                     [&](const Confusion& c) { return c.design == design && c.named_wrongly() && c.made(data); });
}

bool decides(const std::string& design, const std::string& one, const std::string& other) {
  return std::any_of(std::begin(kConfusions), std::end(kConfusions), [&](const Confusion& c) {
    return c.design == design && ((c.one == one && c.other == other) || (c.one == other && c.other == one));
  });
}

std::vector<std::string> known_confusions(const std::vector<std::string>& causes, const MeasuredData& data) {
  std::vector<std::string> sentences;
  for (const Confusion& c : kConfusions) {
    if (among(causes, c.one) && among(causes, c.other) && !(c.named_wrongly() && c.made(data)))
      sentences.push_back(c.one + " and " + c.other +
                          " are known to be taken for one another; what tells them apart: " + c.test);
  }
  if (among(causes, "frame_compliance") && !has_gauge(data))
    sentences.push_back(
        "frame_compliance and a lower modulus of the particles are known to be taken for one another between platens; "
        "what tells them apart: a gauge on the specimen");
  return sentences;
}

}  // namespace asperity
