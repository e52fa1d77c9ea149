"""`asperity confront` on tiny discs: verdict, the runs that are shown, Ctrl-C and again, the page and its Markdown, and pictures of
confusion matrices. The measured numbers are made up: as strong as the base, and softer."""
import hashlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time

import support
from report_page import Page, check_self_contained
from support import SCRATCH

HERE = pathlib.Path(__file__).resolve().parent
CONFRONTATION = HERE / "tiny_confrontation.json"
SECONDS = 900  # some fifty runs of a third of a second each, on a machine that may be busy with other tests
WORDS = {"nothing_found": "Nothing found", "named": "One mechanism of the library explains it", "unexplained": "Unexplained",
         "indistinguishable": "mechanisms explain it", "two_causes": "these two together do"}
MATRIX = {"rows": ["seating", "none"], "columns": ["seating", "nothing found"], "counts": [[9, 1], [0, 10]]}


def finished(store):
    """When each run's curve was written, by the names of the store's finished runs."""
    times = {}
    for path in store.glob("*/manifest.json"):
        if json.loads(path.read_text())["outcome"] == "finished":
            times[path.parent.name] = (path.parent / "curves.csv").stat().st_mtime_ns
    return times


def bytes_below(folder):
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def asperity(*arguments):
    return subprocess.run(support.command(*arguments), capture_output=True, text=True, timeout=SECONDS, cwd=SCRATCH,
                          env=support.environment())


class Confront(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        """One confrontation serves all tests."""
        cls.folder = SCRATCH / "tiny"
        cls.result = asperity("confront", CONFRONTATION, "--store", SCRATCH / "store", "--out", cls.folder, "--quiet")

    def page(self, folder):
        text = (folder / "report.html").read_text(encoding="utf-8")
        page = Page(text)
        check_self_contained(self, folder, text, page)
        return page

    def verdict(self):
        return json.loads((self.folder / "verdict.json").read_text())

    def test_the_verdict_is_written_and_printed(self):
        self.assertEqual(self.result.returncode, 0, self.result.stderr)
        verdict = self.verdict()
        self.assertIn("status " + " ".join([verdict["status"], *verdict["causes"]]), self.result.stdout)
        self.assertIn("frame_compliance", verdict["causes"])  # the only thing that softens a disc as a whole
        frozen = (self.folder / "frozen.json").read_bytes()
        self.assertEqual(hashlib.sha256(frozen).hexdigest(), verdict["frozen_sha256"])
        for name in ("config.original.json", "manifest.json", "shown.json", "report.html", "report.md", "configs/tiny_B1.json"):
            self.assertTrue((self.folder / name).is_file(), name)

    def test_the_extension_states_its_own_microparameters_which_its_configurations_hold(self):
        verdict, config = self.verdict(), json.loads((self.folder / "configs/tiny_B1.json").read_text())
        refitted = {p["name"]: p for p in verdict["extended_parameters"]}
        self.assertAlmostEqual(refitted["t_c"]["value"], config["contacts"]["tensile_strength_mpa"], delta=1e-9)
        self.assertGreater(refitted["t_c"]["error"], 0.0)
        self.assertIn("With frame_compliance", re.sub(r"\s+", " ", self.page(self.folder).words))

    def test_the_page_says_the_verdict_and_has_every_chapter(self):
        page, verdict = self.page(self.folder), self.verdict()
        self.assertEqual(page.sections(), ["Verdict", "What is wrong", "The cause", "The gain", "Failure patterns",
                                           "What these data could not have shown", "What was declared or assumed", "Provenance"])
        words = re.sub(r"\s+", " ", page.words)
        self.assertIn(WORDS[verdict["status"]], words)
        for text in ("compliance of the loading frame (frame_compliance)", "stiffness", verdict["data_sha256"], "tiny_discs",
                     "not measured | not needed", "Tests kept back", "contact tensile strength", "decoy" if verdict["gain"]["decoys"] else "gain"):
            self.assertIn(text, words)
        self.assertEqual({i["src"] for i in page.images}, {"plots/residuals.png", "plots/fingerprints.png", "plots/cosines.png",
                                                           "pictures/brazilian.png"})

    def test_results_of_other_data_are_kept_unless_force_is_given(self):
        folder = SCRATCH / "kept"
        words = ("--store", SCRATCH / "store", "--out", folder, "--quiet", "--no-report")
        self.assertEqual(asperity("confront", CONFRONTATION, *words).returncode, 0)
        (folder / "plots").mkdir()
        before = (folder / "verdict.json").read_bytes()
        self.assertEqual(asperity("confront", CONFRONTATION, *words).returncode, 0)  # the same: goes on
        refused = asperity("confront", CONFRONTATION, *words, "--set", "/seed=2")
        self.assertEqual(refused.returncode, 5, refused.stderr)
        self.assertIn("holds results of another configuration or of other data", refused.stderr)
        self.assertIn("--force", refused.stderr)
        self.assertEqual((folder / "verdict.json").read_bytes(), before)
        replaced = asperity("confront", CONFRONTATION, *words, "--set", "/seed=2", "--force")
        self.assertEqual(replaced.returncode, 0, replaced.stderr)
        self.assertFalse((folder / "plots").exists())
        manifest = json.loads((folder / "manifest.json").read_text())
        self.assertEqual((manifest["outcome"], len(manifest["config_hash"])), ("finished", 64))

    def test_results_whose_manifest_is_lost_are_kept(self):
        folder = SCRATCH / "lost"
        folder.mkdir()
        (folder / "verdict.json").write_text("{}")
        words = ("--store", SCRATCH / "store", "--out", folder, "--quiet", "--no-report")
        refused = asperity("confront", CONFRONTATION, *words)
        self.assertEqual(refused.returncode, 5, refused.stderr)
        self.assertIn("without a manifest", refused.stderr)
        self.assertEqual((folder / "verdict.json").read_text(), "{}")

    def test_a_bad_bank_replaces_nothing_and_a_bank_without_a_folder_costs_no_run(self):
        folder = SCRATCH / "banked"
        words = ("confront", CONFRONTATION, "--store", SCRATCH / "store", "--out", folder, "--quiet", "--no-report")
        self.assertEqual(asperity(*words).returncode, 0)
        before = bytes_below(folder)
        bad = asperity(*words, "--set", "/seed=4", "--set", "/bank=none.txt", "--force")
        self.assertEqual(bad.returncode, 3, bad.stderr)
        self.assertIn("/bank: is no file", bad.stderr)
        nowhere = asperity(*words, "--set", "/seed=4", "--force", "--write-bank", SCRATCH / "nowhere/bank.txt")
        self.assertEqual(nowhere.returncode, 5, nowhere.stderr)
        self.assertIn("--write-bank", nowhere.stderr)
        self.assertEqual(asperity(*words, "--check-bank", "nan").returncode, 2)
        self.assertEqual(bytes_below(folder), before)

    def test_features_that_were_gathered_and_damaged_are_read_anew(self):
        store = SCRATCH / "damaged_store"
        shutil.copytree(SCRATCH / "store", store)
        gathered = list(store.glob("features_*.txt"))
        self.assertEqual(len(gathered), 1)
        gathered[0].write_text("junk")
        result = asperity("confront", CONFRONTATION, "--store", store, "--out", SCRATCH / "damaged", "--no-report")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("is damaged", result.stderr)
        self.assertIn(" 0 computed", result.stdout)
        self.assertEqual((SCRATCH / "damaged/verdict.json").read_bytes(), (self.folder / "verdict.json").read_bytes())

    def test_results_of_a_measured_file_that_has_changed_are_kept(self):
        mine = SCRATCH / "mine.json"
        measured = json.loads((HERE / "tiny_confrontation_measured.json").read_text())
        mine.write_text(json.dumps(measured))
        words = ("confront", CONFRONTATION, "--store", SCRATCH / "store", "--out", SCRATCH / "mine", "--quiet", "--no-report", "--set", f"/measured={mine}")
        self.assertEqual(asperity(*words).returncode, 0)
        results = measured["tests"][0]["results"]
        results["tensile_strength_mpa"] = [1.01 * v for v in results["tensile_strength_mpa"]]
        mine.write_text(json.dumps(measured))
        self.assertEqual(asperity(*words).returncode, 5)

    def test_the_markdown_has_the_same_chapters_and_pictures(self):
        text = (self.folder / "report.md").read_text()
        self.assertEqual(re.findall(r"^## (.*)$", text, re.M), self.page(self.folder).sections())
        pictures = re.findall(r"^!\[.{20,}\]\((.*)\)$", text, re.M)
        self.assertEqual(len(pictures), 4)
        for picture in pictures:
            self.assertTrue((self.folder / picture).is_file(), picture)

    def test_shown_runs_are_of_both_models_on_the_same_meshes(self):
        shown = json.loads((self.folder / "shown.json").read_text())
        self.assertEqual(shown["extension"], self.verdict()["gain"]["causes"])
        for test in shown["tests"]:
            for model in ("base", "extension"):
                self.assertEqual([r["seed"] for r in test[model]], [1, 2, 3])
                self.assertTrue(all(r["finished"] and len(r["path"]) == len(r["load"]) > 50 for r in test[model]))
                self.assertAlmostEqual(max(test[model][0]["load"]), test[model][0]["features"]["peak_load_n_per_mm"], delta=1e-3)
        self.assertEqual(len(shown["candidates"]), 2)
        self.assertTrue(all(len(c["projected"]) == len(shown["slots"]) for c in shown["candidates"]))

    def test_the_page_is_made_anew_from_the_folder_alone(self):
        copy = SCRATCH / "copy"
        shutil.copytree(self.folder, copy)
        shutil.rmtree(copy / "plots")
        shown = json.loads((copy / "shown.json").read_text())
        for test in shown["tests"]:
            for run in test["base"] + test["extension"]:
                run["folder"] = "gone"
        (copy / "shown.json").write_text(json.dumps(shown))
        before = (self.folder / "report.html").read_bytes()
        result = asperity("report", copy)
        self.assertEqual((result.returncode, result.stdout), (0, f"{copy}/report.html\n"), result.stderr)
        self.assertEqual((copy / "report.html").read_bytes(), before)
        self.assertEqual((copy / "plots/residuals.png").read_bytes(), (self.folder / "plots/residuals.png").read_bytes())

    def test_without_a_report_there_is_the_same_verdict_and_nothing_to_show(self):
        bare = SCRATCH / "bare"
        before = len(list((SCRATCH / "store").iterdir()))
        result = asperity("confront", CONFRONTATION, "--store", SCRATCH / "store", "--out", bare, "--quiet", "--no-report")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(" 0 computed", result.stdout)
        self.assertEqual((bare / "verdict.json").read_bytes(), (self.folder / "verdict.json").read_bytes())
        self.assertEqual(sorted(p.name for p in bare.iterdir()), ["config.original.json", "configs", "frozen.json", "manifest.json", "verdict.json"])
        self.assertEqual(len(list((SCRATCH / "store").iterdir())), before)
        result = asperity("report", bare)
        self.assertEqual(result.returncode, 3)
        self.assertIn("shown.json: is missing", result.stderr)
        self.assertIn("--no-report", result.stderr)

    def test_ctrl_c_in_the_middle_of_its_runs_and_again(self):
        out, store = SCRATCH / "interrupted", SCRATCH / "interrupted_store"
        words = ("confront", CONFRONTATION, "--store", store, "--out", out, "--quiet", "--no-report")
        run = subprocess.Popen(support.command(*words), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=SCRATCH,
                               env=support.environment())
        while len(finished(store)) < 4:
            self.assertIsNone(run.poll(), "it ended before its fourth run")
            time.sleep(0.01)
        os.kill(run.pid, signal.SIGINT)
        printed, err = run.communicate(timeout=support.SECONDS)
        self.assertEqual((run.returncode, printed), (130, ""), err)
        self.assertIn("interrupted; the same command goes on from there", err)
        self.assertFalse((out / "verdict.json").exists())
        self.assertEqual(json.loads((out / "manifest.json").read_text())["outcome"], "interrupted")
        before = finished(store)
        again = asperity(*words)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual((out / "verdict.json").read_bytes(), (self.folder / "verdict.json").read_bytes())
        after = finished(store)
        self.assertEqual({name: after[name] for name in before}, before)  # what was finished is not computed again
        from_nothing = int(re.search(r"(\d+) computed", self.result.stdout)[1])
        self.assertGreaterEqual(len(before), 4)
        self.assertLess(len(after) - len(before), from_nothing)
        self.assertIn(f" {len(after) - len(before)} computed", again.stdout)

    def test_a_confusion_matrix_is_drawn(self):
        source = SCRATCH / "confusion.json"
        source.write_text(json.dumps(MATRIX))
        for target in (SCRATCH / "confusion.png", SCRATCH / "confusion.svg"):
            result = asperity("report", "--confusion", source, "--out", target)
            self.assertEqual((result.returncode, result.stdout), (0, f"{target}\n"), result.stderr)
            self.assertGreater(target.stat().st_size, 2000)
        self.assertIn(">nothing found<", (SCRATCH / "confusion.svg").read_text())

    def test_what_is_no_confusion_matrix_is_refused(self):
        source = SCRATCH / "wrong.json"
        for change, words, code in (({"counts": [[9, 1]]}, "another number of rows", 3), ({"counts": [[9, -1], [0, 10]]}, "no count", 3),
                                    ({"rows": 3}, "another type", 3)):
            source.write_text(json.dumps({**MATRIX, **change}))
            result = asperity("report", "--confusion", source)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertIn(words, result.stderr)
        source.write_text(json.dumps(MATRIX))
        result = asperity("report", "--confusion", source, "--out", SCRATCH / "matrix.pdf")
        self.assertEqual(result.returncode, 2)
        self.assertIn(".png or .svg", result.stderr)


if __name__ == "__main__":
    support.main()
