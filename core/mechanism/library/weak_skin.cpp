#include <algorithm>

#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

struct Segment {
  Vec2 a, b;
};

/// The edges of the mesh that have no triangle beyond: the specimen's outline, and a joint's two faces.
std::vector<Segment> outline_segments(const Mesh& mesh) {
  std::vector<Segment> segments;
  for (const MeshEdge& e : mesh_edges(mesh)) {
    if (e.right < 0) segments.push_back({mesh.vertices[e.a], mesh.vertices[e.b]});
  }
  return segments;
}

double distance(Vec2 point, const Segment& s) {
  const Vec2 along = s.b - s.a;
  const double t = std::clamp(dot(point - s.a, along) / dot(along, along), 0.0, 1.0);
  return norm(point - (s.a + t * along));
}

bool lies_within(Vec2 point, double depth, const std::vector<Segment>& outline) {
  return std::any_of(outline.begin(), outline.end(), [&](const Segment& s) { return distance(point, s) <= depth; });
}

/// Eq. (X12). Contacts near a surface are weaker.
const Registered kEntry{{
    .declaration =
        {.id = "weak_skin",
         .title = "a weak skin along the surface",
         .equation = "(X12) factor f within a depth of the specimen's outline, or of the joint",
         .source =
             "Barton & Choubey 1977, Rock Mech. 10, 1-54 (wall strength of weathered joints); casting skins of plaster",
         .reason = "f = 0.5 in 1.5 mm: weathering and casting soften the outermost grains",
         .expectation = "a joint's peak at low normal stress down, early dilation lost",
         .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
         .parameters = {{.key = "strength_ratio",
                         .unit = "1",
                         .description = "Strength within the skin over that below",
                         .lowest = 0.05,
                         .highest = 1.0,
                         .strong = 0.5,
                         .neutral = 1.0},
                        {.key = "depth_mm",
                         .unit = "mm",
                         .description = "Of the skin",
                         .lowest = 0.01,
                         .highest = 100.0,
                         .strong = 1.5}},
         .needs_breakable_particles = true},
    .mark =
        [](const MechanismValues& value, const ContactSite& site, ContactMarks& marks) {
          const std::vector<Segment> outline = outline_segments(site.mesh);
          const double depth = value("depth_mm");
          for (std::size_t c = 0; c < site.contacts.size(); ++c) {
            const ContactEdge& edge = site.contacts.edges[c];
            const Vec2 one = site.particles.reference(edge.left1), other = site.particles.reference(edge.left2);
            if (lies_within(one, depth, outline) || lies_within(other, depth, outline)) {
              marks.strength[c] *= value("strength_ratio");
            }
          }
        },
}};

}  // namespace
}  // namespace asperity
