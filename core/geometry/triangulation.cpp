#include "core/geometry/triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>

#include "core/base/error.hpp"

namespace asperity {
namespace {

constexpr int kUnvisited = -2;
constexpr int kOutside = -1;

struct FaceMark {
  int region = kUnvisited;
  int index = -1;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using MarkedFace = CGAL::Triangulation_face_base_with_info_2<FaceMark, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, MarkedFace>;
using Storage = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Storage,
                                                       CGAL::No_constraint_intersection_requiring_constructions_tag>;

void insert_points(Cdt& cdt, const std::vector<Vec2>& points) {
  std::vector<std::pair<Kernel::Point_2, int>> numbered;
  numbered.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    numbered.emplace_back(Kernel::Point_2(points[i].x, points[i].y), static_cast<int>(i));
  cdt.insert(numbered.begin(), numbered.end());
  if (cdt.number_of_vertices() != points.size()) throw Error(ErrorKind::numerical, "two mesh points coincide");
}

void insert_segments(Cdt& cdt, std::size_t points, const std::vector<std::array<int, 2>>& segments) {
  std::vector<Cdt::Vertex_handle> handle(points);
  for (auto v = cdt.finite_vertices_begin(); v != cdt.finite_vertices_end(); ++v) handle[v->info()] = v;
  try {
    for (const auto& [a, b] : segments) cdt.insert_constraint(handle[a], handle[b]);
  } catch (const Cdt::Intersection_of_constraints_exception&) {
    throw Error(ErrorKind::numerical, "two grain boundaries cross");
  }
}

void flood(Cdt::Face_handle first, int region) {
  std::vector<Cdt::Face_handle> stack{first};
  first->info().region = region;
  while (!stack.empty()) {
    const Cdt::Face_handle face = stack.back();
    stack.pop_back();
    for (int k = 0; k < 3; ++k) {
      const Cdt::Face_handle next = face->neighbor(k);
      if (face->is_constrained(k) || next->info().region != kUnvisited) continue;
      next->info().region = region;
      stack.push_back(next);
    }
  }
}

void mark_regions(Cdt& cdt) {
  flood(cdt.infinite_face(), kOutside);
  int regions = 0;
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face)
    if (face->info().region == kUnvisited) flood(face, regions++);
}

Triangulation extract(Cdt& cdt) {
  Triangulation mesh;
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) {
    if (face->info().region == kOutside) continue;
    face->info().index = static_cast<int>(mesh.triangles.size());
    mesh.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    mesh.region.push_back(face->info().region);
  }
  mesh.neighbours.reserve(mesh.triangles.size());
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face)
    if (face->info().region != kOutside)
      mesh.neighbours.push_back(
          {face->neighbor(0)->info().index, face->neighbor(1)->info().index, face->neighbor(2)->info().index});
  return mesh;
}

}  // namespace

Triangulation triangulate(const std::vector<Vec2>& points, const std::vector<std::array<int, 2>>& segments) {
  Cdt cdt;
  insert_points(cdt, points);
  insert_segments(cdt, points.size(), segments);
  mark_regions(cdt);
  return extract(cdt);
}

Triangulation delaunay(const std::vector<Vec2>& points) {
  Cdt cdt;
  insert_points(cdt, points);
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) face->info().region = 0;
  return extract(cdt);
}

}  // namespace asperity
