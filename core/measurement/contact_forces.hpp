#pragma once
#include <vector>

#include "core/contact/bonded_contacts.hpp"
#include "core/contact/general_contact.hpp"
#include "core/measurement/frame.hpp"
#include "core/particles/particles.hpp"

namespace asperity {

/// Centroid of every particle where it is now, mm, Eq. (M13); a particle is one triangle, or the triangles of one
/// grain. Indexed as Particles::grain numbers the particles; the triangles of a joint's elastic part follow, each at
/// triangle_count() plus its number.
std::vector<Vec2> particle_centres(const Particles& particles);

/// Forces between particles that share contact edges, Eq. (M12): the edges of one pair are one contact, bonded
/// as long as one of them is unbroken. Contacts that carry less than 1e-9 of the largest force are left out. Ordered by
/// the pair's first edge.
std::vector<ContactForce> bonded_contact_forces(const BondedContacts& contacts, const Particles& particles,
                                                double thickness_mm);

/// Forces between pieces that met by the contact search, from core/contact's touching triangles.
std::vector<ContactForce> general_contact_forces(const GeneralContacts& general, const Particles& particles,
                                                 double thickness_mm);

}  // namespace asperity
