"""The full set: hundreds of data sets on rocks drawn anew, against the method's rates. A rate fails where its whole 95 % interval does.

ASPERITY_ROCKS=SEED repeats the rocks and draws that a run printed. Specimens and rows stay in outputs/, so a run that was ended goes on.
"""
import json
import os
import random
import subprocess
import sys
import unittest
from pathlib import Path

import hidden_support
from hidden_support import BINARY, SOURCE

LEVEL = "0.02"  # the tool's
SERIES = Path(__file__).with_name("series.py")
SIZES = {"rich": ("--specimens", "6", "--sets", "300", "--meshes", "8"), "poor": ("--specimens", "3", "--sets", "300", "--meshes", "4")}


class Rates:
    """What both suites have to keep: they may see little, but must not see what is not there."""
    @classmethod
    def setUpClass(cls):
        seed = os.environ.get("ASPERITY_ROCKS") or str(random.SystemRandom().randrange(10**9))
        out = SOURCE / f"outputs/hidden_rates_{cls.suite}_{seed}"
        print(f"{cls.suite} suite, rocks {seed}", flush=True)
        call = [sys.executable, str(SERIES), str(BINARY), str(SOURCE), "--suite", cls.suite, *SIZES[cls.suite], "--each", "10", "--pairs", "0",
                "--amplitudes", "1", "--blocks", "1", "--alarm-level", LEVEL, "--seed", seed, "--rocks", seed, "--out", str(out)]
        subprocess.run(call, check=True)
        summary = json.loads((out / "summary.json").read_text())
        cls.kinds, cls.levels = summary["kinds"], summary["alarm_levels"]

    def at_most(self, kind, rate, share):
        found = self.kinds[kind][rate]
        self.assertLessEqual(found["interval_95"][0], share, (kind, rate, found))

    def at_least(self, kind, rate, share):
        found = self.kinds[kind][rate]
        self.assertGreaterEqual(found["interval_95"][1], share, (kind, rate, found))

    def test_alarms_where_nothing_is_hidden(self):
        self.at_most("null", "detected", 0.03)

    def test_names_where_nothing_is_hidden(self):
        names = self.levels["run"]["names on null data"]
        self.assertLessEqual(names["interval_95"][0], 0.01, names)

    def test_wrong_single_names(self):
        self.at_most("amplitude 1", "wrong single name", 0.05)


class PoorSuite(Rates, unittest.TestCase):
    suite = "poor"


class RichSuite(Rates, unittest.TestCase):
    suite = "rich"

    def test_strong_effects_are_detected(self):
        self.at_least("amplitude 1", "detected", 0.8)

    def test_a_true_cause_is_in_the_set(self):
        self.at_least("amplitude 1", "a true cause in the set, particles of another size among them", 0.9)


if __name__ == "__main__":
    hidden_support.main()
