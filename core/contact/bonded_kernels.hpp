#pragma once
#include <span>
#include <vector>

#include "core/contact/bonded_contacts.hpp"
#include "core/contact/edge_update.hpp"

/// The two kernels of update_contacts(), each over a range of contacts. Internal to core/contact.
namespace asperity {

/// One range of contacts, [begin, end) with begin a multiple of kPacked.
struct ContactPass {
  std::size_t begin, end;
  const std::vector<Vec2>* position;
  double time;  ///< s
  std::span<Vec2> forces;
};

/// What happened in a range: edges that begin to break enter the list afterwards, so that its order is that of the
/// contacts for any number of threads.
struct PassChanges {
  int count = 0;  ///< Edges already on the list that broke or were released.
  std::vector<edge_update::Breakage> begun;
  PassChanges& operator+=(const PassChanges& other) {
    count += other.count;
    begun.insert(begun.end(), other.begun.begin(), other.begun.end());
    return *this;
  }
};

PassChanges update_contacts_reference(BondedContacts& contacts, const ContactPass& pass);

/// The default law in vector registers; broken edges one by one as the reference does them.
PassChanges update_contacts_fast(BondedContacts& contacts, const ContactPass& pass);

}  // namespace asperity
