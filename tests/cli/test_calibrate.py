"""`asperity calibrate`: the printed design as data, and a whole calibration on coarse meshes; bad input."""
import json
import math
import pathlib
import subprocess

import support
from support import SCRATCH, SOURCE, CommandLineTest

COARSE = pathlib.Path(__file__).resolve().parent / "calibration_coarse.json"
TABLE4 = SOURCE / "configs/calibration/paper_table4.json"
PROPERTIES = ("youngs_modulus_gpa", "poissons_ratio", "tensile_strength_mpa", "uniaxial_strength_mpa", "cohesion_mpa", "friction_angle_deg")


def changed(name, change):
    """The coarse calibration with a change, beside it in the scratch folder."""
    config = json.loads(COARSE.read_text())
    config["tests"] = [str((COARSE.parent / t).resolve()) for t in config["tests"]]
    change(config)
    path = SCRATCH / f"{name}.json"
    path.write_text(json.dumps(config))
    return path


def calibrate(config, out, *more):
    return subprocess.run(support.command("calibrate", config, "--out", out, "--store", SCRATCH / "store", *more), capture_output=True, text=True, timeout=600,
                          cwd=SCRATCH, env=support.environment())


def without_cost(folder):
    result = json.loads((folder / "calibration.json").read_text())
    del result["cost"]
    return result


class Data(CommandLineTest):
    def test_printed_equations_are_returned(self):
        out = SCRATCH / "table4"
        self.assertEqual(calibrate(TABLE4, out).returncode, 0)
        result = json.loads((out / "calibration.json").read_text())
        self.assertAlmostEqual(result["models"]["tensile_strength_mpa"]["coefficients"]["x2x3"], -0.03, delta=0.006)
        self.assertEqual(result["solutions"], [])  # the target lies outside the design
        self.assertEqual((out / "audit.md").read_text(), (SOURCE / "docs/paper_audit.md").read_text())
        self.assertTrue((out / "report.html").exists())


class Simulated(CommandLineTest):
    def test_a_calibration_from_start_to_end(self):
        first = SCRATCH / "first"
        run = calibrate(COARSE, first, "--jobs", "2")
        self.assertEqual(run.returncode, 0, run.stderr[-2000:])
        self.assertEqual(run.stdout.strip().splitlines()[-1], str(first))
        result = json.loads((first / "calibration.json").read_text())
        for name in PROPERTIES:
            v = result["verification"][name]
            self.assertGreaterEqual(v["n"], 2)
            self.assertAlmostEqual(v["mean"], sum(v["values"]) / len(v["values"]), places=9)
            self.assertAlmostEqual(v["bias"], v["mean"] / v["target"] - 1, places=9)
        self.assertAlmostEqual(result["elastic"]["assembly"]["youngs_modulus_gpa"], 1.3, delta=0.005 * 1.3)
        self.assertAlmostEqual(result["elastic"]["assembly"]["poissons_ratio"], 0.2, delta=0.005 * 0.2)
        self.assertEqual(len(result["configs"]), 4)
        for config in result["configs"]:
            self.succeed("validate", first / config)
        self.assertEqual(len(result["trade_off"]), 1)
        self.assertGreater(result["cost"]["runs"], 8 * 4)
        for word in ("Outcome", "Analysis of variance", "<img"):
            self.assertIn(word.lower(), (first / "report.html").read_text().lower())
        second = SCRATCH / "second"
        again = calibrate(COARSE, second, "--jobs", "1")
        self.assertEqual(again.returncode, 0, again.stderr[-2000:])
        self.assertEqual(without_cost(first), without_cost(second))  # whatever the number of jobs
        cost = json.loads((second / "calibration.json").read_text())["cost"]
        self.assertEqual(cost["reused"], cost["runs"])
        # the ready configuration gives the verification's own figure
        uniaxial = [c for c in result["configs"] if "uniaxial" in c][0]
        run_folder = SCRATCH / "ready"
        self.succeed("run", first / uniaxial, "--set", "/particles/seed=1001", "--set", "/output/frames=0", "--out", run_folder, "--no-render")
        strength = json.loads((run_folder / "summary.json").read_text())["results"]["peak_axial_stress_mpa"]
        self.assertTrue(any(math.isclose(strength, v, rel_tol=1e-12) for v in result["verification"]["uniaxial_strength_mpa"]["values"]))


class Faults(CommandLineTest):
    def fails(self, name, change, *words):
        out = SCRATCH / f"out_{name}"
        run = calibrate(changed(name, change), out)
        self.assertEqual(run.returncode, 3, run.stderr)
        self.assertFalse(out.exists())
        for word in words:
            self.assertIn(word, run.stderr)

    def test_contradictory_targets(self):
        self.fails("contradiction", lambda c: c["targets"]["uniaxial_strength_mpa"].update(value=20), "uniaxial_strength_mpa", "contradicts", "7.5")

    def test_missing_target(self):
        self.fails("missing", lambda c: c["targets"].pop("youngs_modulus_gpa"), "youngs_modulus_gpa is missing")

    def test_inverted_range(self):
        self.fails("inverted", lambda c: c["factors"][1].update(lower=60, upper=10), "lower", "upper")

    def test_unknown_factor(self):
        self.fails("unknown", lambda c: c["factors"][0].update(pointer="/contacts/cohesion"), "cohesion_mpa")

    def test_no_uniaxial_test(self):
        self.fails("tests", lambda c: c.update(tests=c["tests"][:1]), "/tests", "uniaxial")

    def test_misspelt_key(self):
        self.fails("typo", lambda c: c.update(verfication={}), "verification")


if __name__ == "__main__":
    support.main()
