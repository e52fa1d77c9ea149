#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/base/machine_peak.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h:
#include <hwy/highway.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "core/base/machine_peak.hpp"
#include "core/base/simd_points.inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace asperity::HWY_NAMESPACE {

/// Sixteen chains hide the latency of an addition and a product; returns the operations done.
double run_chains(double* sink, std::size_t rounds) {
  constexpr std::size_t kChains = 16;
  const Doubles d;
  const Real factor = hn::Set(d, 0.999), shift = hn::Set(d, *sink);
  const auto start = [&](int chain) { return hn::Iota(d, static_cast<double>(chain)); };
  Real x0 = start(0), x1 = start(1), x2 = start(2), x3 = start(3), x4 = start(4), x5 = start(5), x6 = start(6);
  Real x7 = start(7), y0 = start(8), y1 = start(9), y2 = start(10), y3 = start(11), y4 = start(12), y5 = start(13);
  Real y6 = start(14), y7 = start(15);
  const auto next = [&](Real& x) { x = hn::Add(hn::Mul(x, factor), shift); };
  for (std::size_t i = 0; i < rounds; ++i) {
    next(x0), next(x1), next(x2), next(x3), next(x4), next(x5), next(x6), next(x7);
    next(y0), next(y1), next(y2), next(y3), next(y4), next(y5), next(y6), next(y7);
  }
  Real sum = hn::Zero(d);
  for (const Real& x : {x0, x1, x2, x3, x4, x5, x6, x7, y0, y1, y2, y3, y4, y5, y6, y7}) sum = hn::Add(sum, x);
  *sink = hn::GetLane(sum);
  return 2.0 * static_cast<double>(kChains * kLanes * rounds);
}

/// In-place update; returns the bytes moved.
double run_update(double* data, std::size_t n) {
  const Doubles d;
  const Real factor = hn::Set(d, 0.999999);
  for (std::size_t i = 0; i + kLanes <= n; i += kLanes) {
    hn::StoreU(hn::Mul(hn::LoadU(d, data + i), factor), d, data + i);
  }
  return 2.0 * sizeof(double) * static_cast<double>(n);
}

const char* target_name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace asperity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asperity {
namespace {

HWY_EXPORT(run_chains);
HWY_EXPORT(run_update);
HWY_EXPORT(target_name);

constexpr std::size_t kRounds = 1'000'000;
constexpr double kMoved = 1e9;  // bytes in one try

/// Best of a few tries of work(i), i = 0 ... threads - 1, each returning how much it did, together a second.
template <class Work>
double best_rate(const ParallelLoops& loops, const Work& work) {
  double best = 0.0;
  for (int repeat = 0; repeat < 3; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = static_cast<std::size_t>(loops.threads()) * ParallelLoops::kBlock;
    const double done = loops.sum_blocks<double>(
        n, [&](std::size_t begin, std::size_t) { return work(begin / ParallelLoops::kBlock); });
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    best = std::max(best, done / seconds);
  }
  return best;
}

}  // namespace

MachinePeak measure_machine_peak(const ParallelLoops& loops, std::size_t bytes) {
  const auto threads = static_cast<std::size_t>(loops.threads());
  const std::size_t share = std::max<std::size_t>(1024, bytes / sizeof(double) / threads);
  const auto repeats = static_cast<int>(std::max(1.0, kMoved / static_cast<double>(2 * sizeof(double) * share * threads)));
  std::vector<double> sinks(8 * threads, 0.5), data(threads * share, 1.0);
  MachinePeak peak;
  peak.flops =
      best_rate(loops, [&](std::size_t i) { return HWY_DYNAMIC_DISPATCH(run_chains)(&sinks[8 * i], kRounds); });
  peak.bandwidth = best_rate(loops, [&](std::size_t i) {
    double moved = 0.0;
    for (int r = 0; r < repeats; ++r) moved += HWY_DYNAMIC_DISPATCH(run_update)(&data[i * share], share);
    return moved;
  });
  return peak;
}

std::string instruction_set() { return HWY_DYNAMIC_DISPATCH(target_name)(); }

}  // namespace asperity
#endif
