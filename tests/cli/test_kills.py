"""kill -9 at random moments: every file stays readable, at most one checkpoint interval is lost, the bytes come out the same."""
import json
import random
import re
import signal
import subprocess
import time

import support
from support import SCRATCH, TINY, settings

INTERVAL = 0.05  # s; a kill then finds checkpoints of every age, and often one that is being written
SMALL = settings(experiment__stop__axial_strain=0.012, output__width_px=320, output__height_px=240,
                 output__checkpoint_interval_s=INTERVAL)
SEED = 20240501
RUNS, KILLS_EACH = 5, 4
COMPUTING = 0.7  # share of the moments that lie in the computation; the others lie in the drawing


class Kills(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        cls.whole = SCRATCH / "uninterrupted"
        result = support.asperity("run", TINY, *SMALL, "--quiet", "--out", cls.whole)
        assert result.returncode == 0, result.stderr

    def progress(self, folder):
        """How far the run has come, 0 to 1, by what it has written: moments that do not depend on the machine's load."""
        size = (folder / "curves.csv").stat().st_size if (folder / "curves.csv").exists() else 0
        drawn, pictures = (len(list((f / "frames").glob("*.png"))) for f in (folder, self.whole))
        return COMPUTING * size / (self.whole / "curves.csv").stat().st_size + (1 - COMPUTING) * drawn / pictures

    def kill_at(self, moment, delay, folder, *arguments):
        """Starts the command and kills it some time (s) after it has come so far."""
        run = subprocess.Popen(support.command(*arguments), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=SCRATCH,
                               env=support.environment())
        while self.progress(folder) < moment and run.poll() is None:
            time.sleep(0.002)
        time.sleep(delay)
        run.kill()
        return run.wait() == -signal.SIGKILL

    def rows(self, folder):
        return len((folder / "curves.csv").read_text().splitlines()) - 1

    def assert_readable(self, folder):
        """The folder as a process cut off in any instruction leaves it: whole rows, whole JSON, series of whole files."""
        self.assertIn(json.loads((folder / "manifest.json").read_text())["outcome"], ("running", "finished"))
        if (folder / "curves.csv").exists():
            head, *rows = (folder / "curves.csv").read_text().splitlines()
            self.assertTrue((folder / "curves.csv").read_bytes().endswith(b"\n"))
            self.assertEqual({len(row.split(",")) for row in rows} - {len(head.split(","))}, set())
        support.assert_series_whole(self, folder)

    def resumed_step(self, folder):
        """The step the last session went on from; 0 where it began anew."""
        sessions = (folder / "log.txt").read_text().split(": Asperity ")
        found = re.search(r"resumed at step (\d+)", sessions[-1])
        return int(found[1]) if found else 0

    def test_twenty_kills_at_random_moments_lose_nothing(self):
        dice = random.Random(SEED)
        kills = 0
        for number in range(RUNS):
            folder = SCRATCH / f"killed_{number}"
            command = ["run", TINY, *SMALL, "--quiet", "--out", folder]
            for moment in sorted(dice.uniform(-0.1, 0.85) for _ in range(KILLS_EACH)):  # below 0: at the start
                kills += self.kill_at(moment, dice.uniform(0, 0.02 if moment > 0 else 0.3), folder, *command)
                if not (folder / "manifest.json").exists():  # killed while the mesh was made: nothing to resume
                    continue
                self.assert_readable(folder)
                command = ["resume", folder, "--quiet"]
            self.succeed(*command)
            names = support.result_files(self.whole)
            self.assertGreater(len([n for n in names if n.suffix == ".png"]), 6)
            self.assert_same_bytes(folder, self.whole, names)
            self.assertEqual(support.result_files(folder), names)
            self.assertEqual([p.name for p in folder.rglob("*.tmp")], [])
            self.assertEqual(list((folder / "checkpoint").iterdir()), [])
        self.assertEqual(kills, RUNS * KILLS_EACH)

    def test_with_a_checkpoint_after_every_step_not_one_step_is_lost(self):
        every = settings(experiment__stop__axial_strain=0.001, measurement__samples=50, output__checkpoint_interval_s=0)
        whole, folder = SCRATCH / "steps_whole", SCRATCH / "steps_killed"
        run = ["run", TINY, *every, "--no-render", "--quiet"]
        self.succeed(*run, "--out", whole)
        steps_per_row = json.loads((whole / "summary.json").read_text())["cost"]["steps"] // (self.rows(whole) - 1)
        killed = subprocess.Popen(support.command(*run, "--out", folder), cwd=SCRATCH, env=support.environment())
        while not (folder / "curves.csv").exists() or self.rows(folder) < 20:
            self.assertIsNone(killed.poll())
            time.sleep(0.005)
        killed.kill()
        killed.wait()
        rows = self.rows(folder)
        self.succeed("resume", folder, "--no-render", "--quiet")
        # Row n is written in step n * steps_per_row, counted from 0, whose checkpoint may or may not have been written.
        self.assertGreaterEqual(self.resumed_step(folder), (rows - 1) * steps_per_row)
        self.assert_same_bytes(folder, whole, support.result_files(whole))


if __name__ == "__main__":
    support.main()
