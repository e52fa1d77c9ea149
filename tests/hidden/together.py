"""Rates of several series of one suite together: together.py FOLDER... [--alarm-level 0.02] [--confusion FILE].

FOLDER is a series' own, with rows.jsonl; the level is at most the one that they were run at. By kind of data set and by what is hidden, for
effects also by whether the rock has the base's particles or others, which is a second effect. FILE is for `asperity report --confusion`.
"""
import argparse
import json
import pathlib

import dataset
import scoring


def groups_of(rows):
    """Named groups of judged rows."""
    groups = {}
    for row in rows:
        names = {row["kind"], row["case"]}
        if scoring.is_effect(row):
            particles = "the base's" if row["truth"]["edge_factor"] == 1.0 else "other"
            names |= {f"{name}, {particles} particles" for name in names}
        for name in names:
            groups.setdefault(name, []).append(row)
    return groups


def text_of(rows):
    lines = []
    for name, group in sorted(groups_of(rows).items()):
        lines += [f"{name}, {rate}: {scoring.rate_text(r)}" for rate, r in scoring.rates(group).items() if r["of"]]
        gain = scoring.gain_summary(group)
        lines += [f"{name}, gain, {of}: {value:.3g}" for of, value in (gain or {}).items()]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("series", type=pathlib.Path, nargs="+")
    parser.add_argument("--alarm-level", type=float, default=0.02)
    parser.add_argument("--confusion", type=pathlib.Path)
    o = parser.parse_args()
    lines = [line for folder in o.series for line in (folder / "rows.jsonl").read_text().splitlines()]
    as_run = [json.loads(line) for line in lines]
    rows = [scoring.at_alarm_level(row, o.alarm_level) for row in as_run]
    print(text_of(rows), end="")
    for name, rate in scoring.foretold_rates(as_run).items():
        print(f"at the level that was run, {name}: {scoring.rate_text(rate)}")
    if o.confusion:
        found = scoring.confusion(rows)
        hidden = {m[0] for row in rows for m in row["truth"]["mechanisms"]}
        dataset.write_json(o.confusion, scoring.confusion_matrix(found, hidden & {case.split("@")[0] for case in found}))


if __name__ == "__main__":
    main()
