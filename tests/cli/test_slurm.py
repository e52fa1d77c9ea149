"""Campaigns on a real Slurm with one node: the same bytes as on this machine alone, whatever dies in the middle."""
import json
import pathlib
import signal
import subprocess
import time

import slurm_cluster
import support
from support import SCRATCH, TINY

SLURM = {"partition": "test", "memory_mb": 100, "time_limit_min": 10, "poll_interval_s": 0.3, "lost_after_s": 1}
CAMPAIGN = {"name": "grid", "base": str(TINY), "set": {"/output/frames": 0, "/output/checkpoint_interval_s": 0.05},
            "vary": [{"pointer": "/contacts/cohesion_mpa", "values": [1.5, 2.5]}], "seeds": [1, 2], "slurm": SLURM}
CONFRONTATION = pathlib.Path(__file__).resolve().parent / "tiny_confrontation.json"
TABLES = ["curves.csv", "cracks.csv", "energy.csv", "events.csv"]
ROWS = 200  # of each run's curves.csv


def arguments(name, *more):
    return ["campaign", SCRATCH / "grid.json", "--store", SCRATCH / f"{name}_store", "--out", SCRATCH / name, *more]


def rows_of(store):
    """How many rows each run of the store has."""
    return {p.parent.name: p.read_text().count("\n") for p in store.glob("*/curves.csv")}


def process(pid):
    """Command line, program and parent of a process; nothing of one that has just ended."""
    try:
        folder = pathlib.Path("/proc") / str(pid)
        program, rest = (folder / "stat").read_text().split("(", 1)[1].rsplit(")", 1)
        return (folder / "cmdline").read_text().replace("\0", " "), program, int(rest.split()[1])
    except (FileNotFoundError, ProcessLookupError):
        return "", "", 0


def processes_of(store, but):
    """Tasks' runs and shells, whose command names the store, and the step daemons above them, but not this process: the
    program of each by its number."""
    found = {}
    for pid in (int(p.name) for p in pathlib.Path("/proc").glob("[0-9]*")):
        command, program, parent = process(pid)
        if str(store) not in command or pid == but:
            continue
        found[pid] = program
        if process(parent)[1] == "slurmstepd":
            found[parent] = "slurmstepd"
    return found


class Slurm(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        why = slurm_cluster.missing()
        assert not why, why
        (SCRATCH / "grid.json").write_text(json.dumps(CAMPAIGN))
        result = support.asperity(*arguments("local", "--jobs", 2, "--quiet"))
        assert result.returncode == 0, result.stderr
        cls.cluster = slurm_cluster.Cluster(SCRATCH / "cluster", support.environment())
        cls.cluster.__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.cluster.__exit__()

    def start(self, name):
        words = support.command(*arguments(name, "--executor", "slurm", "--quiet"))
        return subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=SCRATCH,
                                env=self.cluster.environment)

    def finish(self, name, campaign):
        out, err = campaign.communicate(timeout=support.SECONDS)
        self.assertEqual((campaign.returncode, out), (0, f"{SCRATCH}/{name}/table.csv\n"), err + self.cluster.logs())
        self.assert_same_bytes(SCRATCH / name, SCRATCH / "local", ["table.csv"])
        folders = sorted(p.name for p in (SCRATCH / "local_store").iterdir() if p.is_dir())
        self.assertEqual(len(folders), 4)
        for folder in folders:
            self.assert_same_bytes(SCRATCH / f"{name}_store" / folder, SCRATCH / "local_store" / folder, TABLES)

    def half_way(self, name, campaign):
        """Waits until a run is at work, well within its rows, and has a checkpoint."""
        store = SCRATCH / f"{name}_store"
        while not any(20 < n < ROWS / 2 and list((store / run / "checkpoint").glob("*.bin")) for run, n in rows_of(store).items()):
            self.assertIsNone(campaign.poll(), "it ended too early")
            time.sleep(0.01)

    def queue(self):
        return self.cluster.command("squeue", "--noheader", "--array").stdout

    def logs(self, name):
        return "".join(p.read_text() for p in (SCRATCH / f"{name}_store").glob("*/log.txt"))

    def test_the_same_bytes_as_local(self):
        campaign = self.start("plain")
        self.finish("plain", campaign)
        self.assertEqual(list((SCRATCH / "plain_store/slurm").iterdir()), [])

    def test_the_compute_daemon_is_killed_and_comes_back(self):
        """The tasks live on under their step daemons, and are found again."""
        campaign = self.start("daemon")
        self.half_way("daemon", campaign)
        self.cluster.kill_daemon()
        time.sleep(1)
        self.cluster.start_node()
        self.finish("daemon", campaign)

    def test_the_node_dies_with_its_tasks_and_comes_back(self):
        campaign = self.start("node")
        self.half_way("node", campaign)
        tasks = processes_of(SCRATCH / "node_store", campaign.pid)
        self.assertGreater(len(tasks), 2)  # a task's run, its shell and the step daemon
        self.cluster.kill_node(tasks)
        self.cluster.wait_for_node("down")
        self.cluster.start_node()
        self.finish("node", campaign)
        self.assertIn("resumed at step", self.logs("node"))

    def test_interrupted_and_again(self):
        campaign = self.start("interrupted")
        self.half_way("interrupted", campaign)
        campaign.send_signal(signal.SIGTERM)
        out, err = campaign.communicate(timeout=support.SECONDS)
        self.assertEqual((campaign.returncode, out), (130, ""), err)
        self.assertEqual(self.queue(), "")
        outcomes = [json.loads(p.read_text())["outcome"] for p in (SCRATCH / "interrupted_store").glob("*/manifest.json")]
        self.assertIn("interrupted", outcomes)
        self.finish("interrupted", self.start("interrupted"))
        self.assertIn("resumed at step", self.logs("interrupted"))

    def test_the_campaign_is_killed_and_started_again(self):
        campaign = self.start("killed")
        self.half_way("killed", campaign)
        campaign.kill()
        campaign.communicate()
        self.assertNotEqual(self.queue(), "")
        self.finish("killed", self.start("killed"))
        self.assertEqual(list((SCRATCH / "killed_store/slurm").iterdir()), [])

    def test_a_confrontation_has_the_verdict_of_this_machine_alone(self):
        """Without its report: some twenty runs in three batches."""
        settings = ("--set", f"/slurm={json.dumps(SLURM)}", "--set", '/mechanisms=["frame_compliance"]', "--no-report", "--quiet",
                    "--set", '/without=["mesh_size","loading_rate","damping","plane_condition"]')

        def confront(name, *more):
            words = support.command("confront", CONFRONTATION, *settings, "--store", SCRATCH / f"{name}_store", "--out", SCRATCH / name, *more)
            result = subprocess.run(words, capture_output=True, text=True, timeout=support.SECONDS, cwd=SCRATCH, env=self.cluster.environment)
            self.assertEqual(result.returncode, 0, result.stderr + self.cluster.logs())
            return result.stdout

        self.assertIn(" 0 from the bank, 0 from the store,", confront("here", "--jobs", 2))
        self.assertIn(" 0 from the bank, 0 from the store,", confront("there", "--executor", "slurm"))
        self.assert_same_bytes(SCRATCH / "there", SCRATCH / "here", ["verdict.json"])

    def test_what_slurm_refuses_is_one_clear_error(self):
        result = subprocess.run(support.command(*arguments("refused", "--executor", "slurm", "--set", "/slurm/partition=none")),
                                capture_output=True, text=True, timeout=support.SECONDS, cwd=SCRATCH, env=self.cluster.environment)
        self.assertEqual((result.returncode, result.stdout), (3, ""))
        self.assertRegex(result.stderr, r"(?m)^error: /slurm: sbatch refuses the campaign: .*invalid partition")


if __name__ == "__main__":
    support.main()
