"""`asperity acceleration`: the table of what a faster solution changes."""
import json

import support
from support import SCRATCH, TINY, asperity

WAYS = ["reference", "reference, rate 1 % off", "configured rate", "rate control", "mass scaling", "elastic start", "all three"]


class Acceleration(support.CommandLineTest):
    def test_table_and_report_agree(self):
        report_file = SCRATCH / "acceleration.json"
        result = asperity("acceleration", TINY, "--seeds", 1, "--reference-rate", 0.5, "--json", report_file)
        report = json.loads(report_file.read_text())
        rows = report["tests"]["tiny_disc"]
        self.assertEqual([row["way"] for row in rows], WAYS)
        for row in rows:
            self.assertIn(f"| {row['way']} | {row['runs'][0]['peak_mpa']:.3f} ", result.stdout)
        within = all(abs(row["peak_difference"]["mean"]) <= report["tolerance"] for row in rows[2:])
        self.assertEqual(result.returncode, 0 if within else 6, result.stderr)
        by_way = {row["way"]: row["runs"][0] for row in rows}
        plain = by_way["configured rate"]
        self.assertAlmostEqual(by_way["reference"]["steps"] / plain["steps"], 2, delta=0.05)
        for way in ("mass scaling", "elastic start"):  # rate control goes slowly where cracks run, and here they do
            self.assertLess(by_way[way]["steps"], plain["steps"], way)
        self.assertEqual(plain["added_mass_fraction"], 0)
        self.assertGreater(by_way["all three"]["added_mass_fraction"], 0)

    def test_a_faulty_configuration_exits_3(self):
        faulty = SCRATCH / "faulty.json"
        faulty.write_text(TINY.read_text().replace('"edge_mm": 5', '"edge_mm": -5'))
        self.assertIn("/particles/edge_mm", self.fail_with(3, "acceleration", faulty))


if __name__ == "__main__":
    support.main()
