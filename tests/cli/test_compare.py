"""Comparisons of runs, montages, and the index of a folder of runs: pictures, tables, pages and refusals."""
import csv
import json
import shutil

import support
from report_page import Page
from support import SCRATCH, TINY, asperity, settings

try:
    from vtkmodules.vtkIOImage import vtkPNGReader
    from vtkmodules.util.numpy_support import vtk_to_numpy
except ImportError:  # python3-vtk9
    vtkPNGReader = None

JOINT = TINY.with_name("tiny_joint.json")


def colours(png):
    """Number of different colours of a picture, and its size."""
    reader = vtkPNGReader()
    reader.SetFileName(str(png))
    reader.Update()
    image = reader.GetOutput()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return len({tuple(p) for p in pixels.tolist()}), image.GetDimensions()[:2]


class Compare(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        """Two seeds, one law changed on the first one's mesh, and a joint."""
        cls.runs = SCRATCH / "runs"
        cls.one, cls.two, cls.weak, cls.joint = (cls.runs / name for name in ("one", "two", "weak", "joint"))
        for config, folder, changes in ((TINY, cls.one, {}), (TINY, cls.two, {"particles__seed": 2}),
                                        (TINY, cls.weak, {"contacts__cohesion_mpa": 1.2}), (JOINT, cls.joint, {})):
            draw = () if folder in (cls.one, cls.joint) else ("--no-render",)
            result = asperity("run", config, *settings(**changes), "--out", folder, *draw)
            assert result.returncode == 0, result.stderr

    def rows(self, path):
        with path.open(encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def page(self, path):
        text = path.read_text(encoding="utf-8")
        page = Page(text)
        self.assertEqual(page.open, [])
        for word in ("http:", "https:", "<script src", "javascript:", "@import", "url("):
            self.assertNotIn(word, text)
        for image in page.images:
            self.assertGreater(len(image["alt"]), 20)
        for link in page.links:
            if link.startswith("#"):
                self.assertIn(f'id="{link[1:]}"', text)
            else:
                self.assertTrue((path.parent / link.replace("%20", " ")).exists(), link)
        return page

    def test_two_seeds_side_by_side(self):
        png = SCRATCH / "seeds" / "x.png"
        result = self.succeed("compare", self.one, self.two, "--out", png)
        self.assertEqual(result.stdout.splitlines()[-1], str(png))
        self.assertIn("| differs by | | seed 1 | seed 2 |", result.stdout)
        self.assertEqual(sorted(p.name for p in png.parent.iterdir()),
                         ["x.csv", "x.html", "x.md", "x.png", "x_curves.png", "x_orientation.csv"])
        if vtkPNGReader:
            count, size = colours(png)
            self.assertGreater(count, 60)
            self.assertGreater(size[0], 1000)
        first, second = self.rows(png.with_suffix(".csv"))
        self.assertEqual((first["run"], second["run"], second["differs_by"]), ("A", "B", "seed 2"))
        self.assertEqual(float(first["damage_overlap_on_grid"]), 1)
        self.assertEqual(float(first["orientation_distance_to_first_deg"]), 0)
        self.assertEqual(second["damage_overlap_same_mesh"], "nan")
        self.assertTrue(0 < float(second["damage_overlap_on_grid"]) < 1)
        self.assertTrue(0 < float(second["orientation_distance_to_first_deg"]) < 45)
        self.assertIn(result.stdout.splitlines()[5], png.with_suffix(".md").read_text(encoding="utf-8"))

    def test_the_table_agrees_with_the_runs_own_files(self):
        png = SCRATCH / "agree" / "x.png"
        self.succeed("compare", self.one, self.two, "--out", png, "--at", "0.02")
        for row, run in zip(self.rows(png.with_suffix(".csv")), (self.one, self.two)):
            broken = [c for c in self.rows(run / "cracks.csv") if float(c["time_s"]) <= float(row["time_s"])]
            self.assertEqual(float(row["cracks_tension"]), sum(c["mode"] == "tension" for c in broken))
            self.assertEqual(float(row["cracks_shear"]), sum(c["mode"] == "shear" for c in broken))
            self.assertAlmostEqual(float(row["crack_length_mm"]), sum(float(c["length_mm"]) for c in broken), places=6)
            curve = min(self.rows(run / "curves.csv"), key=lambda r: abs(float(r["time_s"]) - float(row["time_s"])))
            self.assertAlmostEqual(float(row["axial_strain"]), float(curve["axial_strain"]))
            self.assertEqual((float(curve["cracks_tension"]), float(curve["cracks_shear"])),
                             (float(row["cracks_tension"]), float(row["cracks_shear"])))
            shares = [float(row[f"{part}_share"]) for part in ("elastic", "fracture", "friction", "damping", "kinetic", "plasticity")]
            self.assertAlmostEqual(sum(shares), 1, places=2)
        bins = [r for r in self.rows(SCRATCH / "agree" / "x_orientation.csv") if r["run"] == "B"]
        self.assertEqual(len(bins), 18)
        self.assertAlmostEqual(sum(float(r["share_of_crack_length"]) for r in bins), 1)

    def test_two_runs_on_one_mesh_have_a_difference_map(self):
        png = SCRATCH / "mesh" / "x.png"
        result = self.succeed("compare", self.one, self.weak, "--out", png, "--field", "damage", "--align", "peak", "--at", "1")
        self.assertIn("contact cohesion 1.2 MPa", result.stdout)
        self.assertTrue((png.parent / "x_difference.png").is_file())
        self.assertLess(float(self.rows(png.with_suffix(".csv"))[1]["damage_overlap_same_mesh"]), 1)
        self.assertEqual(len(self.page(png.with_suffix(".html")).images), 3)
        self.succeed("compare", self.one, self.two, "--out", png)
        self.assertFalse((png.parent / "x_difference.png").exists())

    def test_the_page_stands_by_itself(self):
        png, html = SCRATCH / "page" / "x.png", SCRATCH / "elsewhere" / "page.html"
        self.succeed("compare", self.one, self.two, "--out", png, "--html", html)
        page = self.page(html)
        self.assertEqual(page.sections(), ["Patterns", "Curves", "Measures", "What differs", "Runs"])
        self.assertTrue(all(image["src"].startswith("data:image/png;base64,") for image in page.images))
        for words in ("/particles/seed", "main crack's angle", "seed 2", "Wasserstein"):
            self.assertIn(words, page.words)

    def test_a_run_that_never_fell_so_far_is_named(self):
        result = self.succeed("compare", self.one, self.two, "--align", "peak", "--at", "0.01", "--out", SCRATCH / "late" / "x.png")
        self.assertIn("A (one) has never fallen to 0.01 of the peak", result.stderr)
        self.assertIn("no", [row["aligned"] for row in self.rows(SCRATCH / "late" / "x.csv")])

    def test_the_default_name_tells_the_runs(self):
        result = self.succeed("compare", self.one, self.two)
        self.assertEqual(result.stdout.splitlines()[-1], "outputs/compare_one_two.png")
        self.assertTrue((SCRATCH / "outputs" / "compare_one_two.html").is_file())

    def test_montage(self):
        for run, name in ((self.one, "disc"), (self.joint, "joint")):
            png = SCRATCH / "montage" / f"{name}.png"
            result = self.succeed("compare", "--montage", run, "--frames", "4", "--out", png)
            self.assertEqual(result.stdout, f"{png}\n")
            if vtkPNGReader:
                self.assertGreater(colours(png)[0], 60)

    def test_what_cannot_be_compared_is_one_clear_error(self):
        bare = SCRATCH / "bare"
        self.succeed("run", TINY, "--set", "/output/frames=0", "--out", bare)
        empty = SCRATCH / "empty"
        empty.mkdir()
        unfinished = shutil.copytree(self.one, SCRATCH / "unfinished")
        (unfinished / "cracks.csv").unlink()
        for code, arguments, words in (
                (2, (self.one,), "is given 1 time"), (2, (), "2 to 12 run folders"), (2, [self.one] * 13, "is given 13 times"),
                (3, (self.one, empty), "holds no run"), (3, (self.one, SCRATCH / "nowhere"), "is no folder"),
                (3, (self.one, bare), "has no frames"), (3, (self.one, unfinished), "`asperity resume"),
                (3, (self.one, self.joint), "another experiment"), (2, (self.one, self.two, "--at", "0.5"), "--at"),
                (2, (self.one, self.two, "--align", "peak", "--at", "2"), "no part of the peak"),
                (2, (self.joint, self.joint, "--align", "strain"), "no strain"),
                (2, (self.one, self.two, "--out", "x.jpg"), "ends in .png"),
                (2, (self.one, "--montage", self.one), "excludes"), (2, (self.one, self.two, "--field", "stress"), "--field")):
            with self.subTest(words=words):
                self.assertIn(words, self.fail_with(code, "compare", *arguments))


class Index(support.CommandLineTest):
    def test_a_folder_of_runs_has_an_index(self):
        folder = SCRATCH / "many runs"
        shutil.copytree(runs_made() / "one", folder / "one")
        shutil.copytree(runs_made() / "joint", folder / "a joint")
        broken = shutil.copytree(runs_made() / "two", folder / "broken")
        (broken / "manifest.json").write_text("{")
        failed = shutil.copytree(runs_made() / "weak", folder / "weak")
        manifest = json.loads((failed / "manifest.json").read_text())
        manifest.update(outcome="failed", exit_reason="a <particle> turned over")
        (failed / "manifest.json").write_text(json.dumps(manifest))
        (failed / "summary.json").unlink()
        (folder / "compare_x.html").write_text("<p>")
        result = self.succeed("report", folder)
        self.assertEqual(result.stdout, f"{folder}/index.html\n")
        text = (folder / "index.html").read_text(encoding="utf-8")
        page = Page(text)
        self.assertEqual(page.open, [])
        for word in ("http:", "https:", "<script src", "@import", "url("):
            self.assertNotIn(word, text)
        self.assertEqual(text.count("<tr"), 5)
        for words in ("Brazilian disc", "Direct shear of a joint, 1 MPa", "seed 1, edge 5 mm", "failed: a <particle> turned over", "cannot be read"):
            self.assertIn(words, page.words)
        strength = json.loads((folder / "one" / "summary.json").read_text())["results"]["tensile_strength_mpa"]
        self.assertIn(f"{strength:.4f}", page.words)
        for link in page.links:
            if not link.startswith("#"):
                self.assertTrue((folder / link.replace("%20", " ")).exists(), link)
        self.assertIn("a%20joint/report.html", page.links)
        self.assertIn("compare_x.html", page.links)
        self.assertEqual(len(page.images), 2)
        for image in page.images:
            self.assertGreater(len(image["alt"]), 20)
            self.assertTrue((folder / image["src"].replace("%20", " ")).is_file())
        self.assertEqual([c["type"] for c in page.controls], ["search"])


def runs_made():
    """The runs that Compare has made; made here where it has not been run."""
    if not (SCRATCH / "runs").exists():
        Compare.setUpClass()
    return SCRATCH / "runs"


if __name__ == "__main__":
    support.main()
