"""A real Slurm with one node on loopback, for one test: its own configuration, ports and folders, stopped by its pid files."""
import os
import pathlib
import pwd
import shutil
import signal
import socket
import subprocess
import tempfile
import time

PROGRAMS = ["munged", "munge", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol", "sinfo"]
HOST = socket.gethostname().split(".")[0]
SECONDS = 30  # for a daemon to come up or go down; it takes about three
SYSTEM_PATH = "/usr/sbin:/usr/bin:/sbin:/bin"
CGROUPS = "CgroupPlugin=cgroup/v1\n"  # named, so that none is looked for: a container may have none mounted
CONFIGURATION = """
ClusterName=asperity_test
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={munge}/socket
CryptoType=crypto/munge
SlurmctldPort={controller_port}
SlurmdPort={node_port}
StateSaveLocation={root}/state
SlurmdSpoolDir={root}/spool
SlurmctldPidFile={root}/slurmctld.pid
SlurmdPidFile={root}/slurmd.pid
SlurmctldLogFile={root}/slurmctld.log
SlurmdLogFile={root}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MailProg=/bin/true
ReturnToService=2
SlurmdParameters=config_overrides
SlurmdTimeout=30
SchedulerParameters=sched_min_interval=100000,batch_sched_delay=0
KillWait=10
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 RealMemory=1000 State=UNKNOWN
PartitionName=test Nodes={host} Default=YES MaxTime=60 State=UP
"""


def missing():
    """Why there can be no cluster here; empty if there can."""
    lost = [p for p in PROGRAMS if shutil.which(p, path=SYSTEM_PATH) is None]
    if lost:
        return f"no {', '.join(lost)}: install what app/packages.txt lists (slurm-wlm, munge)"
    return "" if os.geteuid() == 0 else "Slurm's daemons need root: run the tests as root, as in a container"


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


def runs(pid, name):
    """Whether the process is at work and is a program of this name: the number of one that has ended may soon be another's."""
    try:
        program, state = pathlib.Path(f"/proc/{pid}/stat").read_text().split("(", 1)[1].rsplit(")", 1)
        return program == name and state.split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


class Cluster:
    """With `with`: up on entering, down on leaving. `environment` is what Slurm's commands need."""

    def __init__(self, root, environment):
        self.root = pathlib.Path(root)
        self.root.mkdir(parents=True)
        self.munge = pathlib.Path(tempfile.mkdtemp(prefix="asperity_munge_"))  # a socket's path must be short
        self.environment = {**environment, "SLURM_CONF": str(self.root / "slurm.conf"),
                            "PATH": f"{SYSTEM_PATH}:{environment.get('PATH', '')}"}

    def __enter__(self):
        try:
            self._start_munge()
            self._start_slurm()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for name in ("slurmd", "slurmctld", "munged"):
            self.stop(name)
        shutil.rmtree(self.munge, ignore_errors=True)

    def command(self, *words, check=True):
        return subprocess.run(list(map(str, words)), capture_output=True, text=True, timeout=SECONDS, env=self.environment, check=check)

    def _start_munge(self):
        """Of its own key and socket, so that one that the machine may run is left alone."""
        user = pwd.getpwnam("munge")
        folder = self.munge
        (folder / "key").write_bytes(os.urandom(128))
        (folder / "key").chmod(0o400)
        folder.chmod(0o711)
        for path in (folder, folder / "key"):
            os.chown(path, user.pw_uid, user.pw_gid)
        self.command("runuser", "-u", "munge", "--", "munged", f"--socket={folder}/socket", f"--key-file={folder}/key",
                     f"--pid-file={folder}/munged.pid", f"--log-file={folder}/log", f"--seed-file={folder}/seed", "--force")

    def _start_slurm(self):
        for name in ("state", "spool"):
            (self.root / name).mkdir()
        (self.root / "slurm.conf").write_text(CONFIGURATION.format(
            host=HOST, root=self.root, munge=self.munge, controller_port=free_port(), node_port=free_port()))
        (self.root / "cgroup.conf").write_text(CGROUPS)
        self.command("slurmctld", "-f", self.root / "slurm.conf")
        self.start_node()

    def wait_for_node(self, *states):
        """Waits until the controller sees the node in one of the states; a trailing * is a node that does not answer."""
        begin = time.monotonic()
        while self.command("sinfo", "--noheader", "--format=%t", check=False).stdout.strip().rstrip("*") not in states:
            assert time.monotonic() - begin < SECONDS, f"the node is not {states}:\n" + self.logs()
            time.sleep(0.2)

    def start_node(self):
        """Starts the compute daemon and waits until the node takes jobs."""
        self.command("slurmd", "-f", self.root / "slurm.conf")
        self.wait_for_node("idle", "mix", "alloc")

    def pid(self, name):
        path = (self.munge if name == "munged" else self.root) / f"{name}.pid"
        return int(path.read_text()) if path.exists() else None

    def stop(self, name, with_signal=signal.SIGTERM):
        pid = self.pid(name)
        if pid is None or not runs(pid, name):
            return
        os.kill(pid, with_signal)
        begin = time.monotonic()
        while runs(pid, name) and time.monotonic() - begin < SECONDS:
            time.sleep(0.05)

    def kill_daemon(self):
        """The compute daemon dies; tasks live on under their step daemons."""
        self.stop("slurmd", signal.SIGKILL)

    def kill_node(self, tasks):
        """The node dies: its compute daemon and these processes, by number with their names. A health check tells the controller, which
        would take half a minute to see it by itself."""
        self.kill_daemon()
        for pid, name in tasks.items():
            if runs(pid, name):
                os.kill(pid, signal.SIGKILL)
        self.command("scontrol", "update", f"NodeName={HOST}", "State=DOWN", "Reason=died")

    def logs(self):
        return "\n".join(p.read_text(errors="replace")[-3000:] for p in self.root.glob("*.log"))
