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

void add_passes(nlohmann::json& entry, const std::string& kernel, const PassCosts& costs) {
  entry[kernel + "_ns_per_triangle_step"] = costs.triangle_ns;
  entry[kernel + "_ns_per_contact_point"] = costs.contact_ns;
  entry[kernel + "_motion_ns_per_triangle"] = costs.motion_ns;
  entry[kernel + "_us_per_step"] = costs.step_us;
}

nlohmann::json to_json(const StepCost& c) {
  nlohmann::json entry{{"triangles", c.triangles},
                       {"contact_points", c.contact_points},
                       {"threads", c.threads},
                       {"bytes_per_triangle", c.bytes_per_triangle},
                       {"flops_per_triangle_step", c.flops_per_triangle},
                       {"traffic_bytes_per_triangle_step", c.traffic_per_triangle},
                       {"peak_gflops", 1e-9 * c.peak.flops},
                       {"peak_gb_per_s", 1e-9 * c.peak.bandwidth},
                       {"bound_ns_per_triangle_step", c.bound_ns},
                       {"fraction_of_bound", c.bound_ns / c.fast.triangle_ns}};
  add_passes(entry, "fast", c.fast);
  if (c.reference) add_passes(entry, "reference", *c.reference);
  return entry;
}

void print_head() {
  fmt::print("{:>9} {:>7}  {:<9} {:>8} {:>6} {:>10} {:>8} {:>10} {:>7} {:>8} {:>6} {:>7} {:>8}\n", "triangles",
             "threads", "kernel", "step", "ratio", "contact pt", "motion", "step", "memory", "peak", "peak", "bound",
             "reached");
  fmt::print("{:>9} {:>7}  {:<9} {:>8} {:>6} {:>10} {:>8} {:>10} {:>7} {:>8} {:>6} {:>7} {:>8}\n", "", "", "", "ns/tri",
             "", "ns", "ns/tri", "us", "B/tri", "Gflop/s", "GB/s", "ns/tri", "");
}

void print_row(const StepCost& c, const std::string& kernel) {
  const auto passes = [&](const std::string& name, const PassCosts& p, const std::string& ratio) {
    fmt::print("{:>9} {:>7}  {:<9} {:>8.1f} {:>6} {:>10.2f} {:>8.1f} {:>10.1f}", c.triangles, c.threads, name,
               p.triangle_ns, ratio, p.contact_ns, p.motion_ns, p.step_us);
  };
  if (c.reference) {
    passes("reference", *c.reference, "");
    fmt::print("\n");
  }
  passes(kernel, c.fast, c.reference ? fmt::format("{:.2f}", c.reference->triangle_ns / c.fast.triangle_ns) : "");
  fmt::print(" {:>7.0f} {:>8.1f} {:>6.1f} {:>7.1f} {:>8.2f}\n", c.bytes_per_triangle, 1e-9 * c.peak.flops,
             1e-9 * c.peak.bandwidth, c.bound_ns, c.bound_ns / c.fast.triangle_ns);
  std::cout.flush();
}

/// The smaller registers on the smallest mesh, one thread.
nlohmann::json other_instruction_sets(const System& system) {
  nlohmann::json entries = nlohmann::json::array();
  for (const InstructionSet& set : instruction_sets()) {
    const ForcedInstructionSet forced(set);
    const StepCost cost = measure_step(system, {1}).front();
    entries.push_back({{"simd", set.name}, {"ratio", cost.reference->triangle_ns / cost.fast.triangle_ns}});
    entries.back().update(to_json(cost));
    print_row(cost, set.name);
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
      print_row(cost, "fast");
    }
    if (triangles == sizes.front()) others = other_instruction_sets(system);
  }
  report["instruction_sets"] = others;
  if (options.json) write_file_atomically(*options.json, report.dump(2) + "\n");
  return 0;
}

}  // namespace asperity::app
