#include "core/experiment/softening.hpp"

#include <algorithm>
#include <numbers>

#include "core/contact/consistent_law.hpp"

namespace asperity {

namespace {

/// Stress (MPa) at which shear softens under a pressure (MPa): what Eq. (E6) takes for c_c + p tan(phi).
double shear_peak(const BondedContacts& contacts, const LawParameters& law, double pressure) {
  if (contacts.reading == LawReading::literal) return law.c_c + pressure * law.coulomb;
  if (contacts.form == LawForm::cohesive_frictional) return law.c_c;
  return consistent_law::shear_strength(pressure, law);
}

}  // namespace

NormalisedSeparation normalised_separation(const PointState& point, const BondedContacts& contacts,
                                           std::size_t contact) {
  const LawParameters law = law_of(contacts, contact);
  const double pressure = consistent_law::pressure_at(point.normal, law);
  const double critical_shear = std::numbers::e * shear_peak(contacts, law, pressure) / law.k_s;
  return {std::max(0.0, point.normal) * law.inverse_delta_ct, std::abs(point.shear) / critical_shear};
}

double largest_separation(const BondedContacts& contacts) {
  double size = 0.0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.is_defect(c)) continue;
    for (const PointState& point : contacts.memory.load(c)) {
      size = std::max(size, normalised_separation(point, contacts, c).size());
    }
  }
  return size;
}

int count_separated(const BondedContacts& contacts, double separation, const ParallelLoops& loops) {
  return loops.sum_blocks<int>(contacts.size(), [&](std::size_t begin, std::size_t end) {
    int count = 0;
    for (std::size_t c = begin; c < end; ++c) {
      if (contacts.is_defect(c)) continue;
      for (const PointState& point : contacts.memory.load(c)) {
        if (normalised_separation(point, contacts, c).size() >= separation) ++count;
      }
    }
    return count;
  });
}

}  // namespace asperity
