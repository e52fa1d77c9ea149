#include "core/experiment/softening.hpp"

#include <algorithm>
#include <numbers>

namespace asperity {

namespace {

/// How the separation at which shear softens rises with the pressure: tan(phi) of Eq. (E6).
double peak_friction(const BondedContacts& contacts) {
  if (contacts.reading == LawReading::literal) return contacts.law.coulomb;
  return contacts.form == LawForm::cohesive_frictional ? 0.0 : contacts.law.tan_phi;
}

}  // namespace

NormalisedSeparation normalised_separation(const PointState& point, const BondedContacts& contacts) {
  const LawParameters& law = contacts.law;
  const double pressure = std::max(0.0, -law.k_t * point.normal);
  const double critical_shear = std::numbers::e * (law.c_c + pressure * peak_friction(contacts)) / law.k_s;
  return {std::max(0.0, point.normal) * law.inverse_delta_ct, std::abs(point.shear) / critical_shear};
}

double largest_separation(const BondedContacts& contacts) {
  double size = 0.0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    for (const PointState& point : contacts.memory.load(c)) {
      size = std::max(size, normalised_separation(point, contacts).size());
    }
  }
  return size;
}

int count_separated(const BondedContacts& contacts, double separation, const ParallelLoops& loops) {
  return loops.sum_blocks<int>(contacts.size(), [&](std::size_t begin, std::size_t end) {
    int count = 0;
    for (std::size_t c = begin; c < end; ++c) {
      for (const PointState& point : contacts.memory.load(c)) {
        if (normalised_separation(point, contacts).size() >= separation) ++count;
      }
    }
    return count;
  });
}

}  // namespace asperity
