"""Seals, the pool of specimens, and how verdicts are scored."""
import copy
import json
import unittest

import dataset
import draw
import effects
import hidden_support
import pool as pool_module
import removed
import scoring
import series
import together
from hidden_support import BASE, LIBRARY, SCRATCH, SOURCE

STAND_IN = SOURCE / "tests/hidden/stand_in.py"


def config(seed):
    made = copy.deepcopy(BASE["bases"]["uniaxial"])
    made["particles"]["seed"] = seed
    return made


class Seals(unittest.TestCase):
    TRUTH = {"mechanisms": [["seating", 1.0]], "outside": None, "edge_factor": 1.0}

    def test_a_seal_opens_after_the_verdict_and_tells_if_it_was_changed(self):
        path, verdict = SCRATCH / "seal" / "truth.json", SCRATCH / "seal" / "verdict.json"
        sha256 = dataset.seal(self.TRUTH, path)
        with self.assertRaisesRegex(RuntimeError, "may be opened after"):
            dataset.open_seal(path, sha256, verdict)
        verdict.write_text("{}")
        self.assertEqual(dataset.open_seal(path, sha256, verdict), self.TRUTH)
        path.write_text(path.read_text().replace("seating", "damping"))
        with self.assertRaisesRegex(RuntimeError, "not what was sealed"):
            dataset.open_seal(path, sha256, verdict)

    def test_a_hash_cannot_be_guessed(self):
        self.assertNotEqual(*(dataset.seal(self.TRUTH, SCRATCH / "guess" / f"{i}.json") for i in range(2)))


class ThePool(unittest.TestCase):
    def pool(self, name):
        return pool_module.Pool(STAND_IN, SCRATCH / name, BASE)

    def test_a_run_is_made_once(self):
        pool, configs = self.pool("once"), [config(s) for s in (1, 2, 3, 4, 1)]
        self.assertEqual(pool.fill(configs[:2]), 2)
        self.assertEqual(self.pool("once").fill(configs), 2)
        self.assertEqual(pool.fill(configs), 0)
        self.assertEqual(pool.curve(config(2))["path"][3], 6.0)
        self.assertEqual([p.name for p in pool.root.iterdir()], [pool.folder.name])

    def test_what_decides_a_result_decides_the_key(self):
        other = config(1)
        other["mechanisms"] = [{"type": "seating", "amplitude": 1.0}]
        keys = {pool_module.config_key(c) for c in (config(1), config(2), other)}
        self.assertEqual(len(keys), 3)
        self.assertEqual(pool_module.config_key(config(1)), pool_module.config_key(json.loads(json.dumps(config(1)))))

    def test_a_lost_specimen_is_kept_as_such_and_another_takes_its_place(self):
        pool = self.pool("lost")
        pool.fill([config(5)])
        with self.assertRaises(pool_module.LostSpecimen):
            pool.curve(config(5))
        self.assertEqual(len(dataset.intact_curves(pool, [config(5), config(2), config(3)], 2)), 2)
        with self.assertRaisesRegex(pool_module.LostSpecimen, "only 1 of 2"):
            dataset.intact_curves(pool, [config(5), config(2)], 2)

    def test_an_interrupted_run_is_not_kept(self):
        pool = self.pool("interrupted")
        with self.assertRaisesRegex(RuntimeError, "exit code 130"):
            pool.fill([config(7)])
        self.assertFalse(pool.place(config(7)).exists())


def verdict(status, *causes):
    return {"status": status, "causes": list(causes)}


def truth(*names, edge=1.0, outside=None):
    return {"mechanisms": [[n, 1.0] for n in names], "edge_factor": edge, "outside": outside}


class Scoring(unittest.TestCase):
    def assert_judged(self, hidden, found, **expected):
        judged = scoring.judge(hidden, found)
        expected = {"among_all": expected.get("in_set", False)} | expected
        for key in ("detected", "in_set", "among_all", "wrong_single", "wrong_pair", "unexplained", "cannot_tell"):
            self.assertEqual(judged[key], expected.get(key, False), (key, found))

    def test_verdicts_against_what_is_hidden(self):
        seating = truth("seating")
        self.assert_judged(seating, verdict("nothing_found"))
        self.assert_judged(seating, verdict("named", "seating"), detected=True, in_set=True)
        self.assert_judged(seating, verdict("named", "damping"), detected=True, wrong_single=True)
        self.assert_judged(seating, verdict("indistinguishable", "damping", "seating"), detected=True, in_set=True)
        self.assert_judged(seating, verdict("indistinguishable", "seating", "a", "b", "c"), detected=True, among_all=True, cannot_tell=True)
        self.assert_judged(seating, verdict("indistinguishable", "a", "b", "c", "d"), detected=True, cannot_tell=True)
        self.assert_judged(seating, verdict("two_causes", "a", "b"), detected=True, wrong_pair=True)
        self.assert_judged(seating, verdict("unexplained"), detected=True, unexplained=True)
        self.assert_judged(truth(), verdict("named", "damping"), detected=True, wrong_single=True)
        self.assert_judged(truth("a", "b"), verdict("two_causes", "a", "b"), detected=True, in_set=True)
        self.assert_judged(truth("a", "b"), verdict("named", "a"), detected=True)
        self.assertTrue(scoring.judge(truth("a", "b"), verdict("named", "a"))["partly"])

    def test_what_a_verdict_foretells_is_held_against_it(self):
        found = [(verdict("named", "seating"), 0.4), (verdict("nothing_found"), 1.0), (verdict("nothing_found"), 1.01),
                 (verdict("named", "seating"), None)]
        rows = [{"kind": "amplitude 1", **scoring.judge(truth("seating"), v | {"detectable_amplitude": {"seating": amplitude, "damping": 0.1}})}
                for v, amplitude in found]
        self.assertEqual([(r["count"], r["of"]) for r in scoring.foretold_rates(rows).values()], [(1, 2), (1, 2)])
        self.assertFalse(scoring.judge(truth(), found[0][0])["foretold"])

    def test_particles_of_another_size_are_a_cause_too(self):
        self.assert_judged(truth("seating", edge=1.15), verdict("named", "mesh_size"), detected=True)
        self.assert_judged(truth("seating"), verdict("named", "mesh_size"), detected=True, wrong_single=True)
        self.assertTrue(scoring.judge(truth("seating", edge=1.15), verdict("named", "mesh_size"))["partly"])
        self.assertFalse(scoring.judge(truth("seating"), verdict("named", "mesh_size"))["partly"])

    def test_binomial_intervals(self):
        # Clopper & Pearson's closed forms at the ends; 5 of 10 as in their table.
        self.assertAlmostEqual(scoring.binomial_interval(0, 300)[1], 1 - 0.025 ** (1 / 300), 12)
        self.assertAlmostEqual(scoring.binomial_interval(300, 300)[0], 0.025 ** (1 / 300), 12)
        for found, printed in zip(scoring.binomial_interval(5, 10), (0.187, 0.813)):
            self.assertAlmostEqual(found, printed, 3)

    def test_a_confusion_matrix_counts_answers(self):
        rows = [{"case": "seating@1", **scoring.judge(truth("seating"), v)} for v in
                (verdict("named", "damping"), verdict("named", "seating"), verdict("indistinguishable", "seating", "damping"), verdict("unexplained"))]
        self.assertEqual(scoring.confusion(rows), {"seating@1": {"damping": 1, "seating": 1, "tie_with_truth": 1, "unexplained": 1}})

    def test_a_confusion_matrix_has_mechanisms_on_its_diagonal(self):
        found = {"null": {"nothing_found": 3}, "seating@1": {"seating": 2, "tie_with_truth": 1}, "damping@1": {"seating": 1}}
        matrix = scoring.confusion_matrix(found, ["seating", "damping"])
        self.assertEqual(matrix["rows"], ["damping", "seating", "null"])
        self.assertEqual(matrix["columns"][:3], ["damping", "seating", "a tie with the truth"])
        self.assertEqual([row[:3] for row in matrix["counts"]], [[0, 1, 0], [0, 2, 1], [0, 0, 0]])
        self.assertEqual(sum(map(sum, matrix["counts"])), 7)

    def test_a_confusion_matrix_has_names_that_nothing_hides_and_strengths(self):
        matrix = scoring.confusion_matrix({"seating@0.5": {"mesh_size": 1, "nothing_found": 2}, "seating@1": {"seating": 3}}, ["seating"])
        self.assertEqual(matrix["rows"], ["seating × 0.5", "seating"])
        self.assertEqual(matrix["columns"][:2], ["mesh_size", "seating"])
        self.assertEqual([sum(row) for row in matrix["counts"]], [3, 3])

    def test_rates_at_a_smaller_alarm_level_are_those_of_verdicts_beyond_its_gate(self):
        def row(kind, hidden, found, p_explained, p_misfit=0.5):
            return {"kind": kind, "case": kind, "p_explained": p_explained, "p_misfit": p_misfit, **scoring.judge(hidden, found)}
        seating = truth("seating")
        rows = [row("null", truth(), verdict("named", "damping"), 0.04), row("null", truth(), verdict("unexplained"), 0.3, 1e-5),
                row("null", truth(), verdict("nothing_found"), 0.6), row("amplitude 1", seating, verdict("named", "seating"), 0.002),
                row("amplitude 1", seating, verdict("named", "damping"), 0.025), row("outside", truth(), verdict("unexplained"), 0.002)]
        found = scoring.by_alarm_level(rows)
        count = {level: {name: (r["count"], r["of"]) for name, r in rates.items()} for level, rates in found.items()}
        self.assertEqual(count["0.01"], {"alarms on null data": (1, 3), "names on null data": (0, 3), "detected": (1, 2),
                                         "truth in the set": (1, 1), "truth among all names": (1, 1), "wrong single name": (0, 1)})
        self.assertEqual(count["0.03"]["detected"], (2, 2))
        self.assertEqual(count["0.03"]["wrong single name"], (1, 2))
        self.assertEqual(count["0.03"]["names on null data"], (0, 3))
        self.assertEqual(count["run"]["names on null data"], (1, 3))
        self.assertNotIn("0.05", count)  # as it was run
        claimed = rows[0] | {"gain": {"elpd_change": 2.0, "claimed": True}}
        self.assertIsNone(scoring.at_alarm_level(claimed, 0.01)["gain"])  # nothing found, nothing claimed
        self.assertEqual(scoring.at_alarm_level(claimed, 0.05), claimed)

    def test_series_together_part_rocks_with_other_particles(self):
        def row(edge, found):
            hidden = truth("seating", edge=edge)
            return {"kind": "amplitude 1", "case": "seating@1", "truth": hidden, **scoring.judge(hidden, found)}
        rows = [row(1.0, verdict("named", "seating")), row(1.15, verdict("named", "damping")), row(0.85, verdict("nothing_found"))]
        rates = {name: scoring.rates(group)["wrong single name"] for name, group in together.groups_of(rows).items()}
        self.assertEqual({name: (r["count"], r["of"]) for name, r in rates.items()}, {
            f"{name}{of}": counts for name in ("amplitude 1", "seating@1") for of, counts in
            (("", (1, 2)), (", the base's particles", (0, 1)), (", other particles", (1, 1)))})
        self.assertIn("amplitude 1, detected: 2/3", together.text_of(rows))

    def test_a_name_instead_of_a_missing_one_is_right_only_for_its_twin(self):
        whole = {"cosines": [{"ids": ["seating", "damping"], "cosine": -0.95}, {"ids": ["frame", "seating"], "cosine": 0.3}]}
        self.assertEqual([removed.cosine_with(whole, "seating", other) for other in ("damping", "frame", "skin")], [0.95, 0.3, None])
        named = verdict("named", "x")
        self.assertEqual([removed.answer(named, [c]) for c in (0.95, 0.3, None)], ["named a twin", "named another", "named another"])
        tie = verdict("indistinguishable", "x", "y")
        self.assertEqual([removed.answer(tie, [None, c]) for c in (0.95, 0.3)], ["a tie with a twin", "a tie without one"])
        self.assertEqual(removed.answer(verdict("unexplained"), []), "unexplained")
        self.assertTrue({removed.answer(verdict(s), []) for s in ("nothing_found", "unexplained", "two_causes")} < set(removed.ANSWERS))

    def test_gain_of_verdicts_without_an_extension_is_left_out(self):
        none = {"elpd_change": None, "elpd_interval_90": None}
        some = {"elpd_change": 2.0, "claimed": True, "rms_z_before": 2.0, "rms_z_after": 0.5}
        less = {"elpd_change": 1.0, "claimed": False, "rms_z_before": 1.0, "rms_z_after": 0.75}
        rows = [{"gain": none}, {"gain": some}, {"gain": less}]
        self.assertEqual(scoring.gain_summary(rows), {"verdicts": 2, "mean_elpd_change": 1.5, "claimed": 1, "median_error_share": 0.5,
                                                      "halved": 1, "median_error_before": 1.5,
                                                      "where_the_base_errs_beyond_scatter": 1, "median_share_beyond_scatter": 0.0,
                                                      "pooled_share_beyond_scatter": 0.0})
        worse = {"elpd_change": -1.0, "claimed": False, "rms_z_before": 5 / 3, "rms_z_after": 13 / 12}  # 4/3 and 5/12 beyond scatter
        self.assertAlmostEqual(scoring.gain_summary([{"gain": worse}])["median_share_beyond_scatter"], 5 / 16)
        self.assertAlmostEqual(scoring.gain_summary([{"gain": worse}])["pooled_share_beyond_scatter"], 5 / 16)
        self.assertIsNone(scoring.gain_summary(rows[:1]))


class Series(unittest.TestCase):
    def options(self, *arguments):
        o = series.options(["binary", str(SOURCE), *arguments])
        o.seed = o.seed or "1"
        return o

    def test_every_mechanism_that_acts_is_hidden_and_the_order_tells_nothing(self):
        o = self.options("--sets", "20", "--each", "3", "--pairs", "4", "--suite", "quick")
        sets = series.all_sets(o, LIBRARY)
        platens = [id for id, acts in LIBRARY.items() if set(acts) - {"direct_shear"}]
        counts = {name: sum(s[0] == name for s in sets) for name in {s[0] for s in sets}}
        self.assertEqual(counts["null"], 20)
        self.assertEqual({n for n in counts if n.endswith("@0.5")}, {f"{id}@0.5" for id in platens})
        self.assertEqual(counts["seating@1"], 3)
        self.assertEqual(sum(s[1] == "pair" for s in sets), 4)
        self.assertEqual(len(sets), 20 + 2 * 3 * len(platens) + 4 + 3 * len(effects.OUTSIDE))
        self.assertNotEqual([s[0] for s in sets], sorted(s[0] for s in sets))

    def test_null_data_have_the_bases_particles(self):
        o = self.options("--sets", "30")
        for name, kind, plan, chosen in series.all_sets(o, LIBRARY):
            if kind in ("null", "outside"):
                self.assertEqual(dataset.truth_of(BASE, plan, chosen)["edge_factor"], 1.0)

    def test_effects_of_the_recording_share_the_runs_of_null_data(self):
        plan, test = dataset.Plan("quick"), dataset.tests_of(dataset.Plan("quick"))[0]
        one, other, third = (effects.Effects((), name, LIBRARY) for name in (None, "yielding_cell", "weak_discs"))
        configs = [dataset.config_of(BASE, plan, e, 0, test, 0) for e in (one, other, third)]
        self.assertEqual(configs[0], configs[1])
        self.assertNotEqual(configs[0], configs[2])
        self.assertNotEqual(draw.stream("a").random(), draw.stream("b").random())


if __name__ == "__main__":
    hidden_support.main()
