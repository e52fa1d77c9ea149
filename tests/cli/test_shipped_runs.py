"""The shipped quickstart and uniaxial test at full size: the promises of README on time, energy and failure."""
import json
import os
import subprocess
import time

import support
from support import SCRATCH, SOURCE, CommandLineTest

MINUTES = 8 * 60  # of one call, on a core that others use too


def run(config, *arguments):
    out = SCRATCH / config.replace("/", "_")
    began = time.monotonic()
    result = subprocess.run(support.command("run", SOURCE / "configs" / config, "--out", out, "--quiet", *arguments),
                            capture_output=True, text=True, timeout=MINUTES, env=support.environment())
    return result, out, time.monotonic() - began


def summary(out):
    return json.loads((out / "summary.json").read_text())


class Quickstart(CommandLineTest):
    def test_splits_the_disc_within_a_minute_and_closes_the_energy_account(self):
        result, out, seconds = run("quickstart.json")
        self.assertEqual(result.returncode, 0, result.stderr)
        found = summary(out)
        print(f"quickstart: {seconds:.0f} s, {found['results']}, closure {found['energy']['relative_closure_error']:.1e}")
        self.assertLess(found["energy"]["relative_closure_error"], 1e-3)  # required of every default-law run
        self.assertLess(found["energy"]["kinetic_over_stored_before_peak"], 0.02)  # quasi-static
        # 2.59 MPa on this mesh; the order of breakage is chaotic, so another processor may find a few per cent more or less.
        self.assertTrue(2.2 < found["results"]["tensile_strength_mpa"] < 3.0, found["results"])
        self.assertGreater(found["cracks"]["tension"], 5)
        self.assertTrue(found["failure_mode"]["at_end"]["splits"], found["failure_mode"])  # from jaw to jaw along cracks, M25
        self.assertEqual(found["warnings"], [])
        self.assertGreaterEqual(len(list((out / "frames").glob("cracks_*.png"))), 10)
        load = os.getloadavg()[0] / os.cpu_count()
        self.assertLess(seconds, 60 * max(1.0, load))  # required with the machine's cores free


class Uniaxial(CommandLineTest):
    def test_passes_a_peak_and_closes_the_energy_account(self):
        result, out, seconds = run("paper/uniaxial.json", "--no-render")
        self.assertEqual(result.returncode, 0, result.stderr)
        found = summary(out)
        print(f"uniaxial: {seconds:.0f} s, {found['results']}, closure {found['energy']['relative_closure_error']:.1e}")
        self.assertLess(found["energy"]["relative_closure_error"], 1e-3)
        self.assertLess(found["energy"]["kinetic_over_stored_before_peak"], 0.02)
        self.assertEqual(found["warnings"], [])
        self.assertTrue(17 < found["results"]["peak_axial_stress_mpa"] < 21, found["results"])  # 19.0 on this mesh
        self.assertTrue(0.6 < found["results"]["youngs_modulus_gpa"] < 0.75, found["results"])  # 0.678: contacts in series


if __name__ == "__main__":
    support.main()
