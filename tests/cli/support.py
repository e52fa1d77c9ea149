"""What the command line tests share. A test is called with: the executable, the source root, a scratch folder."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

BINARY, SOURCE, SCRATCH = (pathlib.Path(a).resolve() for a in sys.argv[1:4])
TINY = pathlib.Path(__file__).resolve().parent / "tiny_disc.json"
SECONDS = 60  # one call; the slowest takes some 5 s on a slow core, so only a hang gets here


def environment():
    """Neither a display nor anything else that would help a picture along."""
    return {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY", "XAUTHORITY")}


def command(*arguments):
    return [str(BINARY), *map(str, arguments)]


def asperity(*arguments):
    """Runs the executable in the scratch folder; stdout, stderr and returncode as subprocess gives them."""
    return subprocess.run(command(*arguments), capture_output=True, text=True, timeout=SECONDS, cwd=SCRATCH, env=environment())


def commands():
    """Every command, as `asperity --help` lists them."""
    return re.findall(r"(?m)^  ([a-z]+) ", asperity("--help").stdout.split("\nSubcommands:\n")[1].split("\n\n")[0])


def settings(**values):
    """--set options from names like particles__edge_mm."""
    return [part for name, value in values.items() for part in ("--set", f"/{name.replace('__', '/')}={value}")]


def listing(folder):
    """Every path below a folder with its size and time of change: equal listings mean that nothing was touched."""
    return {str(p.relative_to(folder)): (p.stat().st_size, p.stat().st_mtime_ns) for p in sorted(folder.rglob("*"))}


def result_files(folder):
    """What two runs of one configuration have the same bytes of, relative to the folder: tables, series, pictures."""
    kinds = (".csv", ".pvd", ".vtu", ".png", ".jpg")
    return sorted(p.relative_to(folder) for p in folder.rglob("*") if p.suffix in kinds)


def assert_series_whole(test, folder):
    """Every file that a .pvd of the run names can be read to its end; names of the series there are."""
    there = [s for s in ("fields", "cracks", "contacts") if (folder / f"{s}.pvd").exists()]
    for series in there:
        for entry in ElementTree.parse(folder / f"{series}.pvd").iter("DataSet"):
            test.assertTrue((folder / entry.get("file")).read_bytes().rstrip().endswith(b"</VTKFile>"), entry.get("file"))
    return there


class CommandLineTest(unittest.TestCase):
    maxDiff = None

    def succeed(self, *arguments):
        result = asperity(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def fail_with(self, code, *arguments):
        """Runs, expects the exit code, nothing on stdout, and returns stderr."""
        result = asperity(*arguments)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stdout, "")
        return result.stderr

    def assert_same_bytes(self, one, other, names):
        for name in names:
            self.assertEqual((one / name).read_bytes(), (other / name).read_bytes(), f"{name} of {one.name} and {other.name}")


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
