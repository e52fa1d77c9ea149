"""Ctrl-C, SIGTERM and SIGKILL in the middle of a run, and `resume` after each."""
import json
import os
import signal
import subprocess
import xml.etree.ElementTree as ElementTree

import support
from support import SCRATCH, TINY

TABLES = ["curves.csv", "energy.csv", "cracks.csv", "events.csv"]
RUN = ["run", TINY, "--no-render"]


def stop_at(percent, signal_number, folder):
    """Starts the run, sends the signal when progress has reached `percent`; returns exit code, stdout and the rest of stderr."""
    run = subprocess.Popen(support.command(*RUN, "--out", folder), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
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
        """Every file the two .pvd name can be read, and there is at least one."""
        for series in ("fields", "cracks", "contacts"):
            names = [e.get("file") for e in ElementTree.parse(folder / f"{series}.pvd").iter("DataSet")]
            self.assertTrue(names)
            for name in names:
                self.assertTrue((folder / name).read_bytes().rstrip().endswith(b"</VTKFile>"), name)

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

    def test_run_again_after_an_interruption_starts_from_the_beginning(self):
        folder = self.interrupted(signal.SIGINT, "run_again")
        self.succeed(*RUN, "--quiet", "--out", folder)
        self.assertEqual(self.outcome(folder), "finished")
        self.assert_same_bytes(folder, self.whole, TABLES)

    def test_damaged_checkpoint_is_refused_and_the_folder_stays(self):
        folder = self.interrupted(signal.SIGINT, "damaged")
        checkpoint = folder / "checkpoint/state.bin"
        content = bytearray(checkpoint.read_bytes())
        content[len(content) // 2] ^= 1
        damages = {
            "is damaged: its checksum does not hold": bytes(content),
            "is damaged": bytes(content[:-1]),
            "is no checkpoint of this version": b"asperity checkpoint 0\n" + bytes(content),
        }
        for message, content in damages.items():
            with self.subTest(message=message):
                checkpoint.write_bytes(content)
                before = support.listing(folder)
                text = self.fail_with(5, "resume", folder)
                self.assertIn(f"{checkpoint}: {message}", text)
                self.assertIn("Hint: ", text)
                after = support.listing(folder)
                before.pop(".asperity.lock"), after.pop(".asperity.lock")  # it names the process that came last
                self.assertEqual(after, before)

    def test_changed_config_in_the_folder_is_refused(self):
        folder = self.interrupted(signal.SIGINT, "changed")
        config = folder / "config.effective.json"
        config.write_text(config.read_text().replace('"samples": 200', '"samples": 300'))
        self.assertIn("is not the configuration this run was started with", self.fail_with(5, "resume", folder))


if __name__ == "__main__":
    support.main()
