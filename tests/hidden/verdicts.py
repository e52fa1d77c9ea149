"""Calls `asperity confront` on a generated file and reads what it found."""
import hashlib
import json
import subprocess

STATUSES = ("nothing_found", "named", "indistinguishable", "two_causes", "unexplained")


class Confronter:
    def __init__(self, binary, source, store, jobs=2, seconds=3600):
        self.binary, self.jobs, self.seconds = binary, jobs, seconds
        self.config = source / "configs/confrontation/laboratory.json"
        self.store = store

    def call(self, measured, out, suite, settings=()):
        """`settings`: pairs of a JSON pointer and a value, laid over the configuration."""
        pairs = [("/measured", str(measured.resolve())), *([("/tests", {})] if suite == "poor" else []), *settings]
        sets = [part for pointer, value in pairs for part in ("--set", f"{pointer}={json.dumps(value)}")]
        return [str(self.binary), "confront", str(self.config), *sets, "--no-report", "--jobs", str(self.jobs),
                "--store", str(self.store), "--out", str(out)]

    def verdict(self, measured, out, suite, settings=(), flags=()):
        """Runs the confrontation; its verdict.json, parsed."""
        result = subprocess.run([*self.call(measured, out, suite, settings), *flags], capture_output=True, text=True, timeout=self.seconds)
        if result.returncode != 0:
            raise RuntimeError(f"confront ended with exit code {result.returncode}: {result.stderr[-2000:]}")
        verdict = json.loads((out / "verdict.json").read_text())
        if verdict["status"] not in STATUSES:
            raise RuntimeError(f"unknown status {verdict['status']}")
        return verdict


def bytes_of(out):
    """Hash of a verdict as it was written."""
    return hashlib.sha256((out / "verdict.json").read_bytes()).hexdigest()
