#pragma once
#include <vector>

#include "core/contact/contact_member.hpp"

namespace asperity {

/// What the contacts of one exposed edge lose and gain in length in one step, Eq. (C49).
struct EdgeLedger {
  double lost = 0, lost_slip = 0;  ///< Length that left, and that length times its elastic slip.
  double gained = 0;
  double given = 0;     ///< Of the lost length: passed to a neighbouring edge.
  double incoming = 0;  ///< Elastic slip of the gained length, mean.
  bool empty() const { return lost == 0.0 && gained == 0.0; }
};

/// Passes the elastic slip of lost lengths on to gained ones: first on the same edge, then from the edges next to it.
class SlipLedger {
 public:
  /// Forgets the last step; `edges` is three a member.
  void start(std::size_t edges);

  /// A contact of this edge (3 member + k) changed its length (mm) at this elastic slip (mm).
  void change(int edge, double from, double to, double slip);

  /// Call once when all changes are entered.
  void settle(const std::vector<ContactMember>& members);

  /// Elastic slip that new length on the edge brings along, mm.
  double incoming(int edge) const { return ledger_[edge].incoming; }

 private:
  std::vector<EdgeLedger> ledger_;
  std::vector<int> changed_;  ///< Edges with an entry, in order of entry.
};

}  // namespace asperity
