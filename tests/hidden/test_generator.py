"""The generator of hidden effects does what it says, tells nothing, and draws what it declares."""
import copy
import json
import math
import re
import statistics
import unittest

import dataset
import draw
import effects
import hidden_support
import laboratory
import recording
from hidden_support import BASE, BINARY, LIBRARY, SCRATCH, asperity, bytes_below
from pool import Pool

NAMES = "|".join([*LIBRARY, *effects.OUTSIDE])
FILE_KEYS = {"name", "material", "source", "instrument", "tests"}
TEST_KEYS = {"id", "experiment", "use", "curve", "ends_before_peak", "plane", "width_mm", "height_mm", "diameter_mm", "confining_pressure_mpa",
             "normal_stress_mpa", "profile", "end_gap_mm"}


def coarse():
    """The laboratory with particles so large that a specimen takes a tenth of a second."""
    base = copy.deepcopy(BASE)
    for experiment, edge in {"uniaxial": 9, "triaxial": 9, "brazilian": 9, "direct_shear": 1.6}.items():
        config = base["bases"][experiment]
        for key in ("tensile", "shear"):
            config["contacts"][f"{key}_stiffness_mpa_per_mm"] *= config["particles"]["edge_mm"] / edge
        config["particles"]["edge_mm"] = edge
    base["bases"]["direct_shear"]["experiment"]["loading"]["shear_rate_mm_per_s"] = 800
    return base


class GeneratedFiles(unittest.TestCase):
    """A whole data set of real, coarse runs."""
    @classmethod
    def setUpClass(cls):
        cls.base, cls.plan = coarse(), dataset.Plan("quick", specimens=2, blocks=2, meshes=3)
        cls.pool = Pool(BINARY, SCRATCH / "pool", cls.base)
        cls.hidden = effects.Effects((("seating", 1.0),), None, LIBRARY)

    def written(self, name, seed, hidden=None, plan=None):
        plan = plan or self.plan
        chosen = dataset.draw_set(plan, hidden or self.hidden, seed)
        self.pool.fill(dataset.needed_configs(self.base, plan, chosen))
        return dataset.write_set(self.base, plan, chosen, self.pool, SCRATCH / name)

    def test_a_file_is_accepted_and_says_nothing_of_what_is_hidden(self):
        path = self.written("accepted", "a", plan=dataset.Plan("rich", specimens=1, blocks=2, meshes=3))
        self.assertEqual(asperity("validate", path).returncode, 0)
        read = asperity("features", path, "--json")
        tests = {t["id"]: t["features"] for t in json.loads(read.stdout)["tests"]}
        self.assertEqual(set(tests), set(laboratory.SUITES["rich"]))
        self.assertEqual({id: tests[id]["loop_count"]["mean"] for id in tests}, {id: float(id in ("U", "T3")) for id in tests})
        files = bytes_below(path.parent)
        self.assertEqual(sorted(files), sorted([path.name, *(f"T{n}.csv" for n in range(1, 9))]))
        data = json.loads(files[path.name])
        self.assertLessEqual(set(data), FILE_KEYS)
        for test in data["tests"]:
            self.assertLessEqual(set(test), TEST_KEYS)
        for name, content in files.items():
            self.assertIsNone(re.search(NAMES, content.decode()), name)
            self.assertRegex(name, r"^[DT][0-9]+\.(json|csv)$")

    def test_equal_draws_give_equal_bytes_and_others_do_not(self):
        first, again, other = (self.written(name, seed).parent for name, seed in (("b1", "b"), ("b2", "b"), ("c", "c")))
        self.assertEqual(bytes_below(first), bytes_below(again))
        self.assertFalse(set(bytes_below(first).values()) & set(bytes_below(other).values()))

    def test_what_is_hidden_is_in_the_curves(self):
        toes = []
        for name, hidden in (("with", self.hidden), ("without", effects.Effects((), None, LIBRARY))):
            path = self.written(name, "d", hidden)
            tests = {t["id"]: t["features"] for t in json.loads(asperity("features", path, "--json").stdout)["tests"]}
            toes.append(tests["U"]["toe_travel_strain"]["mean"])
        # Seats close 0.1 mm over 100 mm, a part of it below the window of the modulus; a specimen's toe scatters by 5e-5.
        self.assertGreater(toes[0], toes[1] + 1.5e-4)


class Configurations(unittest.TestCase):
    def accepted(self, configs, folder):
        (SCRATCH / folder).mkdir()
        paths = []
        for number, config in enumerate(configs):
            paths.append(SCRATCH / folder / f"{number}.json")
            paths[-1].write_text(json.dumps(config))
        result = asperity("validate", *paths)
        self.assertEqual(result.returncode, 0, result.stderr)

    def configs_of(self, hidden):
        """Each test with the base's particles, and the joint, whose teeth set limits to them, with others."""
        block, specimen = dataset.block_of(BASE, dataset.Plan("rich"), hidden, 0), draw.draw_specimen(draw.stream("any"))
        cases = [(t, 1.0) for t in laboratory.TESTS.values()] + [(laboratory.TESTS["J"], edge) for edge in draw.OTHER_EDGES]
        return [laboratory.specimen_config(BASE, t, "rich", block | {"edge_factor": edge}, specimen, hidden) for t, edge in cases]

    def test_every_effect_is_a_valid_run_in_every_test(self):
        hidden = [effects.Effects(((id, 1.0),), None, LIBRARY) for id in LIBRARY] + [effects.Effects((), name, LIBRARY) for name in effects.OUTSIDE]
        configs = [c for one in hidden for c in self.configs_of(one)]
        self.accepted(configs, "effects")
        kinds = [laboratory.TESTS[t].experiment for t in [*laboratory.TESTS, "J", "J"]]
        self.assertEqual(sum("mechanisms" in c for c in configs), sum(kind in acts for kind in kinds for acts in LIBRARY.values()))

    def test_the_middle_of_all_draws_is_the_base(self):
        block = {"parameters": {p["name"]: draw.base_value(BASE, p) for p in BASE["parameters"]}, "edge_factor": 1.0}
        specimen = {"seed": 1, "strength": 1.0, "stiffness": 1.0}
        for test in laboratory.TESTS.values():
            made = laboratory.specimen_config(BASE, test, "poor", block, specimen, effects.Effects())
            plain = laboratory.virtual_test(BASE, test, "poor")
            self.assertEqual(made, plain, test.id)

    def test_stiffness_of_contacts_follows_the_particles(self):
        block = {"parameters": {p["name"]: draw.base_value(BASE, p) for p in BASE["parameters"]}, "edge_factor": 1.0}
        block["parameters"]["E_p"] *= 1.05
        made = laboratory.specimen_config(BASE, laboratory.TESTS["U"], "rich", block, {"seed": 1, "strength": 1.0, "stiffness": 1.1}, effects.Effects())
        base = BASE["bases"]["uniaxial"]
        for part, key in (("particles", "youngs_modulus_gpa"), ("contacts", "tensile_stiffness_mpa_per_mm"), ("contacts", "shear_stiffness_mpa_per_mm")):
            self.assertAlmostEqual(made[part][key] / base[part][key], 1.05 * 1.1, 9)


class OutsideEffects(unittest.TestCase):
    TOUCHED = {"pore_pressure": {"T1", "T2", "T3"}, "weak_discs": {"B"}, "yielding_cell": {"U", "S", "T1", "T2", "T3"},
               "slipping_gauge": {"U", "S", "T1", "T2", "T3"}}

    def curve(self, test):
        peak = 2 * effects.CELL_LIMIT_N_PER_MM / effects.width_of(test) if test.experiment not in ("brazilian", "direct_shear") else 50.0
        base = test.keys.get("confining_pressure_mpa", 0.0)
        rise = [i / 100 for i in range(101)]
        curve = {"path": rise, "load": [base + peak * x for x in rise]}
        return curve | ({"lateral_strain": [0.3 * x for x in rise]} if "width_mm" in test.keys else {})

    def test_each_touches_its_tests_and_no_other(self):
        self.assertEqual(set(self.TOUCHED), set(effects.OUTSIDE))
        for name, touched in self.TOUCHED.items():
            hidden, found = effects.Effects((), name, LIBRARY), set()
            for test in laboratory.TESTS.values():
                config, curve = laboratory.virtual_test(BASE, test, "rich"), self.curve(test)
                before = copy.deepcopy((config, curve))
                hidden.apply(config)
                hidden.record(curve, test)
                if (config, curve) != before:
                    found.add(test.id)
            self.assertEqual(found, touched, name)

    def test_left_pore_pressure_keeps_the_total_stress_at_the_start(self):
        test = laboratory.TESTS["T1"]
        config = laboratory.virtual_test(BASE, test, "rich")
        effects.pore_pressure_config(config)
        curve = {"load": [config["experiment"]["confining_pressure_mpa"]]}
        effects.pore_pressure_curve(curve, test)
        self.assertAlmostEqual(curve["load"][0], test.keys["confining_pressure_mpa"], 12)


class Recording(unittest.TestCase):
    def assert_errors(self, noise):
        test, instrument = laboratory.TESTS["U"], recording.instrument_of(noise)
        path = [i / 4000 * 0.01 for i in range(4000)]
        line = {"path": path, "load": [1000 * p for p in path], "lateral_strain": list(path)}
        scales, zeros, rows = [], [], []
        for i in range(400):
            rng = draw.stream("errors", i)
            errors = recording.draw_test_errors(instrument, rng)
            scales.append(errors["load"] - 1)
            found = recording.recorded(line, test, instrument, errors, rng)
            shift = [1000 * p * errors["load"] / errors["path"] - load for p, load in zip(found["path"], found["load"])]
            zeros.append(statistics.fmean(shift))
            rows.append(statistics.pstdev(found["lateral_strain"][i] - p / errors["path"] for i, p in enumerate(found["path"])))
        tolerance = 0.11  # of a standard deviation from 400 draws: three times 1/sqrt(800)
        self.assertAlmostEqual(statistics.pstdev(scales) / (0.01 * noise), 1, delta=tolerance)
        expected = noise * math.hypot(0.02 / 100 * 1000, 0.002 * 10)  # the path's zero in MPa, and the load's
        self.assertAlmostEqual(statistics.pstdev(zeros) / expected, 1, delta=tolerance)
        self.assertAlmostEqual(statistics.fmean(rows) / (0.01 * noise * math.hypot(0.005, 0.001)), 1, delta=0.05)

    def test_errors_have_the_declared_sizes(self):
        for noise in (1.0, 4.0):
            with self.subTest(noise=noise):
                self.assert_errors(noise)

    def test_rows_below_half_the_confining_pressure_are_left_out_at_the_start_alone(self):
        curve = {"load": [0.1, 0.3, 0.6, 0.2, 0.9], "path": [0, 1, 2, 3, 4]}
        self.assertEqual(recording.without_a_false_start(curve, 1.0), {"load": [0.6, 0.2, 0.9], "path": [2, 3, 4]})
        self.assertEqual(recording.without_a_false_start(curve, None), curve)

    def test_a_worse_laboratory_states_its_errors_and_has_the_same_specimens(self):
        good, bad = (dataset.Plan("quick", 3, 1, 4, noise=noise) for noise in (1.0, 4.0))
        drawn = dataset.draw_set(good, effects.Effects(), "worse")
        self.assertEqual(dataset.needed_configs(BASE, good, drawn), dataset.needed_configs(BASE, bad, drawn))
        self.assertEqual(dataset.measured_json(good, drawn)["instrument"], recording.INSTRUMENT)
        self.assertEqual(dataset.measured_json(bad, drawn)["instrument"]["load_scale_percent"], 4 * recording.INSTRUMENT["load_scale_percent"])

    def test_rows_are_a_part_of_the_curve_of_varying_number_in_order(self):
        curve = {"path": list(range(500)), "load": list(range(500))}
        numbers = set()
        for i in range(20):
            kept = recording.thinned(curve, draw.stream("rows", i))
            numbers.add(len(kept["path"]))
            self.assertEqual(kept["path"], sorted(set(kept["path"])))
            self.assertEqual((kept["path"][0], kept["path"][-1], kept["path"]), (0, 499, kept["load"]))
        self.assertGreater(len(numbers), 10)

    def test_a_poor_laboratory_has_neither_gauge_nor_ear(self):
        self.assertNotIn("gauge", recording.kept_columns(laboratory.TESTS["U"], "poor"))
        self.assertNotIn("events", recording.kept_columns(laboratory.TESTS["B"], "poor"))
        self.assertIn("events", recording.kept_columns(laboratory.TESTS["B"], "rich"))


class Draws(unittest.TestCase):
    def test_seeds_lie_apart_from_those_of_a_confrontation(self):
        meshes = BASE["meshes"]
        own = meshes["first_seed"] + sum(v for k, v in meshes.items() if k != "first_seed")
        self.assertLess(own, 1_000_000)
        drawn = [draw.draw_specimen(draw.stream("seeds", i))["seed"] for i in range(2000)]
        self.assertGreaterEqual(min(drawn), 10_000_000)
        self.assertEqual(len(set(drawn)), len(drawn))

    def test_scatter_and_ranges_are_the_declared_ones(self):
        specimens = [draw.draw_specimen(draw.stream("scatter", i)) for i in range(2000)]
        for key, deviation in (("strength", draw.STRENGTH_SCATTER), ("stiffness", draw.STIFFNESS_SCATTER)):
            self.assertAlmostEqual(statistics.pstdev(math.log(s[key]) for s in specimens) / deviation, 1, delta=0.05)
        blocks = [draw.draw_block(BASE, draw.stream("blocks", i), True) for i in range(400)]
        for parameter in BASE["parameters"]:
            base, name = draw.base_value(BASE, parameter), parameter["name"]
            reach = {"tangent": draw.ANGLE_RANGE_DEG, "linear": draw.RATIO_RANGE}.get(parameter["transform"], draw.PARAMETER_RANGE * base)
            away = [(b["parameters"][name] - base) / reach for b in blocks]
            self.assertLessEqual(max(map(abs, away)), 1)
            self.assertGreater(max(away), 0.9)
            self.assertLess(min(away), -0.9)
            self.assertGreaterEqual(min(b["parameters"][name] for b in blocks), parameter["lower"])
        other = sum(b["edge_factor"] != 1 for b in blocks) / len(blocks)
        self.assertAlmostEqual(other, 0.25, delta=0.07)


if __name__ == "__main__":
    hidden_support.main()
