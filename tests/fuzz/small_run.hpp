#pragma once
#include <string>

#include "core/experiment/run.hpp"

namespace asperity::fuzz {

/// A test of some twenty particles that has been crushed: touches, hand-overs and loaded faces of broken contacts.
struct SmallRun {
  Model fresh;  ///< As built.
  Model model;  ///< After the crushing.
  RunState state;
};

/// The run, made on the first call.
const SmallRun& small_run();

/// The configuration's hash in its checkpoints.
std::string small_hash();

/// The bytes with the checksum of what stands behind it.
std::string sealed(std::string bytes);

/// Goes on for so many steps; what the guards throw ends it.
void go_on(Model& model, RunState& state, int steps);

}  // namespace asperity::fuzz
