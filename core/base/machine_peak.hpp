#pragma once
#include <string>

#include "core/base/parallel.hpp"

namespace asperity {

/// What the machine can do at most, measured with the same instruction set and threads as a kernel, for an estimate of
/// that kernel's bound.
struct MachinePeak {
  double flops = 0;      ///< Additions and products of doubles a second, unfused, in independent chains.
  double bandwidth = 0;  ///< Bytes a second read and written, updating 256 MB a thread in place.
};

/// Takes some 0.3 s.
MachinePeak measure_machine_peak(const ParallelLoops& loops);

/// Name of the instruction set that the vector kernels use here: "AVX3_DL", "AVX2", "SSE4", "SCALAR", ...
std::string instruction_set();

}  // namespace asperity
