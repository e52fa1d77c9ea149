"""`asperity bench`: both kernels timed in turns, figures as JSON. How fast they are is no matter of this test."""
import json

import support
from support import SCRATCH


class Bench(support.CommandLineTest):
    def test_every_figure_is_there_and_the_memory_stays_below_its_bound(self):
        report = SCRATCH / "bench.json"
        result = self.succeed("bench", "--triangles", 1000, "--json", report)
        found = json.loads(report.read_text())
        self.assertIn(found["simd"], result.stdout)
        one = [size for size in found["sizes"] if size["threads"] == 1]
        self.assertEqual(len(one), 1)
        self.assertAlmostEqual(one[0]["triangles"], 1000, delta=50)
        for name in ("reference_ns_per_triangle_step", "fast_ns_per_triangle_step", "fast_ns_per_contact_point",
                     "fast_us_per_step", "bound_ns_per_triangle_step", "fraction_of_bound", "peak_gflops"):
            self.assertGreater(one[0][name], 0, name)
        self.assertLessEqual(one[0]["bytes_per_triangle"], 650)  # 600 from 4,000 triangles on; here the outline weighs more
        names = [entry["simd"] for entry in found["instruction_sets"]]
        self.assertEqual(names[0], found["simd"])
        self.assertEqual(len(names), len(set(names)))

    def test_a_size_out_of_range_is_a_usage_error(self):
        self.fail_with(2, "bench", "--triangles", 3)


if __name__ == "__main__":
    support.main()
