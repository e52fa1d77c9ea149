#include "core/contact/surface_wear.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/touch_entry.hpp"

namespace asperity {

bool wears(const GeneralContactLaw& law) {
  return std::any_of(law.surfaces.begin(), law.surfaces.end(),
                     [](const SurfaceLaw& s) { return s.wear.residual_share != 1.0; });
}

double worn_friction(const SurfaceLaw& law, double wear) {
  if (wear == 0.0) return law.tan_phi;
  const double residual = law.wear.residual_share;
  return law.tan_phi * (residual + (1.0 - residual) * std::exp(-wear / law.wear.slip_mm));
}

double wear_of_slip(const FrictionWear& wear, double slip, double normal, double length) {
  if (wear.reference_stress_mpa <= 0.0) return slip;
  return slip * (2.0 * normal / length) / wear.reference_stress_mpa;
}

void add_wear(GeneralContacts& general) {
  if (general.wear.empty()) return;
  general.rubbing.resize(general.wear.size());
  for (const Touch& touch : general.touches) {
    for (int i = 0; i < 6; ++i) {
      const EdgeFriction& f = touch.friction[i];
      const Entry entry = entry_of(general.pairs[touch.pair], i);
      if (touch.parts[i].m0 <= 0.0 || !is_exposed(general, entry)) continue;
      const int edge = 3 * general.members[entry.own].triangle + entry.k;
      if (general.rubbing[edge].length == 0.0) general.rubbing_edges.push_back(edge);
      general.rubbing[edge].length += f.length;
      general.rubbing[edge].wear += f.length * f.wear;
    }
  }
  for (const int edge : general.rubbing_edges) {
    general.wear[edge] += general.rubbing[edge].wear / general.rubbing[edge].length;
    general.rubbing[edge] = {};
  }
  general.rubbing_edges.clear();
}

}  // namespace asperity
