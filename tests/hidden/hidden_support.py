"""What the tests of hidden effects share. A test is called with: the executable, the source root, a scratch folder."""
import pathlib
import shutil
import subprocess
import sys
import unittest

import laboratory
from generate import library

BINARY, SOURCE, SCRATCH = (pathlib.Path(a).resolve() for a in sys.argv[1:4])
BASE = laboratory.read_base(SOURCE)
LIBRARY = library(BINARY)


def asperity(*arguments):
    return subprocess.run([str(BINARY), *map(str, arguments)], capture_output=True, text=True)


def bytes_below(folder):
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
