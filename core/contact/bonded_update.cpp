#include "core/contact/bonded_kernels.hpp"

namespace asperity {
namespace {

/// Puts the edges that began to break on the list; returns how many broke altogether.
int enter_breakages(BondedContacts& contacts, const std::vector<edge_update::Breakage>& begun,
                    const std::vector<Vec2>& position, double time) {
  int whole = 0;
  for (const edge_update::Breakage& breakage : begun) {
    BrokenEdge& broken = contacts.broken_edge(breakage.contact);
    broken.points = breakage.points;
    if (broken.points[0] == BreakMode::none || broken.points[1] == BreakMode::none) continue;
    edge_update::note_breakage(broken, contact_frame(contacts.edges[breakage.contact], position), time);
    ++whole;
  }
  return whole;
}

}  // namespace

int update_contacts(BondedContacts& contacts, const std::vector<Vec2>& position, double time,
                    const ParallelLoops& loops, std::span<Vec2> forces, Kernel kernel) {
  const bool vectorised = contacts.reading == LawReading::consistent && contacts.form == LawForm::damage_slip;
  const bool fast = kernel == Kernel::fast && vectorised;
  const PassChanges changes = loops.sum_blocks<PassChanges>(contacts.size(), [&](std::size_t begin, std::size_t end) {
    const ContactPass pass{begin, end, &position, time, forces};
    return fast ? update_contacts_fast(contacts, pass) : update_contacts_reference(contacts, pass);
  });
  return changes.count + enter_breakages(contacts, changes.begun, position, time);
}

}  // namespace asperity
