#include "core/experiment/checkpoint_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace asperity {
namespace {

/// Farthest a platen may stand, and the most it may have moved, over the specimen's height.
constexpr double kFarthestPlaten = 10.0;
/// Farthest a loose piece may have flown, mm.
constexpr double kFarthestPiece = 1e9;
constexpr std::int64_t kMostSteps = std::int64_t{1} << 53;

bool is_index(int i, std::size_t size) { return i >= 0 && static_cast<std::size_t>(i) < size; }
bool is_index_or_none(int i, std::size_t size) { return i == -1 || is_index(i, size); }
bool within(double x, double low, double high) { return x >= low && x <= high; }  // false for NaN
bool is_length(double x) { return within(x, 0.0, std::numeric_limits<double>::max()); }

bool all_finite(std::initializer_list<double> values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

bool all_within(const std::vector<Vec2>& vectors, double most) {
  return std::all_of(vectors.begin(), vectors.end(),
                     [&](const Vec2& v) { return within(v.x, -most, most) && within(v.y, -most, most); });
}

bool same_sizes(const System& a, const System& b) {
  return a.particles.position.size() == b.particles.position.size() &&
         a.particles.velocity.size() == b.particles.velocity.size() &&
         a.particles.plasticity.size() == b.particles.plasticity.size() &&
         a.platen_shear.size() == b.platen_shear.size() &&
         a.contacts.memory.packed.size() == b.contacts.memory.packed.size() &&
         a.contacts.memory.literal.size() == b.contacts.memory.literal.size() &&
         a.contacts.broken_index.size() == b.contacts.broken_index.size() &&
         a.general.wear.size() == b.general.wear.size();
}

/// A byte that is neither 0 nor 1 is no bool, and must not even be looked at as one.
bool same_flag(const bool& a, const bool& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Steepest slope of a face that turns freely.
constexpr double kSteepestFace = 1e3;

bool face_holds(const FaceTurn& read, const FaceTurn& fresh) {
  const bool same = read.pivot_x == fresh.pivot_x && read.reach == fresh.reach && read.inertia == fresh.inertia;
  return same && (fresh.inertia > 0.0 || read.slope == fresh.slope) &&
         within(read.slope, -kSteepestFace, kSteepestFace) && all_finite({read.rate, read.last_rate});
}

bool line_holds(const DriveLine& read, const DriveLine& fresh, double length) {
  const double most = kFarthestPlaten * length;
  const bool same = read.stiffness == fresh.stiffness && read.seating == fresh.seating &&
                    read.half_load == fresh.half_load && read.mass == fresh.mass;
  return same && (read.tied == 0 || (read.tied == 1 && fresh.stiffness > 0.0)) &&
         all_finite({read.preload, read.drive_velocity}) && within(read.drive, -most, most) &&
         within(read.stretch, -most, most) && within(read.closed, 0.0, fresh.seating);
}

bool lines_hold(const System& read, const System& fresh, double length) {
  return read.lines[0].tied >= read.lines[1].tied && line_holds(read.lines[0], fresh.lines[0], length) &&
         line_holds(read.lines[1], fresh.lines[1], length);
}

bool platens_hold(const Platens& read, const Platens& fresh, double height) {
  const double most = kFarthestPlaten * height;
  return same_flag(read.present, fresh.present) && face_holds(read.upper, fresh.upper) &&
         read.friction == fresh.friction && read.jaw == fresh.jaw && within(read.y[0], -most, most) &&
         within(read.y[1], -most, most) &&
         all_finite({read.velocity[0], read.velocity[1], read.last_velocity[0], read.last_velocity[1]});
}

bool sums_hold(const NodeSums& s) {
  return all_finite({s.on_blocks[0].x, s.on_blocks[0].y, s.on_blocks[1].x, s.on_blocks[1].y, s.reaction[0],
                     s.reaction[1], s.turning, s.work_before, s.work_after, s.damping, s.platen_friction,
                     s.platen_energy, s.kinetic, s.fastest});
}

bool motion_holds(const System& read) {
  return read.step >= 0 && read.step <= kMostSteps && within(read.time, 0.0, std::numeric_limits<double>::max()) &&
         all_finite({read.initial_kinetic, read.external_work, read.damping_energy, read.platen_friction_energy}) &&
         sums_hold(read.sums) && all_within(read.particles.position, kFarthestPiece) &&
         all_within(read.particles.velocity, std::numeric_limits<double>::max());
}

bool block_holds(const RigidBlock& b) {
  return all_finite({b.load, b.velocity.x, b.velocity.y, b.last_velocity.x, b.last_velocity.y, b.reaction.x,
                     b.reaction.y, b.displacement.x, b.displacement.y, b.turn.angle, b.turn.rate, b.turn.last_rate});
}

bool flank_holds(const FlankPressure& read, const FlankPressure& fresh, std::size_t nodes) {
  const bool pressed = within(read.pressure, 0.0, std::numeric_limits<double>::max());
  return pressed && (read.edges.empty() || !fresh.outline.empty()) &&
         std::all_of(read.edges.begin(), read.edges.end(), [&](const LoadedEdge& e) {
           return is_index(e.nodes[0], nodes) && is_index(e.nodes[1], nodes) && within(e.share, 0.0, 1.0);
         });
}

bool broken_edge_holds(const BrokenEdge& edge, double now) {
  const bool modes_hold = edge.points[0] <= BreakMode::shear && edge.points[1] <= BreakMode::shear;
  const bool broken = edge.points[0] != BreakMode::none && edge.points[1] != BreakMode::none;
  const bool defect_holds = edge.defect == 0 || (edge.defect == 1 && broken && edge.break_time == 0.0);
  return modes_hold && defect_holds && (broken ? within(edge.break_time, 0.0, now) : edge.break_time == -1.0) &&
         within(edge.hand_over.weight, 0.0, 1.0);
}

bool modes_hold(const std::array<PointState, 2>& points) {
  return points[0].broken <= BreakMode::shear && points[1].broken <= BreakMode::shear;
}

/// A mesh's defects are those that its mechanisms give it.
bool same_defects(const BondedContacts& a, const BondedContacts& b) {
  for (std::size_t c = 0; c < a.size(); ++c) {
    if (a.is_defect(c) != b.is_defect(c)) return false;
  }
  return true;
}

/// Every broken edge belongs to one contact.
bool contacts_hold(const BondedContacts& contacts, double now) {
  std::vector<std::uint8_t> claimed(contacts.broken.size(), 0);
  for (const int index : contacts.broken_index) {
    if (index == -1) continue;
    if (!is_index(index, claimed.size()) || claimed[index]) return false;
    claimed[index] = 1;
  }
  const auto holds = [&](const BrokenEdge& edge) { return broken_edge_holds(edge, now); };
  return std::all_of(claimed.begin(), claimed.end(), [](std::uint8_t c) { return c == 1; }) &&
         std::all_of(contacts.broken.begin(), contacts.broken.end(), holds) &&
         std::all_of(contacts.memory.literal.begin(), contacts.memory.literal.end(), modes_hold);
}

/// Members are listed by ascending triangle; `edges` is three a member.
bool members_hold(const std::vector<ContactMember>& members, std::size_t triangles) {
  const std::size_t edges = 3 * members.size();
  int last = -1;
  for (const ContactMember& m : members) {
    if (!is_index(m.triangle, triangles) || m.triangle <= last) return false;
    last = m.triangle;
    for (int k = 0; k < 3; ++k) {
      if (!is_index_or_none(m.surface[k], kSurfaceKinds) || !is_index_or_none(m.next[k], edges) ||
          !is_index_or_none(m.previous[k], edges)) {
        return false;
      }
    }
  }
  return true;
}

bool pair_holds(const GeneralContacts& general, std::size_t p) {
  const MemberPair& pair = general.pairs[p];
  const std::int64_t chains = static_cast<std::int64_t>(general.chain_contacts.size());
  const bool chain_holds = pair.chain_begin >= 0 && pair.chain_size >= 0 &&
                           std::int64_t{pair.chain_begin} + std::int64_t{pair.chain_size} <= chains;
  return chain_holds && pair.seat >= 0.0 && pair.a < pair.b && is_index(pair.a, general.members.size()) &&
         is_index(pair.b, general.members.size()) && is_index_or_none(pair.touch, general.touches.size()) &&
         (pair.touch < 0 || general.touches[pair.touch].pair == static_cast<int>(p));
}

bool pairs_hold(const GeneralContacts& general) {
  for (std::size_t p = 0; p < general.pairs.size(); ++p) {
    if (!pair_holds(general, p)) return false;
  }
  for (std::size_t t = 0; t < general.touches.size(); ++t) {
    const int pair = general.touches[t].pair;
    if (!is_index(pair, general.pairs.size()) || general.pairs[pair].touch != static_cast<int>(t)) return false;
  }
  return true;
}

bool broken_contacts_hold(const std::vector<int>& listed, const BondedContacts& contacts) {
  return std::all_of(listed.begin(), listed.end(), [&](int c) {
    return is_index(c, contacts.size()) && contacts.is_broken(static_cast<std::size_t>(c));
  });
}

bool general_holds(const System& read) {
  const GeneralContacts& g = read.general;
  if (!g.law.enabled) return g.members.empty() && g.pairs.empty() && g.touches.empty() && g.handing_over.empty();
  return members_hold(g.members, read.particles.triangle_count()) && pairs_hold(g) &&
         broken_contacts_hold(g.chain_contacts, read.contacts) && broken_contacts_hold(g.handing_over, read.contacts) &&
         std::all_of(g.wear.begin(), g.wear.end(), is_length) &&
         within(g.travel, 0.0, std::numeric_limits<double>::max()) && g.searches >= 0 && g.searches <= read.step + 1 &&
         all_finite(
             {g.friction_energy, g.damping_energy, g.largest_depth, g.largest_depth_handing_over, g.largest_seat});
}

/// Not more than there were steps, nor than the counter can hold with room to go on.
bool is_count(std::int64_t count, std::int64_t steps) {
  return count >= 0 && count <= steps + 1 && count <= std::numeric_limits<int>::max() / 2;
}

bool rate_control_holds(const RateControlState& control, double now) {
  return within(control.rate, 0.0, std::numeric_limits<double>::max()) && all_finite({control.growth, control.ratio}) &&
         control.separated >= 0 && within(control.crack_time, -1.0, now);
}

bool unloading_holds(const UnloadingState& state, const RunConfig& config) {
  const auto most = static_cast<int>(config.experiment.loading.unloading.size());
  return state.begun >= 0 && state.begun <= most && (state.back == 0 || (state.back == 1 && state.begun > 0)) &&
         within(state.direction, -1.0, 1.0) && all_finite({state.load, state.trend, state.turn_load, state.turn_mm});
}

bool elastic_start_holds(const ElasticStart& start) {
  return start.increments >= 0 && start.iterations >= 0 && start.factorisations >= 0 &&
         within(start.separation, 0.0, std::numeric_limits<double>::max());
}

bool program_holds(const LoadingState& loading, const Model& fresh, double now) {
  const double most = kFarthestPlaten * specimen_length(fresh.config);
  const bool phase_holds =
      loading.phase >= LoadingPhase::confining && loading.phase <= LoadingPhase::elastic_start &&
      (loading.phase != LoadingPhase::confining || !fresh.system.flank.outline.empty() ||
       !fresh.system.blocks.empty()) &&
      (loading.phase != LoadingPhase::elastic_start || fresh.config.experiment.loading.elastic_start_fraction > 0.0);
  return phase_holds && all_finite({loading.phase_start_s, loading.zero_gauges.axial, loading.zero_gauges.lateral}) &&
         within(loading.phase_start_closure_mm, -most, most) && within(loading.zero_distance_mm, 0.0, most) &&
         within(loading.elastic_start_closure_mm, -most, most) && rate_control_holds(loading.rate_control, now) &&
         unloading_holds(loading.unloading, fresh.config) && elastic_start_holds(loading.elastic_start);
}

/// Rows and frames come with steps, or with the increments of an elastic start.
bool progress_holds(const RunState& state, std::int64_t steps) {
  const bool stop_holds =
      state.stop == StopReason::running || (state.stop > StopReason::running && state.stop < StopReason::interrupted);
  const std::int64_t moments = steps + state.loading.elastic_start.increments;
  return stop_holds && (state.stop == StopReason::running || !state.samples.empty()) &&
         is_count(state.loading.stages, steps) && is_count(state.stages_sampled, state.loading.stages) &&
         is_count(state.frames, moments) && is_count(state.samples_below, moments) && state.steps_in_sample >= 0 &&
         state.steps_in_sample <= steps + 1 && static_cast<std::int64_t>(state.samples.size()) <= moments + 1 &&
         within(state.next_frame_strain, 0.0, kFarthestPlaten) && sums_hold(state.reaction_sum);
}

}  // namespace

std::string contradiction(const Model& fresh, const System& read, const RunState& state) {
  if (!same_sizes(read, fresh.system)) return "belongs to another mesh";
  if (!platens_hold(read.platens, fresh.system.platens, specimen_length(fresh.config)))
    return "holds no state of the platens";
  if (!lines_hold(read, fresh.system, specimen_length(fresh.config))) return "holds no state of the drive";
  if (!motion_holds(read)) return "holds no state of motion";
  if (!std::all_of(read.blocks.begin(), read.blocks.end(), block_holds)) return "holds no state of the rigid blocks";
  if (!flank_holds(read.flank, fresh.system.flank, read.particles.node_count()))
    return "holds no state of the confining pressure";
  if (!contacts_hold(read.contacts, read.time) || !same_defects(read.contacts, fresh.system.contacts))
    return "holds no state of the bonded contacts";
  if (!general_holds(read)) return "holds no state of the general contacts";
  if (!program_holds(state.loading, fresh, read.time)) return "holds no state of the loading";
  if (!progress_holds(state, read.step)) return "holds no progress of a run";
  return "";
}

}  // namespace asperity
