"""`asperity report`: the page of a calibration, its pictures and what it needs (nothing). The two calibration.json under
fixtures/calibration_report are made by the script beside them; no number of theirs was computed by a simulation."""
import json
import pathlib
import shutil
import xml.etree.ElementTree as ElementTree

import support
from report_page import Page, check_self_contained
from support import SCRATCH

FIXTURES = pathlib.Path(__file__).resolve().parent / "fixtures" / "calibration_report"
SECTIONS = ["Outcome", "Parameters", "Elastic compensation", "Trade-off", "Failure mode", "Design and runs", "Models and analysis of variance",
            "Response surfaces", "Effects and interactions", "Predicted against simulated", "Desirability and solutions",
            "Rounds of the moving design", "The two routes", "Cost", "Definitions", "Provenance"]
PROPERTIES = ["youngs_modulus_gpa", "poissons_ratio", "tensile_strength_mpa", "uniaxial_strength_mpa", "cohesion_mpa", "friction_angle_deg"]
ONE_PIXEL = bytes.fromhex("89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de0000000c4944415408d763f8ffff3f0005fe02fe"
                          "dccc59e70000000049454e44ae426082")


def folder_of(kind, name):
    folder = SCRATCH / name
    shutil.copytree(FIXTURES / kind, folder)
    return folder


def written(folder, change):
    """The folder with its calibration.json changed in place."""
    document = json.loads((folder / "calibration.json").read_text())
    change(document)
    (folder / "calibration.json").write_text(json.dumps(document))
    return folder


class Report(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        """One report of everything serves several tests: drawing its 22 plots is what takes time here."""
        cls.whole = folder_of("simulated", "whole")
        (cls.whole / "pictures").mkdir()
        (cls.whole / "pictures" / "brazilian cracks.png").write_bytes(ONE_PIXEL)
        (cls.whole / "manifest.json").write_text('{"program": "asperity", "version": "0.1.0", "libraries": {"VTK": "9.1.0"}}')
        written(cls.whole, lambda d: d["warnings"].append("<b>k_s & k_t</b>"))
        cls.result = support.asperity("report", cls.whole)

    def report(self, folder):
        return self.checked(folder, self.succeed("report", folder))

    def checked(self, folder, result):
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, f"{folder}/report.html\n")
        text = (folder / "report.html").read_text(encoding="utf-8")
        page = Page(text)
        self.assertNotIn("<script", text)
        check_self_contained(self, folder, text, page)
        return page

    def test_a_simulated_calibration_has_every_section_and_plot(self):
        folder, page = self.whole, self.checked(self.whole, self.result)
        self.assertEqual(page.sections(), SECTIONS)
        plots = ["verification", "trade_off", "main_effects", "interactions", "predicted_against_simulated", "desirability_map", "targets_map"]
        plots += [f"{kind}_{name}" for kind in ("residuals", "response_surface") for name in PROPERTIES]
        self.assertEqual(sorted(p.name for p in (folder / "plots").iterdir()), sorted(f"{p}.{e}" for p in plots for e in ("png", "svg")))
        shown = {image["src"] for image in page.images}
        self.assertEqual(shown, {f"plots/{p}.png" for p in plots} | {"pictures/brazilian%20cracks.png"})
        for words in ("−17.1", "run 9", "no peak up to 4.5", "Eqs 12, 13 alone", "VTK 9.1.0", "no: its interval reaches beyond the design",
                      "Eliminated, in this order", "lack of fit", "17.4 min (1043 s)", "1.327 ± 0.022 MPa"):
            self.assertIn(words.lower(), page.words.lower())

    def test_warnings_stand_before_everything_else(self):
        text = (self.whole / "report.html").read_text()
        self.assertLess(text.index("&lt;b&gt;k<sub>s</sub> &amp; k<sub>t</sub>"), text.index("<nav"))
        self.assertNotIn("<b>", text)

    def test_texts_of_the_svg_are_inside_their_pictures(self):
        for path in (self.whole / "plots").glob("*.svg"):
            root = ElementTree.parse(path).getroot()
            width, height = float(root.get("width")), float(root.get("height"))
            texts = [t for t in root.iter() if t.tag.endswith("}text")]
            self.assertGreater(len(texts), 8, path.name)
            for t in texts:
                self.assertTrue(0 < float(t.get("x")) < width and 0 < float(t.get("y")) < height, (path.name, t.text))
                self.assertGreaterEqual(float(t.get("font-size")), 20, (path.name, t.text))

    def test_given_data_have_no_verification_and_link_their_audit(self):
        folder = folder_of("data", "data")
        (folder / "audit.md").write_text("# Audit\n")
        page = self.report(folder)
        self.assertIn("audit.md", page.links)
        self.assertIn("nothing was simulated, so nothing is verified", page.words)
        self.assertIn("The overall desirability is 0 everywhere", page.words)
        for absent in ("Parameters", "Elastic compensation", "Trade-off", "Failure mode", "The two routes"):
            self.assertNotIn(absent, page.sections())
        self.assertFalse((folder / "plots" / "verification.png").exists())
        self.assertTrue((folder / "plots" / "response_surface_cohesion_mpa.png").exists())

    def test_every_key_may_be_missing_or_null(self):
        """Figures of models are drawn only where a key matters to them, and then of one model: they take the time."""
        whole = json.loads((FIXTURES / "simulated" / "calibration.json").read_text())
        one_model = {**whole, "models": {"cohesion_mpa": whole["models"]["cohesion_mpa"]}}
        folder = folder_of("simulated", "missing")
        for number, key in enumerate(whole):
            document = dict(one_model if key in ("design", "responses", "solutions", "targets") else {**whole, "models": {}})
            document[key] = None
            if number % 2:
                del document[key]
            (folder / "calibration.json").write_text(json.dumps(document))
            with self.subTest(key=key):
                self.report(folder)
        (folder / "calibration.json").write_text("{}")
        self.report(folder)

    def test_the_same_calibration_gives_the_same_bytes(self):
        one, other = (folder_of("data", name) for name in ("once", "twice"))
        self.report(one)
        self.report(other)
        names = sorted(p.relative_to(one) for p in one.rglob("*") if p.is_file())
        self.assertGreater(len(names), 10)
        self.assert_same_bytes(one, other, names)

    def test_what_is_no_calibration_is_one_clear_error(self):
        empty = SCRATCH / "empty"
        empty.mkdir()
        self.assertIn("holds neither calibration.json, verdict.json nor a run", self.fail_with(3, "report", empty))
        self.assertIn("is no folder", self.fail_with(3, "report", SCRATCH / "nowhere"))
        self.fail_with(2, "report")

    def test_a_damaged_document_names_the_place(self):
        folder = folder_of("data", "damaged")
        for text, words in (("{", "is no JSON"), ("[]", "is no JSON object"), ('{"warnings": 3}', "/warnings"),
                            ('{"design": {"factors": [{"name": 1}]}}', "/design/factors/0/name")):
            (folder / "calibration.json").write_text(text)
            with self.subTest(text=text):
                self.assertIn(words, self.fail_with(3, "report", folder))
        written_folder = written(folder_of("data", "wrong_term"), lambda d: d["models"]["cohesion_mpa"]["reduced"].update({"x9": 1}))
        self.assertIn("x9", self.fail_with(3, "report", written_folder))


if __name__ == "__main__":
    support.main()
