"""Verdicts of `asperity confront` on data sets that hide an effect, and the locks that keep them honest.

The draws are fixed and stratified over the kinds of verdict; what is hidden is opened after each verdict exists. series.py draws anew.
"""
import copy
import json
import random
import re
import shutil
import unittest

import dataset
import effects
import hidden_support
import scoring
import series
from hidden_support import BASE, BINARY, LIBRARY, SCRATCH, SOURCE
from pool import Pool
from verdicts import STATUSES, Confronter, bytes_of

PLAN = dataset.Plan("quick", specimens=4, blocks=1, meshes=6)
# name -> what is hidden; each is one data set.
HIDDEN = {
    "null_1": ((), None),
    "null_2": ((), None),
    "frame": ((("frame_compliance", 1.0),), None),
    "seats": ((("seating", 1.0),), None),
    "faint": ((("frame_compliance", 0.01),), None),  # a quarter of what would be seen
    "seats_and_frame": ((("seating", 1.0), ("frame_compliance", 0.15)), None),
    "slip": ((), "slipping_gauge"),
}
COMPRESSION = ["peak_axial_stress_mpa", "peak_strain_from_toe"]
PEAKS = {"uniaxial": COMPRESSION, "triaxial": COMPRESSION, "brazilian": ["tensile_strength_mpa"]}


def effects_of(name):
    mechanisms, outside = HIDDEN[name]
    return effects.Effects(mechanisms, outside, LIBRARY)


def folder_of(name):
    """A neutral path: what is hidden must not stand in it."""
    return SCRATCH / f"set_{list(HIDDEN).index(name)}"


class Verdicts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pool = Pool(BINARY, SOURCE / "outputs/hidden_pool", BASE)
        cls.confronter = Confronter(BINARY, SOURCE, SOURCE / "outputs/hidden_store")
        cls.draws = {name: dataset.draw_set(PLAN, effects_of(name), f"fixed/{name}") for name in HIDDEN}
        cls.pool.fill([c for d in cls.draws.values() for c in dataset.needed_configs(BASE, PLAN, d)])
        cls.rows, cls.verdicts = {}, {}
        for name, chosen in cls.draws.items():
            cls.rows[name] = series.run_set(BASE, cls.pool, cls.confronter, PLAN, chosen, folder_of(name))
            cls.verdicts[name] = json.loads((folder_of(name) / "verdict/verdict.json").read_text())

    def measured(self, name):
        return next((folder_of(name) / "data").glob("D*.json"))

    def confront(self, measured, name, settings=()):
        return self.confronter.verdict(measured, SCRATCH / name, PLAN.suite, settings)

    def test_no_alarm_where_nothing_is_hidden(self):
        for name in ("null_1", "null_2", "faint"):
            self.assertEqual(self.rows[name]["status"], "nothing_found", name)

    def test_a_strong_effect_is_found_and_in_the_set(self):
        for name in ("frame", "seats"):
            self.assertTrue(self.rows[name]["in_set"], self.rows[name])

    def test_no_wrong_single_name(self):
        for name, row in self.rows.items():
            self.assertFalse(row["wrong_single"], (name, row["causes"]))

    def test_two_effects_of_which_none_hides_the_other_are_both_named(self):
        row = self.rows["seats_and_frame"]
        self.assertEqual((row["status"], row["causes"]), ("two_causes", ["frame_compliance", "seating"]))

    def test_an_effect_outside_the_library_gets_no_name(self):
        self.assertEqual((self.rows["slip"]["status"], self.rows["slip"]["causes"]), ("unexplained", []))

    def test_features_that_cannot_tell_causes_apart_give_a_tie_that_holds_the_truth(self):
        verdict = self.confront(self.measured("frame"), "peaks_alone", [("/features", PEAKS)])
        self.assertEqual(verdict["status"], "indistinguishable")
        self.assertIn("frame_compliance", verdict["causes"])
        self.assertLessEqual(len(verdict["causes"]), scoring.MOST_NAMES)

    def test_every_kind_of_verdict_but_a_tie_occurs(self):
        self.assertEqual({row["status"] for row in self.rows.values()}, set(STATUSES) - {"indistinguishable"})

    def test_a_claimed_gain_is_on_kept_back_tests_and_none_is_claimed_where_nothing_is_hidden(self):
        self.assertTrue(self.verdicts["seats"]["gain"]["claimed"])
        for name in ("null_1", "null_2", "faint"):
            self.assertFalse(self.verdicts[name]["gain"]["claimed"], name)

    def test_what_no_result_depends_on_changes_no_byte(self):
        source = self.measured("frame")
        folder = SCRATCH / "renamed"
        folder.mkdir()
        data = json.loads(source.read_text())
        data |= {"name": "null", "material": "no effect at all", "source": "seating=1.0", "description": "platen_friction"}
        for number, test in enumerate(data["tests"]):
            shutil.copy(source.parent / test["curve"], folder / f"seating_{number}.csv")
            test |= {"curve": f"seating_{number}.csv", "note": "damping"}
        (folder / "initial_defects.json").write_text(json.dumps(data))
        self.confront(folder / "initial_defects.json", "renamed_verdict")
        self.assertEqual(bytes_of(SCRATCH / "renamed_verdict"), bytes_of(folder_of("frame") / "verdict"))

    def test_other_data_under_the_same_names_change_the_verdict(self):
        folder = SCRATCH / "swapped"
        shutil.copytree(self.measured("frame").parent, folder)
        for table in folder.glob("T*.csv"):
            shutil.copy(self.measured("null_1").parent / table.name, table)
        verdict = self.confront(next(folder.glob("D*.json")), "swapped_verdict")
        self.assertEqual((verdict["status"], verdict["causes"]), ("nothing_found", []))

    def test_without_its_mechanism_a_name_is_impossible(self):
        verdict = self.confront(self.measured("frame"), "without", [("/without", ["frame_compliance"])])
        self.assertNotIn("frame_compliance", json.dumps([verdict["causes"], verdict["candidates"], verdict["pairs"]]))
        self.assertNotEqual(verdict["status"], "nothing_found")

    def test_a_fit_that_is_too_good_raises_an_alarm(self):
        self.assertEqual(self.verdicts["null_1"]["gate"]["alarms"], [])
        data = json.loads(self.measured("null_1").read_text())
        simulated = {}
        for entry in self.verdicts["null_1"]["wrong"]:
            simulated.setdefault(entry["test"], {})[entry["feature"]] = [entry["simulated"]] * PLAN.specimens
        kept = []
        for test in copy.deepcopy(data["tests"]):
            if test["id"] in simulated:
                test.pop("curve")
                kept.append(test | {"results": simulated[test["id"]]})
        path = SCRATCH / "too_good.json"
        path.write_text(json.dumps(data | {"tests": kept}))
        verdict = self.confront(path, "too_good")
        self.assertEqual(verdict["status"], "nothing_found")
        self.assertEqual(len(verdict["gate"]["alarms"]), 1, verdict["gate"])

    def test_a_random_twentieth_of_the_bank_is_the_same_when_it_is_computed_again(self):
        """Of the shipped example, joints among its tests; its verdict is the one that the docs state."""
        seed = random.SystemRandom().randrange(10**9)
        result = hidden_support.asperity(
            *self.confronter.call(SOURCE / "configs/measured/laboratory.json", SCRATCH / "checked", "rich")[1:],
            "--check-bank", "0.05", "--check-seed", seed)
        self.assertEqual(result.returncode, 0, f"check seed {seed}: {result.stderr[-2000:]}")
        runs, checked = (int(re.search(rf"(\d+) {word}", result.stdout).group(1)) for word in ("runs", "checked"))
        print(f"check seed {seed}: {checked} of {runs} runs of the bank computed again", flush=True)
        self.assertGreater(checked, 0.03 * runs)
        self.assertIn("status named seating\n", result.stdout)

    def test_a_tie_holds_no_more_names_than_it_says(self):
        for name, row in self.rows.items():
            if row["status"] in ("named", "nothing_found", "unexplained"):
                self.assertEqual(len(row["causes"]), int(row["status"] == "named"), name)

    def test_rates_count_every_data_set(self):
        rows = [row | {"case": name} for name, row in self.rows.items()]
        self.assertEqual(scoring.rates(rows)["detected"]["of"], len(HIDDEN))


if __name__ == "__main__":
    hidden_support.main()
