"""Whether a cause that the library lacks gets another's name: removed.py --series FOLDER, then what series.py was called with.

Every data set of that series in which a mechanism was hidden and something was seen, again with that mechanism taken out of the library.
Right is `unexplained`, nothing found, or a name whose fingerprint is the missing one's twin: a cosine beyond 0.9 in the verdict of
the whole library. Rocks with particles of another size have a second cause and are left out. Writes removed.jsonl and removed.txt
into FOLDER.
"""
import argparse
import concurrent.futures
import json
import pathlib
import shutil

import scoring
import series
from verdicts import Confronter

TWIN_COSINE = 0.9
ANSWERS = ("nothing_found", "unexplained", "named a twin", "named another", "two_causes", "a tie with a twin", "a tie without one")


def cosine_with(verdict, hidden, other):
    """Of two fingerprints after calibration; nothing where one of the two was no candidate."""
    return next((abs(c["cosine"]) for c in verdict["cosines"] if set(c["ids"]) == {hidden, other}), None)


def answer(verdict, cosines):
    """`cosines`: of each of the verdict's causes with the missing one, in their order."""
    twin = any(c is not None and c > TWIN_COSINE for c in cosines)
    if verdict["status"] == "named":
        return "named a twin" if twin else "named another"
    if verdict["status"] == "indistinguishable":
        return "a tie with a twin" if twin else "a tie without one"
    return verdict["status"]


def confronted_without(confronter, suite, folder, hidden, settings):
    whole = json.loads((folder / "verdict" / "verdict.json").read_text())
    measured = next((folder / "data").glob("D*.json"))
    shutil.rmtree(folder / "removed", ignore_errors=True)
    verdict = confronter.verdict(measured, folder / "removed", suite, [*settings, ("/without", [hidden])])
    if hidden in verdict["causes"]:
        raise RuntimeError(f"{folder} names {hidden}, which its library did not have")
    cosines = [cosine_with(whole, hidden, cause) for cause in verdict["causes"]]
    return {"hidden": hidden, "status": verdict["status"], "causes": verdict["causes"],
            "cosines": cosines, "answer": answer(verdict, cosines)}


def text_of(results):
    rows = [r | {"hit": r["answer"] == a, "as": a} for a in ANSWERS for r in results]
    lines = [f"{a:20} {scoring.rate_text(scoring.rate([r for r in rows if r['as'] == a], 'hit', lambda r: True))}" for a in ANSWERS]
    others = [f"{r['hidden']}: {' '.join(r['causes'])} ({', '.join('-' if c is None else f'{c:.2f}' for c in r['cosines'])})"
              for r in results if r["answer"] == "named another"]
    return "\n".join([*lines, *others]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--series", type=pathlib.Path, required=True, help="folder of the series, whose other options follow")
    own, rest = parser.parse_known_args()
    o = series.options([*rest, "--out", str(own.series)])
    confronter = Confronter(o.binary.resolve(), o.source.resolve(), o.store or o.source / "outputs/hidden_store", 1)
    rows = [json.loads(line) for line in (own.series / "rows.jsonl").read_text().splitlines()]
    settings = [("/alarm_level", o.alarm_level)] if o.alarm_level else []
    rows = [scoring.at_alarm_level(row, o.alarm_level) if o.alarm_level else row for row in rows]
    seen = [(own.series / f"set_{i:05}", row["truth"]["mechanisms"][0][0]) for i, row in enumerate(rows)
            if row["detected"] and len(row["truth"]["mechanisms"]) == 1 and row["truth"]["edge_factor"] == 1.0]
    results = []
    with concurrent.futures.ThreadPoolExecutor(o.jobs) as workers, (own.series / "removed.jsonl").open("w") as file:
        for result in workers.map(lambda s: confronted_without(confronter, o.suite, *s, settings), seen):
            results.append(result)
            file.write(json.dumps(result) + "\n")
            print(f"{len(results)} of {len(seen)}: {result['answer']} {' '.join(result['causes'])} ({result['hidden']})", flush=True)
    (own.series / "removed.txt").write_text(text_of(results))
    print(text_of(results), end="")


if __name__ == "__main__":
    main()
