"""Whether the test that a verdict asks for parts its tie: ties.py --series FOLDER [--most N], then what series.py was called with.

Of the ties of that series that hold the truth, each again with `--next-tests`: the first test of the verdict's list that a measured
file can tell is made by the same laboratory (same rock, same effect, meshes of its own), laid beside the data, and the whole confronted
anew. The truth has no say in which. Writes ties.jsonl and ties.txt into FOLDER.
"""
import argparse
import dataclasses
import json
import pathlib
import shutil

import dataset
import laboratory
import scoring
import series
from laboratory import LabTest
from pool import Pool
from verdicts import Confronter

NEW = "N"  # id of the further test
ADDED = "added.csv"


def further(parent, **keys):
    keys = parent.keys | keys
    return LabTest(NEW, parent.experiment, keys, {f"/experiment/{name}": value for name, value in keys.items()})


def settings_of(base, parent, design):
    """What the virtual test has beyond its measured file."""
    run = base["bases"][parent.experiment]
    if design == "slower_rate":
        return {"/experiment/loading/closing_rate_mm_per_s": 0.25 * run["experiment"]["loading"]["closing_rate_mm_per_s"]}
    if design == "unload_reload":
        length = parent.keys.get("height_mm", parent.keys.get("diameter_mm"))
        return {"/experiment/loading/unloading": [{"at_mm": 0.3 * run["experiment"]["stop"]["axial_strain"] * length, "stress_ratio": 0.1}]}
    return {}


def first_of(suite, experiment):
    return next((laboratory.TESTS[id] for id in laboratory.SUITES[suite] if laboratory.TESTS[id].experiment == experiment), None)


def further_test(base, suite, design):
    """The design as a test of this laboratory, and its settings; None for one that a measured file cannot tell."""
    uniaxial = first_of(suite, "uniaxial")
    tests = {
        "height_over_width_1": lambda: further(uniaxial, height_mm=uniaxial.keys["width_mm"]),
        "height_over_width_3": lambda: further(uniaxial, height_mm=3 * uniaxial.keys["width_mm"]),
        "half_size": lambda: further(uniaxial, width_mm=0.5 * uniaxial.keys["width_mm"], height_mm=0.5 * uniaxial.keys["height_mm"]),
        "slower_rate": lambda: further(uniaxial),
        "unload_reload": lambda: further(laboratory.TESTS[laboratory.SUITES[suite][0]]),
        "twice_confining_pressure": lambda: further(highest(suite), confining_pressure_mpa=2 * highest(suite).keys["confining_pressure_mpa"]),
    }
    if design not in tests:
        return None
    test = tests[design]()
    settings = settings_of(base, test, design)
    return dataclasses.replace(test, pointers=test.pointers | settings), settings


def highest(suite):
    triaxial = [laboratory.TESTS[id] for id in laboratory.SUITES[suite] if laboratory.TESTS[id].experiment == "triaxial"]
    return max(triaxial, key=lambda test: test.keys["confining_pressure_mpa"])


def chosen_design(base, suite, verdict):
    """The first of the verdict's list that a measured file can tell, with what it promises."""
    return next((entry for entry in verdict["next_tests"] if further_test(base, suite, entry["id"])), None)


def with_the_test(base, pool, plan, draw, data, folder, test):
    """The data set with a further test: a copy, the new table beside it."""
    shutil.copytree(data.parent, folder)
    table = dataset.record_test(base, plan, draw, pool, test)
    (folder / ADDED).write_text(table)
    measured = json.loads(data.read_text())
    measured["tests"].append({"id": NEW, "experiment": test.experiment, **test.keys, "curve": ADDED, "use": "fit"})
    path = folder / data.name
    dataset.write_json(path, measured)
    dataset.say_what_did_not_fail(pool.binary, path, measured)
    return path


def settle(base, pool, confronter, plan, draw, row, work):
    """Of one tie: the test asked for, and the verdict with it."""
    shutil.rmtree(work, ignore_errors=True)
    data = dataset.write_set(base, plan, draw, pool, work / "data")
    asked = confronter.verdict(data, work / "asked", plan.suite, flags=("--next-tests",))
    entry = chosen_design(base, plan.suite, asked)
    first = asked["next_tests"][0] if asked["next_tests"] else None
    result = {"case": row["case"], "tie": asked["causes"], "first": first, "asked": entry}
    if entry is None:
        return result | {"status": None, "causes": [], "resolved": False}
    test, settings = further_test(base, plan.suite, entry["id"])
    path = with_the_test(base, pool, plan, draw, data, work / "with", test)
    own = {} if plan.suite == "poor" else base["tests"]
    verdict = confronter.verdict(path, work / "settled", plan.suite, [("/tests", own | {NEW: {"set": settings}})])
    judged = scoring.judge(dataset.truth_of(base, plan, draw), verdict)
    return result | {"status": verdict["status"], "causes": verdict["causes"],
                     "resolved": verdict["status"] == "named" and judged["in_set"], "wrong_single": judged["wrong_single"]}


def spread(ties, most):
    """Ties of as many hidden mechanisms as there are, at most so many."""
    groups = {}
    for tie in ties:
        groups.setdefault(tie[1]["case"], []).append(tie)
    order = []
    while any(groups.values()) and len(order) < most:
        order += [group.pop(0) for group in groups.values() if group]
    return order[:most]


def text_of(results):
    asked = [r for r in results if r["asked"]]
    lines = [f"{r['case']:28} {' '.join(r['tie'])}: {r['asked']['id'] if r['asked'] else 'no test of a measured file'}"
             f" -> {r['status']} {' '.join(r['causes'])}" for r in results]
    resolved = scoring.rate([r | {"hit": r["resolved"]} for r in asked], "hit", lambda r: True)
    return "\n".join([*lines, f"resolved: {scoring.rate_text(resolved)}"]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--most", type=int, default=10, help="ties")
    parser.add_argument("--series", type=pathlib.Path, required=True, help="folder of the series, whose other options follow")
    own, rest = parser.parse_known_args()
    o = series.options([*rest, "--out", str(own.series)])
    base, acts_in = laboratory.read_base(o.source), series.library(o.binary)
    pool = Pool(o.binary.resolve(), o.pool or o.source / "outputs/hidden_pool", base, o.jobs)
    confronter = Confronter(o.binary.resolve(), o.source.resolve(), o.store or o.source / "outputs/hidden_store", o.jobs)
    rows = [json.loads(line) for line in (own.series / "rows.jsonl").read_text().splitlines()]
    ties = [(s, row) for s, row in zip(series.all_sets(o, acts_in), rows) if row["status"] == "indistinguishable" and row["in_set"]]
    place, results = own.series / "ties.jsonl", []
    for (_, _, plan, draw), row in spread(ties, own.most):
        results.append(settle(base, pool, confronter, plan, draw, row, own.series / "tie"))
        place.write_text("".join(json.dumps(r) + "\n" for r in results))
        print(text_of(results[-1:]), end="", flush=True)
    (own.series / "ties.txt").write_text(text_of(results))
    print(text_of(results), end="")


if __name__ == "__main__":
    main()
