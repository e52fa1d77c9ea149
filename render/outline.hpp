#pragma once
#include <array>
#include <vector>

#include "core/measurement/frame.hpp"

namespace asperity::render {

/// The node pairs of the specimen's outline: triangle edges that no other triangle shared before loading.
std::vector<std::array<int, 2>> outline_edges(const Frame& frame);

/// The pairs of triangles that shared an edge before loading.
std::vector<std::array<int, 2>> adjacent_triangles(const Frame& frame);

}  // namespace asperity::render
