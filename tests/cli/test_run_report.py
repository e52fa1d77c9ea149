"""The page of a run: written with it and by `asperity report`, from the folder's files alone; measured curves in plots and page."""
import json
import shutil
import subprocess
import sys

import support
from report_page import Page, check_self_contained
from support import SCRATCH, SOURCE, TINY, asperity, settings

JOINT = TINY.with_name("tiny_joint.json")
DISC_SECTIONS = ["Results", "Pictures", "Curves", "Failure mode", "Cracks", "Energy", "Acoustic events", "Cost", "Provenance"]
JOINT_SECTIONS = ["Results", "Pictures", "Curves", "Teeth", "Closed forms beside the simulation", "Cracks", "Energy", "Acoustic events",
                  "Cost", "Provenance"]
FORMS = ["sliding up the flanks", "sheared through at the base", "transition, normal stress", "teeth one after the other", "all teeth at once",
         "Ladanyi & Archambault", "residual, joint's friction", "residual, rock's friction"]


class RunReport(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        """One run of each kind serves all tests; copies are changed."""
        cls.disc, cls.joint = SCRATCH / "disc", SCRATCH / "joint"
        for config, folder in ((TINY, cls.disc), (JOINT, cls.joint)):
            result = asperity("run", config, "--out", folder)
            assert result.returncode == 0, result.stderr

    def page(self, folder):
        text = (folder / "report.html").read_text(encoding="utf-8")
        page = Page(text)
        check_self_contained(self, folder, text, page)
        return page

    def copy(self, folder, name):
        return shutil.copytree(folder, SCRATCH / name)

    def summary(self, folder):
        return json.loads((folder / "summary.json").read_text())

    def test_a_run_ends_with_its_page(self):
        page = self.page(self.disc)
        self.assertEqual(page.sections(), DISC_SECTIONS)
        for words in ("Run tiny_disc", "Brazilian disc", "tensile strength", "The account is open by", "seed 1", "Verdict:"):
            self.assertIn(words, page.words)
        manifest = json.loads((self.disc / "manifest.json").read_text())
        self.assertIn(manifest["config_hash"], page.words)
        self.assertIn(manifest["ended_utc"], page.words)

    def test_a_run_with_mechanisms_says_so_before_anything_else(self):
        folder = SCRATCH / "mechanisms"
        settings_text = '/mechanisms=[{"type":"platen_friction","amplitude":0.5},{"type":"damping","amplitude":0}]'
        self.succeed("run", TINY, "--set", settings_text, "--out", folder, "--no-render")
        self.succeed("report", folder)
        words = self.page(folder).words
        self.assertIn("Not the base model: this run has platen_friction (friction_coefficient 0.15).", words)
        self.assertNotIn("damping_change", words)  # it is off
        self.assertEqual(self.summary(folder)["experiment"]["mechanisms"], [{"type": "platen_friction", "friction_coefficient": 0.15}])
        self.assertNotIn("Not the base model", self.page(self.disc).words)
        self.assertNotIn("mechanisms", self.summary(self.disc)["experiment"])

    def test_pictures_have_a_slider_that_knows_every_frame(self):
        page = self.page(self.joint)
        data = json.loads(page.viewer)
        frames = len(list((self.joint / "fields").glob("*.vtu")))
        self.assertEqual([kind["name"] for kind in data["kinds"]], ["cracks", "fragments"])
        for kind in data["kinds"]:
            self.assertEqual(len(kind["sources"]), frames)
            for source, original in zip(kind["sources"], kind["originals"]):
                self.assertEqual((source[-4:], original), (".jpg", source[:-4] + ".png"))
                self.assertLess((self.joint / source).stat().st_size, (self.joint / original).stat().st_size)
        places = [frame["x"] for frame in data["frames"]]
        self.assertEqual(places, sorted(places))
        self.assertIn("shear displacement 0.000 mm", data["frames"][0]["text"])
        kinds = [c.get("type") for c in page.controls]
        self.assertEqual((kinds.count("radio"), kinds.count("range")), (2, 1))
        slider = next(c for c in page.controls if c["type"] == "range")
        self.assertEqual((slider["min"], slider["max"]), ("0", str(frames - 1)))
        for control in page.controls:
            self.assertTrue(control["type"] == "radio" or "aria-label" in control or "data-play" in control, control)

    def test_a_joint_has_its_teeth_and_closed_forms(self):
        page = self.page(self.joint)
        self.assertEqual(page.sections(), JOINT_SECTIONS)
        for form in FORMS:
            self.assertIn(form, page.words)
        failure = self.summary(self.joint)["failure_mode"]
        self.assertEqual(len(failure["teeth"]), 2)
        verdict = {"together": "The teeth failed together", "one_after_the_other": "The teeth failed one after the other",
                   "some": "Only some teeth were sheared off", "none": "No tooth was sheared off"}[failure["teeth_failed"]]
        for words in (verdict, "the upper half had risen by", "cannot rotate", "C = 1.00 MPa"):
            self.assertIn(words, page.words)
        sliding = failure["closed_forms"]["sliding"]
        self.assertIn(f"{sliding['simulated_over_it']:.3f}", page.words)
        shown = [image["src"] for image in page.images]
        for plot in ("strip", "shear_stress", "dilation", "teeth", "cracks", "energy"):
            self.assertIn(f"plots/{plot}.png", shown)

    def test_what_the_cracks_tell_is_on_the_page(self):
        page = self.page(self.disc)
        shown = [image["src"] for image in page.images]
        for plot in ("crack_rose", "fragment_sizes", "acoustic", "magnitudes"):
            self.assertIn(f"plots/{plot}.png", shown)
        cracks = self.summary(self.disc)["cracks"]
        self.assertEqual(cracks["acoustic_events"], len((self.disc / "events.csv").read_text().splitlines()) - 1)
        self.assertIn("fragment d50", page.words)

    def test_a_joints_series_by_an_independent_reader(self):
        checker = SOURCE / "tests/render/check_series.py"
        result = subprocess.run([sys.executable, "-B", checker, self.joint], capture_output=True, text=True, timeout=support.SECONDS)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_a_joint_stops_at_its_shear_displacement(self):
        self.assertEqual(self.summary(self.joint)["experiment"]["stopped"], "reached the stop shear displacement")

    def test_warnings_stand_first(self):
        folder = self.copy(self.disc, "warned")
        summary = self.summary(folder)
        summary["warnings"] = ["<b>mind this</b>"]
        (folder / "summary.json").write_text(json.dumps(summary))
        self.succeed("report", folder)
        text = (folder / "report.html").read_text()
        self.assertLess(text.index("&lt;b&gt;mind this"), text.index("<nav"))

    def test_the_page_is_made_of_the_folder_alone_and_moves_with_it(self):
        folder = self.copy(self.joint, "moved elsewhere")
        (folder / "report.html").unlink()
        shutil.rmtree(folder / "plots")
        (folder / "plots").mkdir()
        result = self.succeed("report", folder)
        self.assertEqual(result.stdout, f"{folder}/report.html\n")
        self.assertEqual(self.page(folder).words, self.page(self.joint).words)
        names = [p.relative_to(folder) for p in (folder / "plots").iterdir()]
        self.assertIn("strip.png", [name.name for name in names])
        self.assert_same_bytes(folder, self.joint, names)

    def test_a_run_without_pictures_gets_them_with_its_page_when_asked_again(self):
        folder = SCRATCH / "bare"
        self.succeed("run", TINY, "--out", folder, "--no-render")
        self.assertFalse((folder / "report.html").exists())
        self.succeed("report", folder)
        self.assertIn("No pictures of frames were drawn", self.page(folder).words)
        (folder / "report.html").unlink()
        self.succeed("run", TINY, "--out", folder)
        self.assertIsNotNone(self.page(folder).viewer)

    def test_a_run_that_did_not_end_has_a_page_that_says_so(self):
        folder = self.copy(self.disc, "unfinished")
        (folder / "summary.json").unlink()
        manifest = json.loads((folder / "manifest.json").read_text())
        manifest.update(outcome="failed", exit_reason="a particle has turned over")
        (folder / "manifest.json").write_text(json.dumps(manifest))
        self.succeed("report", folder)
        page = self.page(folder)
        self.assertIn("not finished (failed): a particle has turned over", page.words)
        self.assertNotIn("Failure mode", page.sections())

    def test_a_measured_curve_is_in_plots_page_and_folder(self):
        self.assertEqual((self.joint / "measured.csv").read_bytes(), JOINT.with_name("tiny_joint_measured.csv").read_bytes())
        effective = json.loads((self.joint / "config.effective.json").read_text())["output"]
        self.assertEqual((effective["measured_curve"], effective["measured_name"]), ("measured.csv", "laboratory"))
        for plot, labels in (("shear_stress", ("laboratory, P1: shear stress", "laboratory, P2: shear stress", "laboratory, P1: dilation")),
                             ("dilation", ("laboratory, P1",))):
            svg = (self.joint / "plots" / f"{plot}.svg").read_text()
            for label in labels:
                self.assertIn(f"{label}</text>", svg)
            self.assertNotIn("P2: dilation", svg)
        self.assertIn("Points are measured: laboratory, P1; laboratory, P2.", self.page(self.joint).words)

    def test_a_measured_curve_can_be_added_to_a_finished_run(self):
        folder, lab = self.copy(self.disc, "later"), SCRATCH / "disc_lab.csv"
        lab.write_text("platen_displacement_mm,load_n_per_mm\n0.1,50\n0.3,120\n")
        before = (folder / "curves.csv").stat().st_mtime_ns
        result = self.succeed("run", TINY, "--out", folder, *settings(output__measured_curve=lab))
        self.assertIn("already there", result.stderr)
        self.assertEqual((folder / "curves.csv").stat().st_mtime_ns, before)
        self.assertIn("disc_lab</text>", (folder / "plots" / "stress_strain.svg").read_text())
        self.assertIn("Points are measured: disc_lab.", self.page(folder).words)
        self.succeed("run", TINY, "--out", folder)
        self.assertNotIn("disc_lab", (folder / "plots" / "stress_strain.svg").read_text())
        self.assertFalse((folder / "measured.csv").exists())

    def test_a_measured_curve_that_cannot_be_read_is_one_clear_error_before_anything_is_written(self):
        wrong = SCRATCH / "wrong.csv"
        wrong.write_text("shear_displacement_mm,tau\n0,1\n")
        folder = SCRATCH / "refused"
        for command in (("run", "--out", folder), ("validate",)):
            name, *options = command
            error = self.fail_with(3, name, JOINT, *options, *settings(output__measured_curve=wrong))
            self.assertIn("wrong.csv", error)
            self.assertIn('no column "shear_stress_mpa"', error)
            error = self.fail_with(3, name, JOINT, *options, *settings(output__measured_curve="nowhere.csv"))
            self.assertIn("/output/measured_curve: no such file", error)
        self.assertFalse(folder.exists())


if __name__ == "__main__":
    support.main()
