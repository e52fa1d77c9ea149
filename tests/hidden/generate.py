"""Writes one data set that hides an effect: generate.py BINARY SOURCE --out DIR --truth FILE [--effect ID=AMPLITUDE]... [--outside NAME]"""
import argparse
import json
import pathlib
import subprocess
import sys

import dataset
import laboratory
from effects import OUTSIDE, Effects
from pool import Pool


def library(binary):
    """id -> experiments in which it acts, of every mechanism that the executable knows."""
    text = subprocess.run([str(binary), "mechanisms", "--json"], capture_output=True, text=True, check=True).stdout
    return {m["id"]: tuple(m["acts_in"]) for m in json.loads(text)}


def effect(text):
    id, _, amplitude = text.partition("=")
    return id, float(amplitude or 1.0)


def options(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("binary", type=pathlib.Path)
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--truth", type=pathlib.Path, required=True, help="sealed; outside the data's folder")
    parser.add_argument("--pool", type=pathlib.Path, help="default SOURCE/outputs/hidden_pool")
    parser.add_argument("--suite", choices=sorted(laboratory.SUITES), default="rich")
    parser.add_argument("--specimens", type=int, default=6)
    parser.add_argument("--effect", type=effect, action="append", default=[], metavar="ID=AMPLITUDE")
    parser.add_argument("--outside", choices=sorted(OUTSIDE))
    parser.add_argument("--other-edges", action="store_true", help="one block in four has particles of another size")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--seed", default="1")
    return parser.parse_args(arguments)


def main(arguments):
    o = options(arguments)
    base = laboratory.read_base(o.source)
    pool = Pool(o.binary.resolve(), o.pool or o.source / "outputs/hidden_pool", base, o.workers)
    plan = dataset.Plan(o.suite, o.specimens, other_edges=o.other_edges)
    draw = dataset.draw_set(plan, Effects(tuple(o.effect), o.outside, library(o.binary)), o.seed)
    pool.fill(dataset.needed_configs(base, plan, draw), lambda done, of: print(f"{done} of {of} specimens", file=sys.stderr))
    print(dataset.seal(dataset.truth_of(base, plan, draw), o.truth))
    print(dataset.write_set(base, plan, draw, pool, o.out))


if __name__ == "__main__":
    main(sys.argv[1:])
