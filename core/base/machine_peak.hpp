#pragma once
#include <string>

#include "core/base/parallel.hpp"

namespace asperity {

/// What the machine can do at most, measured with the same instruction set and threads as a kernel, for an estimate of
/// that kernel's bound.
struct MachinePeak {
  double flops = 0;      ///< Additions and products of doubles a second, unfused, in independent chains.
  double bandwidth = 0;  ///< Bytes a second read and written, updating an array in place.
};

/// The array for the bandwidth has so many bytes, shared by the threads: as many as the kernel's data, so that it lies
/// in the same cache. Takes some 0.2 s.
MachinePeak measure_machine_peak(const ParallelLoops& loops, std::size_t bytes);

/// Name of the instruction set that the vector kernels use here: "AVX3_DL", "AVX2", "SSE4", "SCALAR", ...
std::string instruction_set();

}  // namespace asperity
