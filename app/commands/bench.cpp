#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/commands/commands.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/build_info.hpp"
#include "core/base/instruction_set.hpp"
#include "core/experiment/step_benchmark.hpp"

namespace asperity::app {
namespace {

nlohmann::json to_json(const StepCost& c) {
  nlohmann::json entry{{"triangles", c.triangles},
                       {"contact_points", c.contact_points},
                       {"threads", c.threads},
                       {"fast_ns_per_triangle_step", c.fast_ns},
                       {"fast_ns_per_contact_point", c.fast_contact_ns},
                       {"fast_motion_ns_per_triangle", c.fast_motion_ns},
                       {"fast_us_per_step", 1e-3 * c.fast_ns * static_cast<double>(c.triangles)},
                       {"bytes_per_triangle", c.bytes_per_triangle},
                       {"flops_per_triangle_step", c.flops_per_triangle},
                       {"traffic_bytes_per_triangle_step", c.traffic_per_triangle},
                       {"peak_gflops", 1e-9 * c.peak.flops},
                       {"peak_gb_per_s", 1e-9 * c.peak.bandwidth},
                       {"bound_ns_per_triangle_step", c.bound_ns},
                       {"fraction_of_bound", c.bound_ns / c.fast_ns}};
  if (c.reference_ns > 0.0) entry["reference_ns_per_triangle_step"] = c.reference_ns;
  return entry;
}

void print_head() {
  fmt::print("{:>9} {:>7} {:>10} {:>8} {:>6} {:>11} {:>9} {:>10} {:>7} {:>7} {:>6} {:>8} {:>9}\n", "triangles",
             "threads", "reference", "fast", "ratio", "contact pt", "motion", "step", "memory", "peak", "peak", "bound",
             "fraction");
  fmt::print("{:>9} {:>7} {:>10} {:>8} {:>6} {:>11} {:>9} {:>10} {:>7} {:>7} {:>6} {:>8} {:>9}\n", "", "", "ns/tri",
             "ns/tri", "", "ns", "ns/tri", "us", "B/tri", "Gflop/s", "GB/s", "ns/tri", "");
}

void print_row(const StepCost& c) {
  const bool compared = c.reference_ns > 0.0;
  fmt::print(
      "{:>9} {:>7} {:>10} {:>8.1f} {:>6} {:>11.2f} {:>9.1f} {:>10.1f} {:>7.0f} {:>7.1f} {:>6.1f} {:>8.1f} {:>9.2f}\n",
      c.triangles, c.threads, compared ? fmt::format("{:.1f}", c.reference_ns) : "", c.fast_ns,
      compared ? fmt::format("{:.2f}", c.reference_ns / c.fast_ns) : "", c.fast_contact_ns, c.fast_motion_ns,
      1e-3 * c.fast_ns * static_cast<double>(c.triangles), c.bytes_per_triangle, 1e-9 * c.peak.flops,
      1e-9 * c.peak.bandwidth, c.bound_ns, c.bound_ns / c.fast_ns);
  std::cout.flush();
}

/// The smaller registers on the smallest mesh, one thread.
nlohmann::json other_instruction_sets(const System& system) {
  nlohmann::json entries = nlohmann::json::array();
  for (const InstructionSet& set : instruction_sets()) {
    const ForcedInstructionSet forced(set);
    const StepCost cost = measure_step(system, {1}).front();
    entries.push_back({{"simd", set.name}, {"ratio", cost.reference_ns / cost.fast_ns}});
    entries.back().update(to_json(cost));
    fmt::print("{:>9} {} threads 1: {:.1f} ns/tri, {:.2f} times the reference\n", cost.triangles, set.name,
               cost.fast_ns, cost.reference_ns / cost.fast_ns);
  }
  return entries;
}

}  // namespace

int bench_command(const BenchOptions& options) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<int> thread_counts{1};
  if (cores > 1) thread_counts.push_back(cores);
  std::vector<int> sizes{4050, 16000, 64000, 256000, 1000000};
  if (options.triangles) sizes = {*options.triangles};
  nlohmann::json report{{"version", build_info().version},
                        {"revision", build_info().revision},
                        {"simd", instruction_set()},
                        {"cores", cores}};
  fmt::print("{} {}, instruction set {}\n", build_info().version, build_info().revision, instruction_set());
  nlohmann::json others;
  print_head();
  for (int triangles : sizes) {
    const System system = benchmark_system(triangles);
    for (const StepCost& cost : measure_step(system, thread_counts)) {
      report["sizes"].push_back(to_json(cost));
      print_row(cost);
    }
    if (triangles == sizes.front()) others = other_instruction_sets(system);
  }
  report["instruction_sets"] = others;
  if (options.json) write_file_atomically(*options.json, report.dump(2) + "\n");
  return 0;
}

}  // namespace asperity::app
