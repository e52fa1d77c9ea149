#pragma once
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <cstddef>
#include <memory>
#include <vector>
#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace asperity {

/// Tells the thread sanitizer the order that TBB keeps, which it cannot see because Debian's TBB is not built for it:
/// all that was done before `give` on a token comes before what is done after `take` on it. Nothing in other builds.
/// The tokens are global because a thread must not read its loop's variables before it has taken.
namespace order {
inline char begun = 0, done = 0;
#ifdef __SANITIZE_THREAD__
inline void give(char& token) { __tsan_release(&token); }
inline void take(char& token) { __tsan_acquire(&token); }
#else
inline void give(char&) {}
inline void take(char&) {}
#endif
}  // namespace order

/// Loops over [0, n) in blocks of a fixed size. The blocks do not depend on the number of threads, and sums are added
/// block by block in order, so results are bitwise the same for any number of threads.
class ParallelLoops {
 public:
  static constexpr std::size_t kBlock = 1024;

  explicit ParallelLoops(int threads = 1) : threads_(threads) {
    if (threads < 2) return;
    // Without it TBB grants no more threads than there are cores.
    allowance_ =
        std::make_unique<oneapi::tbb::global_control>(oneapi::tbb::global_control::max_allowed_parallelism, threads);
    arena_ = std::make_unique<oneapi::tbb::task_arena>(threads);
  }

  int threads() const { return threads_; }

  /// body(begin, end) for every block.
  template <class Body>
  void for_blocks(std::size_t n, const Body& body) const {
    const std::size_t blocks = (n + kBlock - 1) / kBlock;
    const auto run = [&](std::size_t b) { body(b * kBlock, n < (b + 1) * kBlock ? n : (b + 1) * kBlock); };
    if (!arena_ || blocks < 2) {
      for (std::size_t b = 0; b < blocks; ++b) run(b);
      return;
    }
    const auto run_in_order = [&](std::size_t b) {
      order::take(order::begun);
      run(b);
      order::give(order::done);
    };
    order::give(order::begun);
    arena_->execute([&] { oneapi::tbb::parallel_for(std::size_t{0}, blocks, run_in_order); });
    order::take(order::done);
  }

  /// Sum of body(begin, end) over all blocks; Sum needs a default value of zero and operator+=.
  template <class Sum, class Body>
  Sum sum_blocks(std::size_t n, const Body& body) const {
    std::vector<Sum> parts((n + kBlock - 1) / kBlock);
    for_blocks(n, [&](std::size_t begin, std::size_t end) { parts[begin / kBlock] = body(begin, end); });
    Sum total{};
    for (const Sum& part : parts) total += part;
    return total;
  }

 private:
  int threads_;
  std::unique_ptr<oneapi::tbb::global_control> allowance_;
  std::unique_ptr<oneapi::tbb::task_arena> arena_;
};

}  // namespace asperity
