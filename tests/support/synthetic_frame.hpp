#pragma once
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "core/measurement/frame.hpp"

/// Frames that no simulation made, for tests of files and pictures alone: regular triangles of 2 mm in a disc or a
/// rectangle, with smooth fields, a split specimen and cracks of every mode.
namespace asperity::test {

inline constexpr double kEdgeMm = 2.0;
inline const double kRowMm = kEdgeMm * std::numbers::sqrt3 / 2;

struct SyntheticSize {
  double width_mm, height_mm;
};

/// Triangles of a regular lattice whose centre is inside; each has nodes of its own. Positions before loading.
inline void add_lattice(Frame& frame, SyntheticSize size, const std::function<bool(Vec2)>& inside) {
  const int columns = static_cast<int>(size.width_mm / kEdgeMm) + 2,
            rows = static_cast<int>(size.height_mm / kRowMm) + 2;
  const auto corner = [&](int column, int row) {
    return Vec2{(column - 0.5 * columns + 0.5 * (row & 1)) * kEdgeMm, (row - 0.5 * rows) * kRowMm};
  };
  const auto add = [&](Vec2 a, Vec2 b, Vec2 c) {
    if (!inside((1.0 / 3) * (a + b + c))) return;
    const int first = static_cast<int>(frame.position.size());
    for (const Vec2 p : {a, b, c}) frame.position.push_back(p);
    frame.triangles.push_back({first, first + 1, first + 2});
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Vec2 a = corner(column, row), b = corner(column + 1, row);
      const Vec2 c = corner(column + (row & 1), row + 1), below = corner(column + (row & 1), row - 1);
      add(a, b, c);
      add(b, a, below);
    }
}

/// Inner edges as (end, end), each once.
inline std::vector<std::pair<Vec2, Vec2>> inner_edges(const Frame& frame) {
  std::map<std::pair<long, long>, int> seen;
  std::vector<std::pair<Vec2, Vec2>> edges;
  for (const auto& triangle : frame.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec2 a = frame.position[static_cast<std::size_t>(triangle[c])];
      const Vec2 b = frame.position[static_cast<std::size_t>(triangle[(c + 1) % 3])];
      if (++seen[{std::lround(1e3 * (a.x + b.x)), std::lround(1e3 * (a.y + b.y))}] == 2) edges.push_back({a, b});
    }
  return edges;
}

/// Where the specimen parts: the distance (mm) of a point from the made-up main crack.
using CrackLine = std::function<double(Vec2)>;

inline void add_cracks(Frame& frame, const CrackLine& line, double height_mm) {
  for (const auto& [a, b] : inner_edges(frame)) {
    const Vec2 middle = 0.5 * (a + b);
    const double distance = std::abs(line(middle));
    if (distance > 4.5) continue;
    CrackSegment crack{a, b, CrackMode::softening, 0.6 - 0.1 * distance, 0.002, 0.001, -1, 0.02};
    if (distance < 0.8) {
      const bool near_platen = std::abs(middle.y) > 0.33 * height_mm;
      crack.mode = near_platen ? CrackMode::shear : CrackMode::tension;
      crack.damage = 1;
      crack.opening_mm = 0.05;
      crack.break_time_s = 1e-4 + 1e-6 * std::abs(middle.y);
      crack.energy_n_mm = 0.1;
    }
    frame.cracks.push_back(crack);
  }
}

inline Vec2 centre_of(const Frame& frame, std::size_t triangle) {
  Vec2 sum;
  for (const int node : frame.triangles[triangle]) sum += frame.position[static_cast<std::size_t>(node)];
  return (1.0 / 3) * sum;
}

inline void add_fields(Frame& frame, const CrackLine& line, SyntheticSize size) {
  for (std::size_t i = 0; i < frame.triangles.size(); ++i) {
    const Vec2 c = centre_of(frame, i);
    const double side = line(c), u = 2 * c.x / size.width_mm, v = 2 * c.y / size.height_mm;
    frame.stress.push_back({3 * (1 - u * u) * std::cos(4 * v) + 0.2 * std::sin(9 * c.x),
                            -9 * std::exp(-3 * u * u) - v * v, 0.2, 2 * u * v});
    frame.damage.push_back(std::exp(-0.3 * std::abs(side)));
    frame.grain.push_back(static_cast<int>(i / 6));
    const bool wedge = std::abs(v) > 0.86 && std::abs(u) < 0.3;
    frame.fragment.push_back(wedge ? (v > 0 ? 2 : 3) : side > 0 ? 1 : 0);
  }
}

/// Pairs of triangles with a common edge.
inline std::vector<std::array<std::size_t, 2>> touching_pairs(const Frame& frame) {
  std::map<std::pair<long, long>, std::size_t> first;
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < frame.triangles.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec2 twice = frame.position[static_cast<std::size_t>(frame.triangles[i][c])] +
                         frame.position[static_cast<std::size_t>(frame.triangles[i][(c + 1) % 3])];
      const auto [entry, is_new] = first.try_emplace({std::lround(1e3 * twice.x), std::lround(1e3 * twice.y)}, i);
      if (!is_new) pairs.push_back({entry->second, i});
    }
  return pairs;
}

/// Compression along y and tension across it, as large as the made-up stress is where the two touch; those over the
/// main crack are broken, or new where x > 0.
inline void add_contacts(Frame& frame, const std::vector<std::array<std::size_t, 2>>& pairs) {
  for (const auto& [i, j] : pairs) {
    ContactForce contact;
    contact.a = centre_of(frame, i);
    contact.b = centre_of(frame, j);
    contact.point = 0.5 * (contact.a + contact.b);
    const Vec2 along = (1 / norm(contact.b - contact.a)) * (contact.b - contact.a);
    contact.normal_n = -2 * (along.x * along.x * frame.stress[i][0] + along.y * along.y * frame.stress[i][1]);
    contact.shear_n = 0.3 * std::abs(contact.normal_n);
    if (frame.fragment[i] != frame.fragment[j]) {
      contact.normal_n = std::abs(contact.normal_n);
      contact.kind = contact.point.x > 0 ? ContactKind::general : ContactKind::broken;
    }
    frame.contacts.push_back(contact);
  }
}

/// The halves move 0.4 mm apart, and the ends 0.3 mm towards one another.
inline void move_apart(Frame& frame, double height_mm) {
  for (std::size_t i = 0; i < frame.triangles.size(); ++i)
    for (const int node : frame.triangles[i]) {
      Vec2& p = frame.position[static_cast<std::size_t>(node)];
      const Vec2 u{frame.fragment[i] == 1 ? 0.4 : frame.fragment[i] == 0 ? -0.1 : 0.0, -0.6 * p.y / height_mm};
      frame.displacement.push_back(u);
      frame.velocity.push_back(10.0 * u);
      p += u;
    }
}

inline void add_curve(Frame& frame, double peak_mpa) {
  for (int i = 0; i <= 200; ++i) {
    const double strain = 2e-5 * i, t = strain / 3.4e-3;
    frame.curve.axial_strain.push_back(strain);
    frame.curve.lateral_strain.push_back(-0.2 * strain * (1 + t));
    frame.curve.stress_mpa.push_back(peak_mpa * (t < 1 ? t * (1.9 - 0.9 * t * t) : 2.0 / (1 + std::exp(60 * (t - 1)))));
  }
  frame.axial_strain = frame.curve.axial_strain.back();
  frame.stress_mpa = frame.curve.stress_mpa.back();
}

inline Frame finish(Frame frame, SyntheticSize size, const CrackLine& line, double peak_mpa) {
  add_fields(frame, line, size);
  add_cracks(frame, line, size.height_mm);
  const auto pairs = touching_pairs(frame);
  move_apart(frame, size.height_mm);
  add_contacts(frame, pairs);
  add_curve(frame, peak_mpa);
  frame.platen_y = {-0.5 * size.height_mm + 0.3, 0.5 * size.height_mm - 0.3};
  frame.time_s = 1.2345e-3;
  return frame;
}

/// A disc of 54 mm, split along its loaded diameter.
inline Frame synthetic_disc() {
  Frame frame;
  frame.experiment = "brazilian";
  frame.name = "synthetic disc";
  add_lattice(frame, {54, 54}, [](Vec2 p) { return norm(p) < 26.6; });
  return finish(
      std::move(frame), {54, 54}, [](Vec2 p) { return p.x - 1.5 * std::sin(0.2 * p.y); }, 2.3);
}

/// A rectangle of 54 x 130 mm under confinement, cut by an inclined crack.
inline Frame synthetic_rectangle() {
  Frame frame;
  frame.experiment = "triaxial";
  frame.name = "synthetic rectangle";
  frame.confining_pressure_mpa = 0.5;
  add_lattice(frame, {54, 130}, [](Vec2 p) { return std::abs(p.x) < 26.5 && std::abs(p.y) < 64.6; });
  return finish(
      std::move(frame), {54, 130}, [](Vec2 p) { return 0.88 * p.x - 0.47 * p.y; }, 9.4);
}

}  // namespace asperity::test
