#include "core/integrator/static_stiffness.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>

#include "core/base/error.hpp"
#include "core/integrator/platen_contact.hpp"

namespace asperity {
namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

/// Share of each diagonal entry's mean that is added to hold rigid motion along the platens; far below the stiffness of
/// the specimen as a whole, so that it does not slow the solution down.
constexpr double kRigidHold = 1e-7;

template <std::size_t N, class Apply>
void add_element(Entries& entries, const std::array<int, N>& nodes, const Apply& apply) {
  const auto columns = element_columns<N>(apply);
  for (std::size_t j = 0; j < 2 * N; ++j) {
    const int column = 2 * nodes[j / 2] + static_cast<int>(j % 2);
    for (std::size_t i = 0; i < N; ++i) {
      if (2 * nodes[i] >= column) entries.emplace_back(2 * nodes[i], column, columns[j][i].x);
      if (2 * nodes[i] + 1 >= column) entries.emplace_back(2 * nodes[i] + 1, column, columns[j][i].y);
    }
  }
}

/// The spring of a node that a platen presses, about its present place: along the normal, and across it by the turning
/// of the normal force; Eq. (I18).
void add_platen_spring(Entries& entries, std::size_t node, const PlatenContact& contact) {
  const Vec2 n = contact.touch.normal, along = along_face(contact.touch, contact.side);
  const double across = contact.overlap * contact.touch.bend;
  const int row = 2 * static_cast<int>(node);
  const auto entry = [&](double first, double second) { return contact.spring.stiffness * (first + across * second); };
  entries.emplace_back(row + 1, row + 1, entry(n.y * n.y, along.y * along.y));
  if (n.x == 0.0) return;
  entries.emplace_back(row, row, entry(n.x * n.x, along.x * along.x));
  entries.emplace_back(row + 1, row, entry(n.x * n.y, along.x * along.y));
}

/// Lower triangle of the stiffness, without the hold of rigid motion.
Entries stiffness_entries(const System& system, const std::vector<EdgeStiffness>& contacts,
                          const std::vector<std::uint8_t>& on_platens) {
  const Particles& p = system.particles;
  Entries entries;
  entries.reserve(21 * p.triangle_count() + 36 * system.contacts.size() + 2 * p.node_count());
  for (std::size_t t = 0; t < p.triangle_count(); ++t) {
    add_element<3>(entries, p.triangles[t], [&](const auto& u) { return linear_triangle(p.shape(t), u, p.elastic_of(t)); });
  }
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const ContactEdge& e = system.contacts.edges[c];
    const ContactFrame frame = contact_frame(e, p.position);
    add_element<4>(entries, {e.left1, e.left2, e.right1, e.right2},
                   [&](const auto& u) { return linear_contact(e, frame, u, contacts[c]); });
  }
  for (std::size_t i = 0; i < on_platens.size(); ++i) {
    if (on_platens[i]) add_platen_spring(entries, i, platen_contact(system, i));
  }
  return entries;
}

double mean_diagonal(const Entries& entries, Eigen::Index size) {
  double sum = 0.0;
  for (const auto& entry : entries) {
    if (entry.row() == entry.col()) sum += entry.value();
  }
  return sum / static_cast<double>(size);
}

/// Force of frictionless platens on a node, N per mm of thickness.
Vec2 platen_push(const PlatenContact& contact) {
  return contact.spring.stiffness * std::max(0.0, contact.overlap) * contact.touch.normal;
}

}  // namespace

struct StaticStiffness::Factor {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> ldlt;
};

std::vector<std::uint8_t> nodes_on_platens(const System& system) {
  std::vector<std::uint8_t> flags(system.particles.node_count(), 0);
  for (std::size_t i = 0; i < flags.size(); ++i) {
    flags[i] = platen_contact(system, i).overlap > 0.0;
  }
  return flags;
}

std::vector<Vec2> out_of_balance(const System& system) {
  std::vector<Vec2> force(system.particles.node_count());
  for (std::size_t i = 0; i < force.size(); ++i) {
    force[i] = internal_force(system, i) + system.loads.at(i) + platen_push(platen_contact(system, i));
  }
  return force;
}

PlatenLoad platen_load(const System& system) {
  PlatenLoad load;
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    const PlatenContact contact = platen_contact(system, i);
    const Vec2 push = platen_push(contact);
    load.reaction[contact.side] += facing(contact.side) * push.y;
    load.energy += 0.5 * dot(push, contact.touch.normal) * std::max(0.0, contact.overlap);
  }
  return load;
}

StaticStiffness::StaticStiffness(const System& system, const std::vector<EdgeStiffness>& contacts)
    : on_platens_(nodes_on_platens(system)), factor_(std::make_unique<Factor>()) {
  const Eigen::Index size = 2 * static_cast<Eigen::Index>(system.particles.node_count());
  Entries entries = stiffness_entries(system, contacts, on_platens_);
  const double hold = kRigidHold * mean_diagonal(entries, size);
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i, hold);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_->ldlt.compute(matrix);
  if (factor_->ldlt.info() != Eigen::Success) {
    throw Error(ErrorKind::numerical, "the stiffness of the elastic start cannot be factorised");
  }
}

StaticStiffness::~StaticStiffness() = default;

std::vector<Vec2> StaticStiffness::solve(const std::vector<Vec2>& force) const {
  Eigen::VectorXd rhs(2 * static_cast<Eigen::Index>(force.size()));
  for (std::size_t i = 0; i < force.size(); ++i) {
    rhs[2 * static_cast<Eigen::Index>(i)] = force[i].x;
    rhs[2 * static_cast<Eigen::Index>(i) + 1] = force[i].y;
  }
  const Eigen::VectorXd solution = factor_->ldlt.solve(rhs);
  std::vector<Vec2> u(force.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    u[i] = {solution[2 * static_cast<Eigen::Index>(i)], solution[2 * static_cast<Eigen::Index>(i) + 1]};
  }
  return u;
}

}  // namespace asperity
