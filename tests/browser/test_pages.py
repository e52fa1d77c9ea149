"""Every kind of page in a real browser: no network, no complaint, keyboard, accessibility, widths, print.
Usage: test_pages.py ASPERITY SOURCE_ROOT SCRATCH. Screenshots of every page are left in SCRATCH/screenshots."""
import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
import support  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402
from support import SCRATCH, SOURCE, TINY, settings  # noqa: E402

from browser import Browser  # noqa: E402

CLI = SOURCE / "tests" / "cli"
SHOTS = SCRATCH / "screenshots"
WIDE, NARROW, SHEET = 1280, 400, 718  # CSS pixels: a laptop, a telephone, A4 between margins of 1 cm
SECONDS = 900  # a tiny confrontation makes some fifty runs


def asperity(*arguments):
    result = subprocess.run(support.command(*arguments), capture_output=True, text=True, timeout=SECONDS, cwd=SCRATCH,
                            env=support.environment())
    assert result.returncode == 0, result.stderr


def make_pages():
    """A page of each kind, by its name."""
    runs = SCRATCH / "runs"
    asperity("run", TINY, "--out", runs / "disc")
    asperity("run", TINY, *settings(particles__seed=2), "--out", runs / "other", "--no-render")
    asperity("run", CLI / "tiny_joint.json", "--out", runs / "joint")
    asperity("compare", runs / "disc", runs / "other", "--out", runs / "compared.png")
    shutil.copytree(CLI / "fixtures" / "calibration_report" / "simulated", SCRATCH / "calibration")
    asperity("report", SCRATCH / "calibration")
    asperity("report", runs)
    asperity("confront", CLI / "tiny_confrontation.json", "--store", SCRATCH / "store", "--out", SCRATCH / "confrontation", "--quiet")
    return {"disc": runs / "disc/report.html", "joint": runs / "joint/report.html", "index": runs / "index.html",
            "comparison": runs / "compared.html", "calibration": SCRATCH / "calibration/report.html",
            "confrontation": SCRATCH / "confrontation/report.html"}


class Pages(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        SHOTS.mkdir()
        cls.pages = make_pages()
        cls.browser = Browser()
        cls.addClassCleanup(cls.browser.close)

    def open(self, name, width=WIDE, kind="screen", scheme="light"):
        self.browser.width(width)
        self.browser.media(kind, scheme)
        self.browser.open(self.pages[name])
        self.browser.load_all_pictures()

    def each(self, check):
        for name in self.pages:
            with self.subTest(page=name):
                check(name)

    def test_pages_ask_for_files_beside_them_alone_and_cause_no_complaint(self):
        def check(name):
            self.open(name)
            home = self.pages[name].parent.as_uri()
            asked = self.browser.requests()
            self.assertGreater(len(asked), 1)
            self.assertEqual([url[:100] for url in asked if not url.startswith((home, "data:"))], [])
            self.assertEqual(self.browser.complaints(), [])
        self.each(check)

    def test_pages_can_be_read_by_all_in_light_and_dark(self):
        def check(name):
            for scheme in ("light", "dark"):
                self.open(name, scheme=scheme)
                self.assertEqual(self.browser.audit(), [], scheme)
                self.browser.screenshot(SHOTS / f"{name}_{scheme}.png")
        self.each(check)

    def test_pages_fit_windows_and_paper(self):
        def check(name):
            for width, kind in ((WIDE, "screen"), (NARROW, "screen"), (SHEET, "print")):
                self.open(name, width, kind)
                self.browser.screenshot(SHOTS / f"{name}_{kind}_{width}.png")
                self.assertEqual(self.browser.overflow(), [], f"{kind} at {width}")
        self.each(check)

    def test_on_paper_there_are_no_controls_and_every_picture(self):
        self.open("disc", SHEET, "print", "dark")
        self.assertFalse(self.browser.find(".controls").is_displayed())
        self.assertTrue(all(image.is_displayed() for image in self.browser.find_all("img")))
        self.assertEqual(self.browser.find("body").value_of_css_property("background-color"), "rgba(255, 255, 255, 1)")

    def viewer(self):
        slider, point, image = (self.browser.find(s) for s in (".viewer input[type=range]", ".viewer .present", ".viewer img"))
        return {"frame": slider.get_attribute("value"), "words": slider.get_attribute("aria-valuetext"),
                "text": self.browser.find(".viewer .state").text, "x": float(point.get_attribute("cx")), "y": float(point.get_attribute("cy")),
                "picture": image.get_attribute("src"), "alternative": image.get_attribute("alt")}

    def test_the_slider_moves_picture_text_and_point_by_the_keyboard(self):
        for name in ("disc", "joint"):
            self.open(name)
            slider = self.browser.find(".viewer input[type=range]")
            last = int(slider.get_attribute("max"))
            seen = []
            slider.send_keys(Keys.HOME)
            for frame in range(last + 1):
                state = self.viewer()
                self.assertEqual(state["frame"], str(frame))
                self.assertIn(f"{frame:06}.jpg", state["picture"])
                self.assertTrue(state["words"].startswith(f"Frame {frame + 1} of {last + 1}"), state)
                self.assertEqual(state["text"], state["words"])
                self.assertIn(state["words"], state["alternative"])
                seen.append(state)
                slider.send_keys(Keys.ARROW_RIGHT)
            places = [state["x"] for state in seen]
            self.assertEqual(places, sorted(places))
            self.assertGreater(places[-1] - places[0], 100)
            self.assertGreater(len({state["y"] for state in seen}), 1)
            slider.send_keys(Keys.END, Keys.ARROW_LEFT)
            self.assertEqual(self.viewer()["frame"], str(last - 1))

    def test_tab_and_arrows_reach_kinds_and_buttons(self):
        self.open("disc")
        kinds = self.browser.find_all(".viewer input[type=radio]")
        kinds[0].send_keys(Keys.ARROW_RIGHT)
        self.assertTrue(kinds[1].is_selected())
        self.assertIn("damage_", self.viewer()["picture"])
        reached = []
        for _ in range(4):
            self.browser.driver.switch_to.active_element.send_keys(Keys.TAB)
            active = self.browser.driver.switch_to.active_element
            reached.append(active.get_attribute("aria-label") or active.text)
        self.assertEqual(reached, ["Frame before", "Frame", "Next frame", "Play"])
        before = int(self.viewer()["frame"])
        self.browser.find("[data-step='-1']").send_keys(Keys.ENTER)
        self.assertEqual(int(self.viewer()["frame"]), before - 1)

    def test_the_index_is_sorted_and_filtered_by_the_keyboard(self):
        self.open("index")
        names = lambda: [row.find_element("css selector", "th").text for row in self.browser.find_all("tbody tr") if row.is_displayed()]  # noqa: E731
        self.assertEqual(sorted(names()), ["disc", "joint", "other"])
        heading = next(b for b in self.browser.find_all("thead button") if b.text.startswith("Run"))
        heading.send_keys(Keys.ENTER)
        self.assertEqual(names(), ["disc", "joint", "other"])
        heading.send_keys(Keys.ENTER)
        self.assertEqual(names(), ["other", "joint", "disc"])
        self.browser.find("input[type=search]").send_keys("seed 2")
        self.assertEqual(names(), ["other"])


if __name__ == "__main__":
    support.main()
