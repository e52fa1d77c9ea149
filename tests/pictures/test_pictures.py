"""Every kind of picture against its baseline. Usage: test_pictures.py ASPERITY SOURCE_ROOT SCRATCH [--approve]

Pictures are drawn from the finished runs, the calibration and the confrontation stored beside this script and under tests/cli: no
number is computed here, so only a change of the drawing changes them. What has no baseline, or differs from it, fails; its
picture is left under SCRATCH/new at full size and SCRATCH/approve reduced. After looking at it, copy the reduced one into
tests/pictures/baselines, or run the script with --approve, which writes all of them."""
import json
import pathlib
import shutil
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "cli")]
APPROVE = "--approve" in sys.argv
if APPROVE:
    sys.argv.remove("--approve")
import pixels  # noqa: E402
import support  # noqa: E402
from support import SCRATCH, SOURCE  # noqa: E402

BASELINES = HERE / "baselines"
FIELDS = ("cracks", "contacts", "damage", "stress", "compressive_stress", "shear_stress", "fragments", "displacement")
MATRIX = {"rows": ["seating", "frame_compliance", "none"], "columns": ["seating", "frame_compliance", "nothing found"],
          "counts": [[9, 1, 0], [1, 8, 1], [0, 0, 10]]}
LAW_PAPER = SOURCE / "configs" / "paper" / "brazilian.json"
CALIBRATION = HERE.parent / "cli" / "fixtures" / "calibration_report" / "simulated"
CALIBRATION_KINDS = ("verification", "trade_off", "main_effects", "interactions", "predicted_against_simulated", "desirability_map",
                     "targets_map", "response_surface_cohesion_mpa", "residuals_cohesion_mpa")


def draw(*arguments):
    result = support.asperity(*arguments)
    assert result.returncode == 0, result.stderr


def copied(source, name):
    """A copy that can be drawn into: version control keeps no empty folder."""
    folder = pathlib.Path(shutil.copytree(source, SCRATCH / name))
    (folder / "plots").mkdir(exist_ok=True)
    return folder


def draw_runs():
    """Frames of a compression test by field, of a disc and of a joint; every plot of the three; comparisons."""
    runs = {name: copied(HERE / "runs" / name, f"runs/{name}") for name in ("uniaxial", "disc", "weaker", "joint")}
    draw("render", runs["uniaxial"], *[part for field in FIELDS for part in ("--field", field)], "--frames", "last")
    for name in ("disc", "joint"):
        draw("render", runs[name], "--field", "cracks", "--frames", "last")
    found = {}
    for name in ("uniaxial", "disc", "joint"):
        draw("report", runs[name])
        for folder in ("frames", "plots"):
            found.update({f"{name}/{path.stem}": path for path in (runs[name] / folder).glob("*.png")})
    compared, montage = SCRATCH / "compared.png", SCRATCH / "montage.png"
    draw("compare", runs["disc"], runs["weaker"], "--at", "0.02", "--out", compared)
    draw("compare", "--montage", runs["disc"], "--frames", "3", "--out", montage)
    found.update({"compare/grid": compared, "compare/curves": SCRATCH / "compared_curves.png",
                  "compare/difference": SCRATCH / "compared_difference.png", "compare/montage": montage})
    return found


def draw_others():
    """The contact law, a calibration, a confrontation and a confusion matrix."""
    draw("law", LAW_PAPER, "--out", SCRATCH / "law")
    calibration, confrontation = copied(CALIBRATION, "calibration"), copied(HERE / "confrontation", "confrontation")
    shown = confrontation / "shown.json"
    shown.write_text(shown.read_text().replace('"RUNS/', f'"{SCRATCH}/runs/'))
    draw("report", calibration)
    draw("report", confrontation)
    (SCRATCH / "confusion.json").write_text(json.dumps(MATRIX))
    draw("report", "--confusion", SCRATCH / "confusion.json", "--out", SCRATCH / "confusion.png")
    found = {f"law/{path.stem}": path for path in (SCRATCH / "law").glob("*.png")}
    found.update({f"calibration/{kind}": calibration / "plots" / f"{kind}.png" for kind in CALIBRATION_KINDS})
    for folder in ("plots", "pictures"):
        found.update({f"confrontation/{path.stem}": path for path in (confrontation / folder).glob("*.png")})
    found["confrontation/confusion"] = SCRATCH / "confusion.png"
    return found


class Pictures(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.found = {**draw_runs(), **draw_others()}

    def leave(self, name, path):
        new = SCRATCH / "new" / f"{name}.png"
        new.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, new)
        pixels.write_baseline(pixels.from_vtk(pixels.reduced(path)), SCRATCH / "approve" / f"{name}.png")

    def test_every_picture_shows_what_its_baseline_shows(self):
        for name, path in sorted(self.found.items()):
            baseline = BASELINES / f"{name}.png"
            with self.subTest(picture=name):
                if APPROVE:
                    pixels.write_baseline(pixels.from_vtk(pixels.reduced(path)), baseline)
                wrong = pixels.compare(path, baseline) if baseline.exists() else "has no baseline"
                if wrong:
                    self.leave(name, path)
                    self.fail(f"{name} {wrong}; the picture is {SCRATCH}/new/{name}.png. Look at it, then copy "
                              f"{SCRATCH}/approve/{name}.png to {baseline}")

    def test_every_baseline_has_its_picture(self):
        baselines = {path.relative_to(BASELINES).with_suffix("").as_posix() for path in BASELINES.rglob("*.png")}
        self.assertEqual(baselines - set(self.found), set())

    def changed(self, name, change):
        """The complaint about a picture after a change of its values."""
        picture = pixels.from_vtk(pixels.reduced(self.found[name]))
        values = bytearray(picture.values)
        change(picture, values)
        return pixels.difference(picture, pixels.Picture(picture.width, picture.height, bytes(values)))

    def test_what_a_reader_would_notice_is_noticed(self):
        def swap_colours(picture, values):  # red for blue: the same lightness, another map
            values[0::3], values[2::3] = values[2::3], values[0::3]

        def no_key(picture, values):  # the colour bar and all beside the specimen
            for y in range(picture.height):
                start = 3 * (y * picture.width + 3 * picture.width // 4)
                values[start:3 * (y + 1) * picture.width] = b"\xff" * (3 * (y + 1) * picture.width - start)

        def title_lower(picture, values):  # by 12 pixels of the full size
            row = 3 * picture.width
            top = picture.height - 25
            values[(top - 3) * row:(picture.height - 3) * row] = picture.values[top * row:]

        last = max(name for name in self.found if name.startswith("uniaxial/stress_0"))
        for change in (swap_colours, no_key, title_lower):
            with self.subTest(change=change.__name__):
                self.assertIn("differs by up to", str(self.changed(last, change)))

    def test_what_a_reader_would_not_notice_is_let_pass(self):
        def noise(picture, values):
            for i in range(len(values)):
                values[i] = max(0, min(255, values[i] + (i * 7919) % 7 - 3))

        for name in sorted(self.found)[::7]:
            self.assertIsNone(self.changed(name, noise), name)


if __name__ == "__main__":
    support.main()
