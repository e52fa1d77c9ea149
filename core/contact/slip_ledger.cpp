#include "core/contact/slip_ledger.hpp"

#include <algorithm>

namespace asperity {

void SlipLedger::start(std::size_t edges) {
  for (int edge : changed_) ledger_[edge] = {};
  changed_.clear();
  if (ledger_.size() != edges) ledger_.assign(edges, {});
}

void SlipLedger::change(int edge, double from, double to, double slip) {
  if (from == to) return;
  EdgeLedger& l = ledger_[edge];
  if (l.empty()) changed_.push_back(edge);
  if (to < from) {
    l.lost += from - to;
    l.lost_slip += (from - to) * slip;
  } else {
    l.gained += to - from;
  }
}

void SlipLedger::settle(const std::vector<ContactMember>& members) {
  for (int edge : changed_) {
    EdgeLedger& l = ledger_[edge];
    if (l.gained <= 0.0) continue;
    const double own = std::min(l.lost, l.gained);
    double slip = l.lost > 0.0 ? own * l.lost_slip / l.lost : 0.0;
    double missing = l.gained - own;
    const ContactMember& member = members[edge / 3];
    for (int neighbour : {member.previous[edge % 3], member.next[edge % 3]}) {
      if (missing <= 0.0 || neighbour < 0) continue;
      EdgeLedger& other = ledger_[neighbour];
      const double taken = std::min(missing, other.lost - other.gained - other.given);
      if (taken <= 0.0) continue;
      slip += taken * other.lost_slip / other.lost;
      other.given += taken;
      missing -= taken;
    }
    l.incoming = slip / l.gained;
  }
}

}  // namespace asperity
