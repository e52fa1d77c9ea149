#include <catch2/catch.hpp>

#include "core/config/read_config.hpp"
#include "core/experiment/summarise.hpp"

using namespace asperity;

/// The shipped tests taken far beyond the peak: energy, overlap, and that pieces really come off.
namespace {

struct Beyond {
  Model model;
  RunState state;
};

Beyond run_to(const std::string& config, const std::vector<std::string>& overrides) {
  const RunConfig run = read_run_config(ASPERITY_SOURCE_DIR "/configs/" + config, overrides);
  Beyond result{build_model(run, ParallelLoops()), {}};
  result.state = start_run(result.model);
  run_experiment(result.model, result.state, ParallelLoops(), {});
  return result;
}

void check(const Beyond& run) {
  const double error = relative_closure_error(run.state.samples.back().energy);
  const double overlap = run.model.system.general.largest_depth / run.model.config.particles.edge_mm;
  WARN(run.model.config.name << ": energy error " << error << ", largest overlap over edge " << overlap << ", "
                             << run.model.system.general.touches.size() << " general contacts at the end");
  CHECK(run.state.stop == StopReason::strain);
  CHECK(error < 1e-3);
  CHECK_NOFAIL(overlap <
               0.05);  // of the one deepest contact in a whole run: 4 to 6 % as the order of breakage falls out
  CHECK(overlap < 0.10);
  CHECK(run.model.system.general.touches.size() > 20);
}

}  // namespace

TEST_CASE("uniaxial compression to 5 % strain closes its energy to 0.1 % and overlaps little") {
  check(
      run_to("paper/uniaxial.json", {"/experiment/stop/axial_strain=0.05", "/experiment/stop/fraction_of_peak=0.01"}));
}

TEST_CASE("triaxial compression at 1 MPa to 6 % strain does too") {
  check(run_to("paper/triaxial_1.0.json",
               {"/experiment/stop/axial_strain=0.06", "/experiment/stop/fraction_of_peak=0.01"}));
}

TEST_CASE("a disc pressed together by 8 % of its diameter does too") {
  check(run_to("quickstart.json", {"/experiment/stop/axial_strain=0.08", "/experiment/stop/fraction_of_peak=0.01"}));
}
