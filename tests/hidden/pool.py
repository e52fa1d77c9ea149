"""Simulated specimens, kept by what decides their result: the configuration, and the numbers this build computes.

A run is made once. Curves lie in FOLDER/BUILD/, where BUILD is the hash of a few tiny runs' curves: a build that computes other
numbers finds an empty pool, one that computes the same numbers all of it. A run that fails is a lost specimen, kept with its reason.
"""
import concurrent.futures
import csv
import gzip
import hashlib
import json
import shutil
import subprocess
import tempfile
import threading

from recording import curve_of_table, finite

RUN_SECONDS = 1800  # one specimen; the slowest takes half a minute on a busy core
NUMERICAL = 4       # exit code of a run that a guard stopped
DIGITS = 8          # kept of each number: below every instrument


class LostSpecimen(Exception):
    """The run of a specimen failed; what it says."""


def config_key(config):
    return hashlib.sha256(json.dumps(config, sort_keys=True).encode()).hexdigest()[:32]


def tiny(base, experiment, edge_mm):
    config = json.loads(json.dumps(base["bases"][experiment]))
    config["particles"]["edge_mm"] = edge_mm
    config["experiment"]["stop"] = {"shear_displacement_mm": 0.1} if experiment == "direct_shear" else {"axial_strain": 0.01}
    if experiment != "direct_shear":
        config["mechanisms"] = [{"type": "strength_scatter"}, {"type": "seating"}]
    return config


class Pool:
    def __init__(self, binary, folder, base, workers=2):
        self.binary, self.workers, self.stopping = binary, workers, threading.Event()
        self.root = folder
        self.root.mkdir(parents=True, exist_ok=True)
        self.folder = folder / self.build_hash(base)
        self.folder.mkdir(exist_ok=True)

    def build_hash(self, base):
        sizes = {"uniaxial": 10, "triaxial": 10, "brazilian": 10, "direct_shear": 1.6}
        curves = [self.simulate(tiny(base, experiment, edge)) for experiment, edge in sizes.items()]
        return hashlib.sha256(json.dumps(curves).encode()).hexdigest()[:16]

    def simulate(self, config):
        """Runs a configuration; the columns of its curve."""
        with tempfile.TemporaryDirectory(dir=self.root, prefix="run_") as work:
            path = f"{work}/specimen.json"
            with open(path, "w") as file:
                json.dump(config, file)
            call = [str(self.binary), "run", path, "--no-render", "--quiet", "--threads", "1", "--out", f"{work}/out"]
            result = subprocess.run(call, capture_output=True, text=True, timeout=RUN_SECONDS)
            if result.returncode == NUMERICAL:
                raise LostSpecimen(result.stderr.strip())
            if result.returncode != 0:
                raise RuntimeError(f"a specimen's run ended with exit code {result.returncode}: {result.stderr.strip()}")
            with open(f"{work}/out/curves.csv") as file:
                curve = curve_of_table(list(csv.DictReader(file)), config["experiment"]["type"])
        if not finite(curve):
            raise LostSpecimen("a value of the curve is not finite")
        return {name: [float(f"{v:.{DIGITS}g}") for v in values] for name, values in curve.items()}

    def place(self, config):
        return self.folder / f"{config_key(config)}.json.gz"

    def keep(self, config):
        """Runs a configuration that is not there yet; the pool holds its curve, or why there is none."""
        place = self.place(config)
        if place.exists() or self.stopping.is_set():
            return
        try:
            entry = {"curve": self.simulate(config)}
        except LostSpecimen as lost:
            entry = {"lost": str(lost)}
        with tempfile.NamedTemporaryFile(dir=self.root, prefix="entry_", delete=False) as file:
            file.write(gzip.compress(json.dumps(entry).encode(), mtime=0))
        shutil.move(file.name, place)

    def fill(self, configs, tell=None):
        """Makes the runs that are missing, several at a time. Interrupted, those in work end and the rest stays to be made."""
        missing = list({config_key(c): c for c in configs if not self.place(c).exists()}.values())
        with concurrent.futures.ThreadPoolExecutor(self.workers) as workers:
            try:
                for done, _ in enumerate(workers.map(self.keep, missing), 1):
                    if tell:
                        tell(done, len(missing))
            except KeyboardInterrupt:
                self.stopping.set()
                raise
        return len(missing)

    def curve(self, config):
        """The curve of a configuration, run now if it has to be."""
        self.keep(config)
        entry = json.loads(gzip.decompress(self.place(config).read_bytes()))
        if "lost" in entry:
            raise LostSpecimen(entry["lost"])
        return entry["curve"]
