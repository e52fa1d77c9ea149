#include "core/base/parallel.hpp"

/// A loop whose blocks race on purpose. It is a test that must fail under the thread sanitizer, so that a suppression
/// which hides our own races is noticed.
int main() {
  const asperity::ParallelLoops loops(4);
  long visits = 0;
  for (int round = 0; round < 100; ++round) {
    loops.for_blocks(50 * asperity::ParallelLoops::kBlock, [&](std::size_t, std::size_t) { ++visits; });
  }
  return visits == 0 ? 1 : 0;
}
