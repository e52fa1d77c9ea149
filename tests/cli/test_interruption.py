"""Ctrl-C, SIGTERM and SIGKILL in the middle of a run, checkpoints torn or foreign, and `resume` after each."""
import json
import os
import shutil
import signal
import subprocess
import time

import support
from support import SCRATCH, TINY, settings

TABLES = ["curves.csv", "energy.csv", "cracks.csv", "events.csv"]
RUN = ["run", TINY, "--no-render"]


def stop_at(percent, signal_number, folder, arguments=RUN):
    """Starts the run, sends the signal when progress has reached `percent`; returns exit code, stdout and the rest of stderr."""
    run = subprocess.Popen(support.command(*arguments, "--out", folder), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                           cwd=SCRATCH, env=support.environment())
    for line in run.stderr:
        word = line.split()
        if len(word) > 2 and word[2] == "%" and int(word[1]) >= percent:
            break
    os.kill(run.pid, signal_number)
    out, err = run.communicate(timeout=support.SECONDS)
    return run.returncode, out, err


class Interruption(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        cls.whole = SCRATCH / "uninterrupted"
        result = support.asperity(*RUN, "--quiet", "--out", cls.whole)
        assert result.returncode == 0, result.stderr

    def outcome(self, folder):
        return json.loads((folder / "manifest.json").read_text())["outcome"]

    def assert_series_whole(self, folder):
        self.assertEqual(support.assert_series_whole(self, folder), ["fields", "cracks", "contacts"])

    def assert_resumes(self, folder):
        result = self.succeed("resume", folder, "--no-render", "--quiet")
        self.assertEqual(result.stdout.splitlines()[-1], str(folder))
        self.assertEqual(self.outcome(folder), "finished")
        self.assert_same_bytes(folder, self.whole, [*TABLES, "fields.pvd", "cracks.pvd", "contacts.pvd"])
        self.assert_same_bytes(folder, self.whole, [p.relative_to(self.whole) for p in self.whole.glob("*/*.vtu")])

    def interrupted(self, signal_number, name, percent=50):
        """A folder whose run was ended by the signal; checks what the design promises of it."""
        folder = SCRATCH / name
        code, out, err = stop_at(percent, signal_number, folder)
        self.assertEqual(code, 130, err)
        self.assertEqual(out, "")
        self.assertIn(f"asperity resume {folder}", err)
        self.assertEqual(self.outcome(folder), "interrupted")
        self.assert_series_whole(folder)
        done = (folder / "curves.csv").read_bytes()
        whole = (self.whole / "curves.csv").read_bytes()
        self.assertTrue(whole.startswith(done) and len(done) < len(whole))
        return folder

    def test_the_uninterrupted_run_breaks_contacts_before_and_after_the_middle(self):
        head, *rows = (self.whole / "cracks.csv").read_text().splitlines()
        times = [float(row.split(",")[head.split(",").index("time_s")]) for row in rows]
        end = float((self.whole / "curves.csv").read_text().splitlines()[-1].split(",")[0])
        self.assertTrue(times and min(times) < 0.5 * end < max(times), times)

    def test_ctrl_c(self):
        self.assert_resumes(self.interrupted(signal.SIGINT, "ctrl_c"))

    def test_sigterm(self):
        self.assert_resumes(self.interrupted(signal.SIGTERM, "sigterm", percent=70))

    def test_ctrl_c_before_the_first_progress_line(self):
        self.assert_resumes(self.interrupted(signal.SIGINT, "at_once", percent=0))

    def test_killed_without_a_checkpoint_starts_again(self):
        folder = SCRATCH / "killed"
        self.assertEqual(stop_at(50, signal.SIGKILL, folder)[0], -signal.SIGKILL)
        self.assertEqual(list((folder / "checkpoint").iterdir()), [])  # one is written a minute
        self.assertEqual(self.outcome(folder), "running")
        self.assert_series_whole(folder)
        self.assert_resumes(folder)

    def test_killed_before_its_manifest_starts_again(self):
        folder = self.interrupted(signal.SIGINT, "at_start", percent=10)
        (folder / "manifest.json").unlink()
        self.assert_resumes(folder)
        self.assert_same_bytes(folder, self.whole, ["config.original.json", "config.effective.json"])

    def test_resume_by_other_code_is_told(self):
        folder = self.interrupted(signal.SIGINT, "other_code", percent=80)
        manifest = json.loads((folder / "manifest.json").read_text())
        (folder / "manifest.json").write_text(json.dumps({**manifest, "revision": "0123abc"}))
        told = "this run was begun by other code, revision 0123abc"
        self.assertIn(told, self.succeed("resume", folder, "--no-render").stderr)
        self.assertIn(told, (folder / "log.txt").read_text())

    def test_run_again_after_an_interruption_starts_from_the_beginning(self):
        folder = self.interrupted(signal.SIGINT, "run_again")
        self.succeed(*RUN, "--quiet", "--out", folder)
        self.assertEqual(self.outcome(folder), "finished")
        self.assert_same_bytes(folder, self.whole, TABLES)

    def twice_saved(self, name):
        """A folder interrupted after a checkpoint was written before the last, and the two files, the newer first."""
        folder = SCRATCH / name
        code, _, err = stop_at(60, signal.SIGINT, folder, [*RUN, *settings(output__checkpoint_interval_s=0.05)])
        self.assertEqual(code, 130, err)
        pair = sorted((folder / "checkpoint").iterdir(), key=lambda p: p.stat().st_mtime_ns, reverse=True)
        self.assertEqual(sorted(p.name for p in pair), ["state_0.bin", "state_1.bin"])
        return folder, *pair

    def test_torn_checkpoint_falls_back_to_the_one_before(self):
        folder, newer, older = self.twice_saved("torn")
        newer.write_bytes(newer.read_bytes()[:-1])
        result = self.succeed("resume", folder, "--no-render")
        told = f"warning: {newer}: is damaged: its checksum does not hold; goes on from the other checkpoint, {older}"
        self.assertIn(told, result.stderr)
        self.assertIn(told.removeprefix("warning: "), (folder / "log.txt").read_text())
        self.assert_same_bytes(folder, self.whole, support.result_files(self.whole))

    def test_two_unusable_checkpoints_are_refused_and_the_folder_stays(self):
        folder, newer, older = self.twice_saved("damaged")
        content = newer.read_bytes()
        flipped = bytearray(content)
        flipped[len(content) // 2] ^= 1
        older.write_bytes(b"")
        damages = {
            "is damaged: its checksum does not hold": bytes(flipped),
            "is damaged": content[:-1],
            "is no checkpoint of this version": b"asperity checkpoint 0\n" + content,
        }
        for message, content in damages.items():
            with self.subTest(message=message):
                newer.write_bytes(content)
                before = support.listing(folder)
                text = self.fail_with(5, "resume", folder)
                self.assertIn(f"{newer}: {message}", text)
                self.assertIn(f"{older}: is no checkpoint of this version", text)
                self.assertIn("Hint: ", text)
                after = support.listing(folder)
                before.pop(".asperity.lock"), after.pop(".asperity.lock")  # it names the process that came last
                self.assertEqual(after, before)
        self.succeed(*RUN, "--quiet", "--out", folder)  # the hint's way out
        self.assert_same_bytes(folder, self.whole, TABLES)

    def test_checkpoint_of_another_configuration_is_refused(self):
        other = SCRATCH / "other_seed"
        self.assertEqual(stop_at(30, signal.SIGINT, other, [*RUN, *settings(particles__seed=2)])[0], 130)
        folder = self.interrupted(signal.SIGINT, "foreign")
        shutil.copy(other / "checkpoint/state_0.bin", folder / "checkpoint/state_0.bin")
        text = self.fail_with(5, "resume", folder)
        self.assertIn("checkpoint/state_0.bin: belongs to another configuration", text)

    def test_ctrl_c_while_pictures_are_drawn(self):
        folder, whole = SCRATCH / "drawing", SCRATCH / "drawn"
        drawn = ["run", TINY, *settings(experiment__stop__axial_strain=0.004, output__frames=12)]
        self.succeed(*drawn, "--quiet", "--out", whole)
        run = subprocess.Popen(support.command(*drawn, "--quiet", "--out", folder), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, cwd=SCRATCH, env=support.environment())
        while not list((folder / "frames").glob("*_000002.png")):
            self.assertIsNone(run.poll(), "it ended before its third frame")
            time.sleep(0.005)
        run.send_signal(signal.SIGINT)
        out, err = run.communicate(timeout=support.SECONDS)
        self.assertEqual((run.returncode, out), (130, ""), err)
        self.assertEqual(self.outcome(folder), "interrupted")
        done = {p.name: p.stat().st_mtime_ns for p in (folder / "frames").glob("*.png")}
        self.assertLess(len(done), len(list((whole / "frames").iterdir())))
        first = (folder / "frames/cracks_000000.png").stat().st_mtime_ns
        curves = (folder / "curves.csv").stat().st_ino
        self.succeed("resume", folder, "--quiet")
        self.assertEqual(self.outcome(folder), "finished")
        self.assertEqual((folder / "frames/cracks_000000.png").stat().st_mtime_ns, first)  # what is drawn is not drawn again
        self.assertEqual((folder / "curves.csv").stat().st_ino, curves)
        self.assertEqual(support.result_files(folder), support.result_files(whole))
        self.assert_same_bytes(folder, whole, support.result_files(whole))

    def test_changed_config_in_the_folder_is_refused(self):
        folder = self.interrupted(signal.SIGINT, "changed")
        config = folder / "config.effective.json"
        config.write_text(config.read_text().replace('"samples": 200', '"samples": 300'))
        self.assertIn("is not the configuration this run was started with", self.fail_with(5, "resume", folder))


if __name__ == "__main__":
    support.main()
