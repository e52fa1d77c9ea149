#include "core/confrontation/known_confusions.hpp"

#include <algorithm>

namespace asperity {
namespace {

struct Confusion {
  std::string one, other, test;
  bool named_wrongly = false;  ///< In laboratories with a known cause: docs/confrontation.md.
};

const Confusion kConfusions[] = {
    {"platen_friction", "shear_softening", "uniaxial compression between lubricated platens"},
    {"seating", "crack_closure", "unloading and loading again: a seat has closed then, cracks close anew"},
    {"strength_scatter", "initial_defects", "specimens of another size, and counts of acoustic events", true},
    {"strength_scatter", "weak_plane", "cores drilled in another direction", true},
    {"mesh_size", "initial_defects", "runs with finer particles, and specimens of another size", true},
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

}  // namespace

std::vector<std::string> doubles_of(const std::string& id) {
  std::vector<std::string> doubles;
  for (const Confusion& c : kConfusions) {
    if (!c.named_wrongly) continue;
    if (c.one == id) doubles.push_back(c.other);
    if (c.other == id) doubles.push_back(c.one);
  }
  return doubles;
}

std::vector<std::string> known_confusions(const std::vector<std::string>& causes, const MeasuredData& data) {
  std::vector<std::string> sentences;
  for (const Confusion& c : kConfusions) {
    if (among(causes, c.one) && among(causes, c.other))
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
