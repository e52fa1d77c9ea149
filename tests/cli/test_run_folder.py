"""What a run leaves behind: complete, readable by others, re-used, replaced or refused."""
import json
import re
import shutil
import subprocess
import sys

from vtkmodules.vtkIOImage import vtkPNGReader

import support
from support import SCRATCH, SOURCE, TINY, asperity, settings

FILES = [
    "config.original.json", "config.effective.json", "manifest.json", "log.txt", "summary.json",
    "curves.csv", "energy.csv", "cracks.csv", "events.csv", "fragments.csv", "fields.pvd", "cracks.pvd", "contacts.pvd",
]
PLOTS = [f"plots/{name}.{kind}" for name in ("stress_strain", "energy", "cracks") for kind in ("png", "svg")]
PLOTS += [f"plots/{name}.{kind}" for name in ("crack_rose", "magnitudes", "acoustic", "fragment_sizes") for kind in ("png", "svg", "csv")]
PLOTS += ["plots/strip.png", "report.html"]
TEST_COLUMNS = ["time_s", "axial_strain", "axial_stress_mpa", "reaction_bottom_n", "reaction_top_n", "external_work_n_mm"]


def picture(path):
    """Size in pixels, and whether anything is drawn at all."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    low, high = image.GetPointData().GetScalars().GetRange()
    return image.GetDimensions()[:2], high > low


class RunFolder(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        cls.folder = SCRATCH / "run"
        cls.result = asperity("run", TINY, "--out", cls.folder)
        assert cls.result.returncode == 0, cls.result.stderr

    def json_of(self, name):
        return json.loads((self.folder / name).read_text())

    def rows(self, name):
        head, *rows = (self.folder / name).read_text().splitlines()
        return head.split(","), rows

    def copy(self, name):
        return shutil.copytree(self.folder, SCRATCH / name)

    def frame_count(self):
        return len(list((self.folder / "fields").glob("fields_*.vtu")))

    def test_plots_tables_hold_what_the_runs_tables_hold(self):
        def column(name, key):
            head, rows = self.rows(name)
            return [float(row.split(",")[head.index(key)]) for row in rows]
        summary = self.json_of("summary.json")["cracks"]
        lengths = column("cracks.csv", "length_mm")
        rose = sum(column("plots/crack_rose.csv", "tension_length_mm")) + sum(column("plots/crack_rose.csv", "shear_length_mm"))
        self.assertAlmostEqual(rose, sum(lengths), places=9)
        events = column("events.csv", "energy_n_mm")
        self.assertEqual(sum(column("plots/magnitudes.csv", "events")), len(events))
        self.assertEqual(column("plots/magnitudes.csv", "events_of_at_least")[0], len(events))
        self.assertEqual(column("plots/acoustic.csv", "energy_n_mm"), events)
        strains = column("plots/acoustic.csv", "axial_strain")
        self.assertEqual(strains, sorted(strains))
        areas = column("fragments.csv", "area_mm2")
        self.assertEqual(len(areas), summary["fragments"])
        self.assertAlmostEqual(areas[0] / sum(areas), summary["largest_fragment_share"], places=12)
        self.assertIn(summary["fragment_d50_mm"], column("plots/fragment_sizes.csv", "size_mm"))

    def test_every_file_of_the_design_is_there_and_not_empty(self):
        frames = range(self.frame_count())
        numbered = [f"{s}/{s}_{i:06}.vtu" for s in ("fields", "cracks", "contacts") for i in frames]
        numbered += [f"frames/{field}_{i:06}.{kind}" for field in ("cracks", "damage") for i in frames for kind in ("png", "jpg")]
        for name in [*FILES, *PLOTS, *numbered]:
            self.assertGreater((self.folder / name).stat().st_size, 0, name)
        self.assertTrue((self.folder / "checkpoint").is_dir())
        self.assertEqual(list(self.folder.rglob("*.tmp")), [])

    def test_nothing_else_is_there(self):
        known = re.compile(r"\.asperity\.lock|report\.html|(fields|cracks|contacts|frames|plots|checkpoint)(/[a-z_]+(_\d{6})?\.(vtu|png|jpg|svg|csv))?")
        for name in support.listing(self.folder):
            self.assertTrue(name in FILES or known.fullmatch(name), name)

    def test_stdout_is_results_with_the_folder_last(self):
        lines = self.result.stdout.splitlines()
        self.assertEqual(lines[-1], str(self.folder))
        for line in lines[:-1]:
            self.assertRegex(line, r"^[a-z_]+ \S+$")

    def test_progress_goes_to_stderr_every_5_percent(self):
        percents = [int(p) for p in re.findall(r"(?m)^brazilian +(\d+) %  strain ", self.result.stderr)]
        self.assertEqual(percents[0], 0)
        self.assertEqual(percents[-1], 100)
        self.assertEqual(percents, sorted(set(percents)))
        self.assertLessEqual(len(percents), 22)  # 0 to 100 in fives, and an end that may fall between
        self.assertGreaterEqual(len(percents), 15)  # 200 samples make steps of half a percent: hardly one of 21 is skipped
        self.assertRegex(self.result.stderr, r"steps/s")
        self.assertRegex(self.result.stderr, r"ETA")

    def test_summary(self):
        summary = self.json_of("summary.json")
        self.assertLessEqual({"experiment", "results", "energy", "cracks", "cost", "warnings"}, summary.keys())
        stresses = [float(row.split(",")[self.rows("curves.csv")[0].index("axial_stress_mpa")]) for row in self.rows("curves.csv")[1]]
        self.assertAlmostEqual(summary["results"]["tensile_strength_mpa"], max(stresses), places=9)  # CSV keeps 15 digits or more
        # The bar of the issue for shipped runs; here it takes the place of a measured figure for a mesh that is coarser.
        self.assertLess(summary["energy"]["relative_closure_error"], 1e-3)
        self.assertLessEqual({"steps", "compute_s", "output_s"}, summary["cost"].keys())
        self.assertGreater(summary["cracks"]["tension"] + summary["cracks"]["shear"], 0)

    def test_cracks_table_agrees_with_summary_and_curve(self):
        head, rows = self.rows("cracks.csv")
        modes = [row.split(",")[head.index("mode")] for row in rows]
        cracks = self.json_of("summary.json")["cracks"]
        self.assertEqual((modes.count("tension"), modes.count("shear")), (cracks["tension"], cracks["shear"]))
        times = [float(row.split(",")[head.index("time_s")]) for row in rows]
        self.assertEqual(times, sorted(times))

    def test_tables_have_their_columns_and_only_finite_numbers(self):
        head, rows = self.rows("curves.csv")
        self.assertLessEqual(set(TEST_COLUMNS), set(head))
        for row in rows:
            self.assertNotRegex(row, r"nan|inf")
            self.assertEqual(len(row.split(",")), len(head))

    def test_manifest(self):
        manifest = self.json_of("manifest.json")
        self.assertEqual(manifest["outcome"], "finished")
        wanted = {"revision", "dirty", "compiler", "flags", "libraries", "threads", "seed", "config_hash", "timings", "warnings", "mesh"}
        self.assertLessEqual(wanted, manifest.keys())
        self.assertEqual(manifest["warnings"], self.json_of("summary.json")["warnings"])

    def test_configs_kept(self):
        self.assertEqual((self.folder / "config.original.json").read_bytes(), TINY.read_bytes())
        self.assertEqual(self.json_of("config.effective.json")["particles"]["edge_mm"], 5)
        self.succeed("validate", self.folder / "config.effective.json")

    def test_vtu_series_by_an_independent_reader(self):
        checker = SOURCE / "tests/render/check_series.py"
        result = subprocess.run([sys.executable, "-B", checker, self.folder], capture_output=True, text=True, timeout=support.SECONDS)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_frames_have_the_size_asked_for_and_a_drawing(self):
        for path in (self.folder / "frames").glob("*.png"):
            self.assertEqual(picture(path), ((400, 300), True), path)

    def test_quiet_says_nothing_on_stderr_and_no_render_draws_nothing(self):
        quick = settings(experiment__stop__axial_strain=0.002)
        result = self.succeed("run", TINY, *quick, "--quiet", "--no-render", "--out", SCRATCH / "quiet")
        self.assertEqual(result.stderr, "")
        self.assertEqual(list((SCRATCH / "quiet/frames").iterdir()), [])
        self.assertTrue(list((SCRATCH / "quiet/fields").glob("*.vtu")))

    def test_finished_run_is_reused(self):
        before = support.listing(self.folder)
        result = self.succeed("run", TINY, "--out", self.folder)
        self.assertEqual(result.stdout, self.result.stdout)
        self.assertIn("--force", result.stderr)
        self.assertEqual(support.listing(self.folder), before)

    def test_resume_of_a_finished_run_changes_no_file(self):
        before = support.listing(self.folder)
        self.assertEqual(self.succeed("resume", self.folder).stdout, self.result.stdout)
        after = support.listing(self.folder)
        before.pop(".asperity.lock"), after.pop(".asperity.lock")  # it names the process that came last
        self.assertEqual(after, before)

    def test_force_runs_again_to_the_same_bytes(self):
        forced = self.copy("forced")
        before = (forced / "curves.csv").stat()
        self.succeed("run", TINY, "--out", forced, "--force", "--no-render", "--quiet")
        after = (forced / "curves.csv").stat()
        self.assertNotEqual((after.st_mtime_ns, after.st_ino), (before.st_mtime_ns, before.st_ino))
        self.assert_same_bytes(forced, self.folder, ["curves.csv", "energy.csv", "cracks.csv", "events.csv"])

    def test_another_config_in_a_used_folder_is_refused(self):
        before = support.listing(self.folder)
        text = self.fail_with(5, "run", TINY, *settings(particles__seed=2), "--out", self.folder)
        self.assertIn(f"{self.folder}: holds a run of another configuration", text)
        self.assertIn("--force", text)
        self.assertEqual(support.listing(self.folder), before)

    def test_a_folder_with_strangers_files_is_refused_even_with_force(self):
        folder = SCRATCH / "strangers"
        folder.mkdir()
        (folder / "thesis.tex").write_text("do not lose me")
        text = self.fail_with(5, "run", TINY, "--out", folder, "--force")
        self.assertIn(f"{folder}: holds files that are no run of Asperity", text)
        self.assertEqual(list(support.listing(folder)), ["thesis.tex"])

    def test_out_below_a_file_cannot_be_created(self):
        text = self.fail_with(5, "run", TINY, "--out", TINY / "below")
        self.assertIn(f"{TINY}/below: cannot be created: Not a directory", text)

    def test_resume_and_render_need_a_run_folder(self):
        for command in ("resume", "render"):
            self.assertIn("no_folder: is no run folder of Asperity", self.fail_with(5, command, "no_folder"))

    def test_render_draws_another_field_from_the_vtu_files_alone(self):
        folder = self.copy("drawn_again")
        for path in [*(folder / "frames").iterdir(), *folder.glob("*.csv")]:
            path.unlink()
        result = self.succeed("render", folder, "--field", "displacement", "--field", "stress", "--frames", "last")
        last = self.frame_count() - 1
        self.assertEqual(result.stdout.splitlines()[-1], str(folder / "frames"))
        self.assertEqual({p.name for p in (folder / "frames").iterdir()},
                         {f"{field}_{last:06}.{kind}" for field in ("displacement", "stress") for kind in ("png", "jpg")})
        drawn = sorted((folder / "frames").glob("*.png"))
        for path in drawn:
            self.assertEqual(picture(path), ((400, 300), True), path)

    def test_render_gives_the_same_picture_as_the_run(self):
        folder = self.copy("drawn_same")
        (folder / "frames/damage_000001.png").unlink()
        self.succeed("render", folder, "--field", "damage", "--frames", "1")
        self.assert_same_bytes(folder, self.folder, ["frames/damage_000001.png", "frames/damage_000001.jpg"])

    def test_render_refuses_what_it_cannot_draw(self):
        text = self.fail_with(2, "render", self.folder, "--field", "happiness")
        self.assertIn("happiness", text)
        self.assertIn("displacement", text)
        self.assertIn("99", self.fail_with(2, "render", self.folder, "--frames", "99"))


if __name__ == "__main__":
    support.main()
