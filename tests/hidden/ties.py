"""Whether the tests that verdicts ask for part their ties: ties.py --series FOLDER [--most N], then what series.py was called with.

Of the ties of that series that hold the truth, each again with `--next-tests`: the first test of the verdict's list that this laboratory
can make (same rock, same effect, meshes of its own) is laid beside the data, and the whole confronted anew, up to three times. The truth
has no say in which. Writes ties.jsonl and ties.txt into FOLDER.
"""
import argparse
import copy
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

MOST_TESTS = 3
TOOL_LEVEL = 0.02  # default of alarm_level


def further(parent, **keys):
    keys = parent.keys | keys
    pointers = {f"/experiment/{name}": value for name, value in keys.items() if name not in laboratory.PREPARATION}
    return LabTest("N", parent.experiment, keys, pointers)


def settings_of(base, parent, design):
    """What the virtual test has beyond its measured file."""
    run = base["bases"][parent.experiment]
    if design == "slower_rate":
        return {"/experiment/loading/closing_rate_mm_per_s": 0.25 * run["experiment"]["loading"]["closing_rate_mm_per_s"]}
    if design == "unload_reload":
        length = parent.keys.get("height_mm", parent.keys.get("diameter_mm"))
        return {"/experiment/loading/unloading": [{"at_mm": 0.3 * run["experiment"]["stop"]["axial_strain"] * length, "stress_ratio": 0.1}]}
    return {}


# What the laboratory can make of a test it has made. It has no joint that is held by springs, and no second dilation gauge.
CHANGES = {
    "lubricated_platens": lambda keys: {"lubricated_platens": True},
    "rotated_core": lambda keys: {"core_angle_deg": 90},
    "height_over_width_1": lambda keys: {"height_mm": keys["width_mm"]},
    "height_over_width_3": lambda keys: {"height_mm": 3 * keys["width_mm"]},
    "half_size": lambda keys: {"width_mm": 0.5 * keys["width_mm"], "height_mm": 0.5 * keys["height_mm"]},
    "twice_confining_pressure": lambda keys: {"confining_pressure_mpa": 2 * keys["confining_pressure_mpa"]},
    "slower_rate": lambda keys: {},
    "unload_reload": lambda keys: {},
}


def further_test(base, made, entry, settings_of_parent):
    """The further test that a verdict asks for, and its settings, with those of the test it is made like. `made`: the laboratory's tests by id."""
    parent = made[entry["changes"]]
    test = further(parent, **CHANGES[entry["id"]](parent.keys))
    settings = settings_of_parent | settings_of(base, parent, entry["id"])
    return dataclasses.replace(test, pointers=test.pointers | settings), settings


def chosen_design(verdict):
    """The first of the verdict's list that the laboratory can make, with what it promises."""
    return next((entry for entry in verdict["next_tests"] if entry["id"] in CHANGES), None)


def with_the_test(base, pool, plan, draw, path, folder, test):
    """The data set with a further test: a copy, the new table beside it."""
    shutil.copytree(path.parent, folder)
    table = f"{test.id}.csv"
    (folder / table).write_text(dataset.record_test(base, plan, draw, pool, test))
    measured = json.loads(path.read_text())
    measured["tests"].append({"id": test.id, "experiment": test.experiment, **test.keys, "curve": table, "use": "fit"})
    path = folder / path.name
    dataset.write_json(path, measured)
    dataset.say_what_did_not_fail(pool.binary, path, measured)
    return path


def fits_of(verdict, causes):
    """How well the causes of the tie fit now, and by what they are kept or refuted."""
    keys = ("misfit", "p_misfit", "p_excess", "kept")
    return {c["id"]: {key: c[key] for key in keys} for c in verdict["candidates"] if c["id"] in causes}


def settle(base, pool, confronter, plan, draw, row, work):
    """Of one tie: the tests asked for one after the other, and the verdicts with them."""
    shutil.rmtree(work, ignore_errors=True)
    path = dataset.write_set(base, plan, draw, pool, work / "data")
    settings = {} if plan.suite == "poor" else copy.deepcopy(base["tests"])
    verdict = confronter.verdict(path, work / "asked", plan.suite, flags=("--next-tests",))
    made = {id: laboratory.TESTS[id] for id in laboratory.SUITES[plan.suite]}
    result = {"case": row["case"], "tie": verdict["causes"], "rounds": []}
    for number in range(1, MOST_TESTS + 1):
        entry = chosen_design(verdict)
        if entry is None:
            break
        test, own = further_test(base, made, entry, settings.get(entry["changes"], {}).get("set", {}))
        test = made[f"N{number}"] = dataclasses.replace(test, id=f"N{number}")
        settings[test.id] = {"set": own}
        path = with_the_test(base, pool, plan, draw, path, work / f"with{number}", test)
        verdict = confronter.verdict(path, work / f"settled{number}", plan.suite, [("/tests", settings)], flags=("--next-tests",))
        judged = scoring.judge(dataset.truth_of(base, plan, draw), verdict)
        result["rounds"].append({"asked": entry, "status": verdict["status"], "causes": verdict["causes"], "in_set": judged["in_set"],
                                 "wrong_single": judged["wrong_single"], "fits": fits_of(verdict, result["tie"])})
    return result


def is_named(result, rounds):
    """Whether the truth alone was named after so many tests or fewer."""
    return any(r["status"] == "named" and r["in_set"] for r in result["rounds"][:rounds])


def is_parted(result):
    """Whether the first test left the truth and refuted one of the two that it was to part."""
    first = result["rounds"][0]
    return first["in_set"] and not set(first["asked"]["separates"]) <= set(first["causes"])


def spread(ties, most):
    """Ties of as many hidden mechanisms as there are, at most so many."""
    groups = {}
    for tie in ties:
        groups.setdefault(tie[1]["case"], []).append(tie)
    order = []
    while any(groups.values()) and len(order) < most:
        order += [group.pop(0) for group in groups.values() if group]
    return order[:most]


def line_of(result):
    rounds = [f" -> {r['asked']['id']} ({r['asked']['probability_correct']:.1%}): {r['status']} {' '.join(r['causes'])}" for r in result["rounds"]]
    return f"{result['case']:20} {' '.join(result['tie'])}{''.join(rounds) or ': no test that the laboratory can make'}"


def text_of(results):
    asked = [r for r in results if r["rounds"]]
    rates = {"first test parts its two": is_parted, "truth alone after one test": lambda r: is_named(r, 1),
             f"truth alone after at most {MOST_TESTS}": lambda r: is_named(r, MOST_TESTS),
             "wrong single name at the end": lambda r: r["rounds"][-1]["wrong_single"]}
    told = [f"{what}: {scoring.rate_text(scoring.rate([{'hit': of(r)} for r in asked], 'hit', lambda r: True))}" for what, of in rates.items()]
    return "\n".join([*map(line_of, results), *told]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--most", type=int, default=10, help="ties")
    parser.add_argument("--series", type=pathlib.Path, required=True, help="folder of the series, whose other options follow")
    own, rest = parser.parse_known_args()
    o = series.options([*rest, "--out", str(own.series)])
    base, acts_in = laboratory.read_base(o.source), series.library(o.binary)
    pool = Pool(o.binary.resolve(), o.pool or o.source / "outputs/hidden_pool", base, o.jobs)
    confronter = Confronter(o.binary.resolve(), o.source.resolve(), o.store or o.source / "outputs/hidden_store", o.jobs)
    rows = [scoring.at_alarm_level(json.loads(line), TOOL_LEVEL) for line in (own.series / "rows.jsonl").read_text().splitlines()]
    ties = [(s, row) for s, row in zip(series.all_sets(o, acts_in), rows) if row["status"] == "indistinguishable" and row["in_set"]]
    place, results = own.series / "ties.jsonl", []
    for (_, _, plan, draw), row in spread(ties, own.most):
        results.append(settle(base, pool, confronter, plan, draw, row, own.series / "tie"))
        place.write_text("".join(json.dumps(r) + "\n" for r in results))
        print(line_of(results[-1]), flush=True)
    (own.series / "ties.txt").write_text(text_of(results))
    print(text_of(results), end="")


if __name__ == "__main__":
    main()
