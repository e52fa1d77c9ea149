#include "core/contact/bonded_kernels.hpp"
#include "core/contact/cohesive_frictional_law.hpp"
#include "core/contact/edge_update.hpp"

namespace asperity {
namespace {

constexpr auto kLiteral = [](PointState& s, double n, double t, const LawParameters& p) {
  literal_law::update(s, n, t, p);
};
constexpr auto kDefault = [](PointState& s, double n, double t, const LawParameters& p) {
  consistent_law::update(s, n, t, p);
};
constexpr auto kCohesiveFrictional = [](PointState& s, double n, double t, const LawParameters& p) {
  cohesive_frictional_law::update(s, n, t, p);
};

template <class Law>
PassChanges update_range(BondedContacts& contacts, const ContactPass& pass, const Law& law) {
  PassChanges changes;
  edge_update::Breakage breakage;
  for (std::size_t c = pass.begin; c < pass.end; ++c) {
    if (contacts.broken_index[c] >= 0) {
      changes.count += edge_update::update_broken_edge(contacts, c, *pass.position, pass.time, law, pass.forces);
    } else if (edge_update::update_whole_edge(contacts, c, *pass.position, law, pass.forces, breakage)) {
      changes.begun.push_back(breakage);
    }
  }
  return changes;
}

}  // namespace

PassChanges update_contacts_reference(BondedContacts& contacts, const ContactPass& pass) {
  if (contacts.reading == LawReading::literal) return update_range(contacts, pass, kLiteral);
  if (contacts.form == LawForm::cohesive_frictional) return update_range(contacts, pass, kCohesiveFrictional);
  return update_range(contacts, pass, kDefault);
}

}  // namespace asperity
