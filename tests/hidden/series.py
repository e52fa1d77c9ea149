"""The full set of hidden effects: series.py BINARY SOURCE --sets N --suite rich|poor --specimens 6|3 [--seed S].

Null data, every mechanism at its strong and half amplitude, pairs, and effects outside the library; drawn anew each time, the seed is
printed. Writes rows.jsonl while it goes (the same call goes on where it was ended); table.txt, summary.json and confusion.json (for
`asperity report --confusion`) at the end.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import shutil
import sys

import dataset
import laboratory
import scoring
from draw import stream
from effects import OUTSIDE, Effects
from generate import library
from pool import Pool
from verdicts import Confronter

AMPLITUDES = (1.0, 0.5)


def options(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("binary", type=pathlib.Path)
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("--sets", type=int, default=300, help="null data sets")
    parser.add_argument("--each", type=int, default=10, help="data sets of a mechanism at an amplitude, and of an effect outside")
    parser.add_argument("--pairs", type=int, default=30)
    parser.add_argument("--amplitudes", type=float, nargs="+", default=AMPLITUDES)
    parser.add_argument("--only", nargs="+", help="these mechanisms")
    parser.add_argument("--suite", choices=sorted(laboratory.SUITES), default="rich")
    parser.add_argument("--specimens", type=int, default=6)
    parser.add_argument("--blocks", type=int, default=3, help="blocks of rock an effect is in; eight times as many without one")
    parser.add_argument("--meshes", type=int, default=8, help="specimens of a test of a block, from which data sets take theirs")
    parser.add_argument("--alarm-level", type=float, help="of the confrontations; default theirs. Rates are told for each smaller one, too")
    parser.add_argument("--seed", help="default: drawn")
    parser.add_argument("--rocks", default="1", help="seed of blocks of rock and of specimens' meshes: another one needs runs of its own")
    parser.add_argument("--noise", type=float, default=1.0, help="factor on the instrument's errors, which the measured file states")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--pool", type=pathlib.Path)
    parser.add_argument("--store", type=pathlib.Path, help="of the confrontations' own runs; default SOURCE/outputs/hidden_store")
    parser.add_argument("--out", type=pathlib.Path, help="default SOURCE/outputs/hidden_series_SEED")
    parser.add_argument("--pool-only", action="store_true", help="makes the runs and ends")
    parser.add_argument("--decoys", type=pathlib.Path, help="an executable with entries that do nothing, and a duplicate")
    return parser.parse_args(arguments)


def experiments_of(suite):
    return [laboratory.TESTS[id].experiment for id in laboratory.SUITES[suite]]


def pairs(ids, count, rng):
    return [tuple(sorted(rng.sample(ids, 2))) for _ in range(count)]


def cases(o, acts_in):
    """(name, kind, effects, how many data sets)"""
    seen = [id for id in sorted(acts_in) if set(acts_in[id]) & set(experiments_of(o.suite)) and (not o.only or id in o.only)]
    all = [("null", "null", Effects(acts_in=acts_in), o.sets)]
    for amplitude in o.amplitudes:
        all += [(f"{id}@{amplitude:g}", f"amplitude {amplitude:g}", Effects(((id, amplitude),), None, acts_in), o.each) for id in seen]
    for two in pairs(seen, o.pairs if len(seen) > 1 else 0, stream(o.seed, "pairs")):
        all.append(("+".join(two), "pair", Effects(tuple((id, 1.0) for id in two), None, acts_in), 1))
    all += [(name, "outside", Effects((), name, acts_in), o.each) for name in sorted(OUTSIDE) if not o.only]
    return all


def plan_of(o, kind):
    """Null data have particles of the base's size: another size is an effect."""
    blocks = 8 * o.blocks if kind == "null" else 1 if kind == "pair" else o.blocks
    return dataset.Plan(o.suite, o.specimens, blocks, o.meshes, kind not in ("null", "outside"), o.rocks, o.noise)


def all_sets(o, acts_in):
    """Every data set of the series, in an order that tells nothing."""
    sets = []
    for name, kind, effects, count in cases(o, acts_in):
        plan = plan_of(o, kind)
        sets += [(name, kind, plan, dataset.draw_set(plan, effects, f"{o.seed}/{name}/{i}")) for i in range(count)]
    stream(o.seed, "order").shuffle(sets)
    return sets


def run_set(base, pool, confronter, plan, draw, work, settings=()):
    """Writes a data set, seals its truth, confronts, and opens the seal."""
    shutil.rmtree(work, ignore_errors=True)
    sealed = work / "sealed" / "truth.json"
    sha256 = dataset.seal(dataset.truth_of(base, plan, draw), sealed)
    measured = dataset.write_set(base, plan, draw, pool, work / "data")
    verdict = confronter.verdict(measured, work / "verdict", plan.suite, settings)
    truth = dataset.open_seal(sealed, sha256, work / "verdict" / "verdict.json")
    return {"sealed_sha256": sha256, **scoring.judge(truth, verdict), **scoring.gate_of(verdict), "gain": verdict.get("gain"),
            "detectable_amplitude": verdict.get("detectable_amplitude"), "truth": truth}


def by(rows, key):
    groups = {}
    for row in rows:
        groups.setdefault(row[key], []).append(row)
    return dict(sorted(groups.items()))


def summary(o, rows, decoys):
    return {"seed": o.seed, "suite": o.suite, "specimens": o.specimens, "sets": len(rows),
            "kinds": {kind: scoring.rates(of) for kind, of in by(rows, "kind").items()},
            "cases": {case: scoring.rates(of) for case, of in by(rows, "case").items()},
            "gain": {kind: scoring.gain_summary(of) for kind, of in by(rows, "kind").items()},
            "alarm_levels": scoring.by_alarm_level(rows), "foretold": scoring.foretold_rates(rows),
            "decoys_named": {d: sum(d in r["causes"] for r in rows) for d in decoys},
            "confusion": scoring.confusion(rows)}


def table(found):
    lines = [f"seed {found['seed']}, suite {found['suite']}, {found['specimens']} specimens, {found['sets']} data sets"]
    for part in ("kinds", "cases"):
        for name, rates in found[part].items():
            lines.append(f"{name:32}" + "".join(f"  {rate}: {scoring.rate_text(r)}" for rate, r in rates.items() if r["of"]))
    for level, rates in found["alarm_levels"].items():
        lines.append(f"alarm level {level:20}" + "".join(f"  {rate}: {scoring.rate_text(r)}" for rate, r in rates.items() if r["of"]))
    lines.append(f"{'as it was run':32}" + "".join(f"  {rate}: {scoring.rate_text(r)}" for rate, r in found["foretold"].items() if r["of"]))
    for kind, gain in found["gain"].items():
        if gain:
            lines.append(f"gain, {kind:26}" + "".join(f"  {name}: {value:.3g}" for name, value in gain.items()))
    return "\n".join(lines) + "\n"


def fill_pool(base, pool, sets):
    configs = [c for _, _, plan, draw in sets for c in dataset.needed_configs(base, plan, draw)]
    pool.fill(configs, lambda done, of: print(f"specimen {done} of {of}", file=sys.stderr, flush=True))


def run_series(o, base, pool, acts_in, out):
    """Verdicts side by side, rows in the sets' order; the first alone, since it makes the bank's golden runs."""
    binary = o.decoys or o.binary
    confronter = Confronter(binary.resolve(), o.source.resolve(), o.store or o.source / "outputs/hidden_store", 1)
    rows_path = out / "rows.jsonl"
    rows = [json.loads(line) for line in rows_path.read_text().splitlines()] if rows_path.exists() else []
    sets = all_sets(o, acts_in)
    settings = [("/alarm_level", o.alarm_level)] if o.alarm_level else []

    def row_of(index):
        name, kind, plan, draw = sets[index]
        return {"case": name, "kind": kind, **run_set(base, pool, confronter, plan, draw, out / f"set_{index:05}", settings)}

    def keep(row):
        rows.append(row)
        with rows_path.open("a") as file:
            file.write(json.dumps(row) + "\n")
        print(f"{len(rows)} of {len(sets)}: {row['status']} {' '.join(row['causes'])} ({row['case']})", file=sys.stderr, flush=True)

    if len(rows) < len(sets):
        keep(row_of(len(rows)))
    with concurrent.futures.ThreadPoolExecutor(o.jobs) as workers:
        for row in workers.map(row_of, range(len(rows), len(sets))):
            keep(row)
    return summary(o, rows, sorted(library(binary).keys() - acts_in.keys()))


def main(arguments):
    o = options(arguments)
    o.seed = o.seed or str(random.SystemRandom().randrange(10**9))
    print(f"seed {o.seed}", flush=True)
    base, acts_in = laboratory.read_base(o.source), library(o.binary)
    pool = Pool(o.binary.resolve(), o.pool or o.source / "outputs/hidden_pool", base, max(o.jobs, os.cpu_count() or 1))
    fill_pool(base, pool, all_sets(o, acts_in))
    if o.pool_only:
        return
    out = o.out or o.source / f"outputs/hidden_series_{o.seed}"
    out.mkdir(parents=True, exist_ok=True)
    found = run_series(o, base, pool, acts_in, out)
    dataset.write_json(out / "summary.json", found)
    seen = {case.split("@")[0] for case in found["confusion"]} & acts_in.keys()
    dataset.write_json(out / "confusion.json", scoring.confusion_matrix(found["confusion"], seen))
    (out / "table.txt").write_text(table(found))
    print(table(found), end="")


if __name__ == "__main__":
    main(sys.argv[1:])
