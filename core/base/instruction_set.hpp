#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace asperity {

/// An instruction set that this machine has and the vector kernels were compiled for.
struct InstructionSet {
  std::int64_t target;
  std::string name;  ///< "AVX3", "AVX2", "SSE4", ...
};

/// All of them, the best first.
std::vector<InstructionSet> instruction_sets();

/// Makes the vector kernels take one instruction set as long as the object lives, then the best again. Not while
/// kernels run.
class ForcedInstructionSet {
 public:
  explicit ForcedInstructionSet(const InstructionSet& set);
  ~ForcedInstructionSet();
  ForcedInstructionSet(const ForcedInstructionSet&) = delete;
  ForcedInstructionSet& operator=(const ForcedInstructionSet&) = delete;
};

}  // namespace asperity
