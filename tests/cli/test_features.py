"""Measured data and runs through `features`; the features of a simulated run are the results of its summary.json."""
import json
import math
import re

import support
from support import SCRATCH, SOURCE, TINY, asperity, settings

MEASURED = SOURCE / "configs/measured"
GOOD = "specimen,axial_strain_percent,axial_stress_kpa\n" + "".join(
    f"A,{0.1 * i:g},{1000 * (i if i <= 10 else 20 - i):g}\n" for i in range(17))
# Sums of some hundred terms: what is left where the confining pressure is taken off first.
ROUNDING = 1e-12
# Small, fast variants of the four experiments: coarse, quickly loaded, sheared to 2 mm.
RUNS = {
    "uniaxial": (SOURCE / "configs/paper/uniaxial.json", settings(particles__edge_mm=9, experiment__loading__closing_rate_mm_per_s=800)),
    "triaxial": (SOURCE / "configs/paper/triaxial_1.0.json", settings(particles__edge_mm=9, experiment__loading__closing_rate_mm_per_s=800)),
    "disc": (TINY, []),
    "joint": (SOURCE / "configs/joint/single_1.47.json",
              settings(particles__edge_mm=1.3, joint__damage_depth_lower_mm=2, joint__damage_depth_upper_mm=2,
                       experiment__stop__shear_displacement_mm=2, experiment__loading__shear_rate_mm_per_s=400)),
}


def write(name, text):
    path = SCRATCH / name
    path.write_text(text)
    return path


def measured(curve="good.csv", **keys):
    return json.dumps({"tests": [{"id": "U", "experiment": "uniaxial", "curve": curve, **keys}]})


class Features(support.CommandLineTest):
    def features(self, source):
        return json.loads(self.succeed("features", source, "--json").stdout)["tests"]

    def test_a_runs_features_are_its_summarys_results(self):
        for name, (config, options) in RUNS.items():
            with self.subTest(run=name):
                out = SCRATCH / name
                self.succeed("run", config, *options, "--no-render", "--quiet", "--out", out)
                results = json.loads((out / "summary.json").read_text())["results"]
                features = self.features(out)[0]["features"]
                common = results.keys() & features.keys()
                self.assertGreaterEqual(len(common), 3, common)
                compared = 0
                for key in common:
                    value = features[key]["mean"]
                    if value is None:  # absent with a reason, never another value
                        self.assertTrue(features[key]["specimens"][0]["absent"])
                        continue
                    compared += 1
                    self.assertTrue(math.isclose(value, results[key], rel_tol=ROUNDING, abs_tol=0), (key, value, results[key]))
                self.assertGreaterEqual(compared, 3, features)

    def test_measured_strengths(self):
        tests = {t["id"]: t for t in self.features(MEASURED / "zigong_sandstone.json")}
        peak = tests["U"]["features"]["peak_axial_stress_mpa"]
        self.assertEqual(peak["count"], 5)
        self.assertAlmostEqual(peak["mean"], 108.2)
        self.assertEqual(peak["unit"], "MPa")
        self.assertEqual(tests["U"]["instrument"]["load_noise_percent"], 0.5)
        text = self.succeed("features", MEASURED / "zigong_sandstone.json").stdout
        self.assertRegex(text, r"(?m)^U \(uniaxial, 5 specimens\)\n  peak_axial_stress_mpa +108\.2 \+- 5\.8 MPa \(n 5\)  \(F4\)$")

    def test_a_curve_in_other_units(self):
        write("good.csv", GOOD)
        features = self.features(write("good.json", measured()))[0]["features"]
        self.assertAlmostEqual(features["peak_axial_stress_mpa"]["mean"], 10.0)
        self.assertAlmostEqual(features["axial_modulus_gpa"]["mean"], 1.0)
        absent = features["youngs_modulus_gpa"]["specimens"][0]
        self.assertIsNone(absent["value"])
        self.assertIn("no gauge", absent["absent"])

    def test_validate_knows_a_measured_file_with_and_without_its_schema(self):
        write("good.csv", GOOD)
        path = write("plain.json", measured())
        self.assertIn(f"{path}: valid (1 measured tests, 1 specimens)", self.succeed("validate", path).stdout)
        with_schema = json.loads(measured())
        with_schema["$schema"] = "../measured.schema.json"
        self.succeed("validate", write("schema.json", json.dumps(with_schema)))

    def test_faults_at_once_with_their_places(self):
        write("bad.csv", "specimen,axial_strain,axial_stress_tons\nA,0,0\n")
        path = write("bad.json", measured("bad.csv", diametre_mm=3))
        for command in ("validate", "features"):
            self.assertIn("/tests/0/diametre_mm: is not a key", self.fail_with(3, command, path))
        path = write("bad.json", measured("bad.csv", diameter_mm=3, scatter="specimens"))
        text = self.fail_with(3, "features", path)
        self.assertIn("error: /tests/0/diameter_mm: has no meaning", text)
        self.assertRegex(text, r"error: \S+bad\.csv: the unit of a column is not known \(found axial_stress_tons; allowed: axial_stress_mpa, ")
        self.assertIn("error: /tests/0/scatter: asks for the scatter of specimens, and there is one", text)

    def test_a_fault_of_a_row_names_its_line(self):
        write("back.csv", GOOD + "A,0.2,100\n")
        text = self.fail_with(3, "validate", write("back.json", measured("back.csv")))
        self.assertRegex(text, r"back\.csv:19: the displacement goes backwards without a reload .*Hint: ")

    def test_neither_file_nor_folder(self):
        self.assertIn("nowhere.json: cannot be read", self.fail_with(3, "features", SCRATCH / "nowhere.json"))
        (SCRATCH / "empty").mkdir(exist_ok=True)
        self.assertIn("is no run folder", self.fail_with(3, "features", SCRATCH / "empty"))

    def test_overrides_do_not_apply(self):
        self.assertIn("measured data", self.fail_with(2, "validate", MEASURED / "plaster.json", "--set", "/name=x"))

    def test_the_pages_example_is_one(self):
        page = (SOURCE / "docs/measured_data.md").read_text()
        blocks = dict(re.findall(r"(?ms)^```(json|csv)\n(.*?)^```", page))
        write("T1.csv", blocks["csv"])
        features = {t["id"]: t["features"] for t in self.features(write("sandstone.json", blocks["json"]))}
        self.assertEqual(features["T1"]["peak_axial_stress_mpa"]["mean"], 10.3)
        self.assertAlmostEqual(features["J1"]["peak_shear_stress_mpa"]["mean"], 1.79)

    def test_the_page_names_every_feature_key_and_unit(self):
        page = (SOURCE / "docs/measured_data.md").read_text()
        schema = json.loads((SOURCE / "configs/schema/measured.schema.json").read_text())["properties"]
        tests = schema["tests"]["items"]["properties"]
        names = {*schema, *tests, *schema["instrument"]["properties"]} - {"$schema"}
        for experiment in tests["experiment"]["enum"]:
            keys = {"triaxial": {"confining_pressure_mpa": 1}, "direct_shear": {"normal_stress_mpa": 1}}.get(experiment, {})
            test = {"id": "X", "experiment": experiment, "results": {"loop_count": 0}, **keys}
            names |= self.features(write("names.json", json.dumps({"tests": [test]})))[0]["features"].keys()
        for name in names:
            self.assertIn(f"`{name}`", page)

    def test_schema(self):
        schema = json.loads(self.succeed("schema", "measured").stdout)
        self.assertEqual(schema["$schema"], "http://json-schema.org/draft-07/schema#")
        self.assertEqual(schema, json.loads((SOURCE / "configs/schema/measured.schema.json").read_text()))


if __name__ == "__main__":
    support.main()
