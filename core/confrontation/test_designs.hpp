#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/config/run_config.hpp"
#include "core/confrontation/preparation.hpp"

namespace asperity {

/// A feature that only the further test gives, and one of the made test that is read in the same way.
struct AddedFeature {
  std::string name, like;
};

/// A further test that a laboratory could make, as a change of one it has made.
struct TestDesign {
  std::string id, description;
  /// The changed run, or nothing where the change has no meaning for it or was made already.
  std::function<std::optional<RunConfig>(const RunConfig& made, const std::vector<RunConfig>& all)> change;
  std::string concerns;          ///< A mechanism without which among the causes the test tells nothing; empty: none.
  std::string switches_off;      ///< A mechanism that the test rules out; empty: none.
  Preparation preparation = {};  ///< Of its specimens, beyond that of the test it changes.
  std::vector<AddedFeature> records = {};  ///< Features that the test gives beyond those of the test it changes.
};

/// Those the method declares: lubricated platens, H/D 1 and 3, unload-reload, another rate, twice the confining
/// pressure, a rotated core, a joint under constant normal stiffness, a joint with gauges of its dilation at both ends,
/// half the size. A second pass over a joint is none: a run shears one way.
const std::vector<TestDesign>& test_designs();

}  // namespace asperity
