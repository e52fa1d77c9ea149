#include <catch2/catch.hpp>
#include <cmath>

#include "core/experiment/summarise.hpp"
#include "tests/unit/experiment/small_models.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

/// Vertical length of all loaded edges that face one side, weighted by what is seen of them, mm.
double loaded_height(const System& system, double side) {
  double height = 0.0;
  for (const LoadedEdge& e : system.flank.edges) {
    const auto& x = system.particles.position;
    const double rise = x[e.nodes[1]].y - x[e.nodes[0]].y;  // > 0 on the right, the specimen lies to the left
    if (rise * side > 0.0) height += e.share * std::abs(rise);
  }
  return height;
}

bool has_edge(const FlankPressure& flank, const LoadedEdge& edge) {
  for (const LoadedEdge& e : flank.edges) {
    if (e.nodes == edge.nodes) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("the confining pressure of a crushed specimen acts on its present outer surface, in full on both sides") {
  Model model = small_model(crushed_triaxial());
  const FlankPressure at_rest = model.system.flank;
  RunState state = start_run(model);
  run_experiment(model, state, ParallelLoops(), {});
  const System& system = model.system;
  int fresh = 0, partial = 0;
  for (const LoadedEdge& e : system.flank.edges) {
    fresh += !has_edge(at_rest, e);
    partial += e.share < 1.0;
  }
  CHECK(fresh > 0);
  CHECK(partial > 0);
  const double between = system.platens.y[1] - system.platens.y[0];
  CAPTURE(between, fresh, partial, system.flank.edges.size());
  CHECK(loaded_height(system, 1.0) == Approx(between).epsilon(0.06));  // pieces at the ends may hide under a platen
  CHECK(loaded_height(system, -1.0) == Approx(between).epsilon(0.06));
  const EnergyBalance& energy = state.samples.back().energy;
  CHECK(relative_closure_error(energy) < 1e-3);
  CHECK(system.general.friction_energy > 0.0);
}
