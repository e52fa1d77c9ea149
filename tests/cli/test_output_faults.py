"""What can happen to a run folder from outside: a full disk, no permission, a folder gone, two processes; and a run that fails."""
import contextlib
import json
import os
import resource
import shutil
import signal
import subprocess
import time
import unittest

import support
from support import SCRATCH, TINY, settings

SHORT = settings(experiment__stop__axial_strain=0.01, output__checkpoint_interval_s=0.03)
RUN = ["run", TINY, *SHORT, "--no-render", "--quiet"]
# Pieces so soft that they are pressed through one another once the disc is crushed.
SOFT = settings(contacts__general__fracture__normal_stiffness_mpa_per_mm=0.1,
                contacts__general__outline__normal_stiffness_mpa_per_mm=0.1, experiment__stop__axial_strain=0.2,
                experiment__loading__closing_rate_mm_per_s=3000, output__checkpoint_interval_s=0.02,
                integration__guard_interval_steps=1)  # or the clock, by its checkpoints, decides in which step it shows


@contextlib.contextmanager
def mounted(path, options):
    """A tmpfs at the path, or a skipped test where this user may not mount one."""
    path.mkdir()
    done = subprocess.run(["mount", "-t", "tmpfs", "-o", options, "none", path], capture_output=True, text=True)
    if done.returncode != 0:
        raise unittest.SkipTest(f"no tmpfs can be mounted here: {done.stderr.strip()}")
    try:
        yield path
    finally:
        subprocess.run(["umount", "--lazy", path], check=True)


def start(*arguments, **options):
    return subprocess.Popen(support.command(*arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=SCRATCH,
                            env=support.environment(), **options)


def wait_for(path, run):
    """Until the file is there; the run must not end before."""
    while not path.exists():
        if run.poll() is not None:
            raise AssertionError(f"ended before {path}: {run.communicate()}")
        time.sleep(0.002)


class OutputFaults(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        cls.whole = SCRATCH / "whole"
        result = support.asperity(*RUN, "--out", cls.whole)
        assert result.returncode == 0, result.stderr

    def assert_finishes_to_the_same_bytes(self, folder):
        self.succeed("resume", folder, "--no-render", "--quiet")
        self.assertEqual(json.loads((folder / "manifest.json").read_text())["outcome"], "finished")
        self.assert_same_bytes(folder, self.whole, support.result_files(self.whole))
        self.assertEqual(support.result_files(folder), support.result_files(self.whole))

    def assert_whole_rows(self, table):
        head, *rows = table.read_text().splitlines()
        self.assertTrue(table.read_bytes().endswith(b"\n"))
        self.assertEqual({len(row.split(",")) for row in rows} - {len(head.split(","))}, set())

    def test_full_disk_and_resume_once_there_is_space(self):
        with mounted(SCRATCH / "disk", "size=4m") as disk:
            self.succeed(*RUN, "--out", disk / "probe")
            size = sum(p.stat().st_size for p in (disk / "probe").rglob("*") if p.is_file())
            shutil.rmtree(disk / "probe")
            failed = 0
            for share in (0.25, 0.5, 0.75, 0.9):  # of what the finished run takes, less the checkpoints it has then removed
                folder, ballast = disk / f"run_{share}", disk / "ballast"
                stat = os.statvfs(disk)
                ballast.write_bytes(bytes(max(0, stat.f_bavail * stat.f_frsize - int(share * size))))
                result = support.asperity(*RUN, "--out", folder)
                self.assertEqual((result.returncode, result.stdout), (5, ""), result.stderr)
                self.assertRegex(result.stderr, r"^error: .*No space left on device.*Hint: free space on that disk")
                self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                ballast.unlink()
                if (folder / "manifest.json").exists():
                    for name in ("curves.csv", "energy.csv"):
                        if (folder / name).exists():
                            self.assert_whole_rows(folder / name)
                    support.assert_series_whole(self, folder)
                    failed += 1
                    self.assert_finishes_to_the_same_bytes(folder)
                shutil.rmtree(folder)
            self.assertGreaterEqual(failed, 2)

    def test_file_size_limit_is_an_output_error_and_resume_goes_on_without_it(self):
        limited = SCRATCH / "limited"
        limit = (self.whole / "curves.csv").stat().st_size // 2

        def small_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

        run = start(*RUN, *settings(output__frames=2, output__checkpoint_interval_s=1000), "--out", limited, preexec_fn=small_files)
        out, err = run.communicate(timeout=support.SECONDS)
        self.assertEqual((run.returncode, out), (5, ""), err)
        self.assertIn("File too large", err)
        self.assert_whole_rows(limited / "curves.csv")
        self.succeed("resume", limited, "--no-render", "--quiet")
        self.assert_same_bytes(limited, self.whole, ["curves.csv", "energy.csv", "cracks.csv", "events.csv"])

    def test_folder_that_may_not_be_written(self):
        with contextlib.ExitStack() as stack:
            if os.geteuid() == 0:  # root may write into any folder of a disk that can be written at all
                closed, reason = stack.enter_context(mounted(SCRATCH / "read_only", "ro,size=64k")), "Read-only file system"
            else:
                closed, reason = SCRATCH / "closed", "Permission denied"
                closed.mkdir(mode=0o500)
            text = self.fail_with(5, *RUN, "--out", closed / "run")
            self.assertIn(f"cannot be created: {reason}. Hint: choose a folder you may write to with --out", text)
            self.assertEqual(list(closed.iterdir()), [])

    def test_folder_that_vanishes(self):
        for how in ("moved", "removed", "replaced"):
            with self.subTest(how=how):
                folder, elsewhere = SCRATCH / f"{how}_from", SCRATCH / f"{how}_to"
                run = start(*RUN, "--out", folder)
                wait_for(folder / "checkpoint/state_1.bin", run)
                folder.rename(elsewhere)
                if how == "removed":
                    shutil.rmtree(elsewhere)
                if how == "replaced":
                    shutil.copytree(self.whole, folder)
                out, err = run.communicate(timeout=support.SECONDS)
                self.assertEqual((run.returncode, out), (5, ""), err)
                self.assertRegex(err, rf"^error: {folder}(: was removed, moved or replaced|/.*No such file or directory)")
                if how == "replaced":
                    self.assert_same_bytes(folder, self.whole, [p.relative_to(self.whole) for p in self.whole.rglob("*") if p.is_file()])
                else:
                    self.assertFalse(folder.exists())
                if how == "moved":
                    self.assert_finishes_to_the_same_bytes(elsewhere)

    def test_two_processes_on_one_folder(self):
        folder = SCRATCH / "shared"
        run = start(*RUN, "--out", folder)
        wait_for(folder / "checkpoint/state_0.bin", run)
        for command in (["resume", folder], [*RUN, "--out", folder], [*RUN, "--force", "--out", folder]):
            run.send_signal(signal.SIGSTOP)  # it must not end while the others ask
            text = self.fail_with(5, *command)
            run.send_signal(signal.SIGCONT)
            self.assertIn(f"{folder}: another run writes there (found process {run.pid} on ", text)
            self.assertIn("Hint: ", text)
        out, err = run.communicate(timeout=support.SECONDS)
        self.assertEqual((run.returncode, err), (0, ""))
        self.assert_same_bytes(folder, self.whole, support.result_files(self.whole))

    def test_a_run_that_fails_keeps_its_curves_and_its_last_good_checkpoint(self):
        folder = SCRATCH / "failed"
        arguments = ["run", TINY, *SOFT, "--no-render", "--quiet", "--out", folder]
        text = self.fail_with(4, *arguments)
        self.assertRegex(text, r"^error: step \d+, t = \S+ s, near \(\S+, \S+\) mm: .*Likely cause: ")
        self.assertRegex(text, rf"The last checkpoint, of step \d+, is {folder}/checkpoint/state_[01].bin; `asperity resume {folder}`")
        manifest = json.loads((folder / "manifest.json").read_text())
        self.assertEqual(manifest["outcome"], "failed")
        self.assertIn(manifest["exit_reason"], text)
        self.assertGreater(len((folder / "curves.csv").read_text().splitlines()), 10)
        self.assertNotRegex((folder / "curves.csv").read_text(), "nan|inf")
        curves = (folder / "curves.csv").read_bytes()
        again = self.fail_with(4, "resume", folder, "--no-render", "--quiet")
        self.assertEqual(again.splitlines()[0], text.splitlines()[0])  # the same step, place and cause
        self.assertEqual((folder / "curves.csv").read_bytes(), curves)


if __name__ == "__main__":
    support.main()
