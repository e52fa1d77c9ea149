"""How a verdict fares against what was hidden, and rates with their 95 % binomial intervals."""
import math
import statistics

MOST_NAMES = 3  # a larger set says "cannot tell"
# Each: whether it holds for a judged row; rates are shares of the rows for which `of` holds.
RATES = {
    "detected": ("detected", lambda r: True),
    "truth in the set": ("in_set", lambda r: r["detected"]),
    "truth among all names": ("among_all", lambda r: r["detected"]),
    "a true cause in the set, particles of another size among them": ("partly", lambda r: r["detected"]),
    "wrong single name": ("wrong_single", lambda r: r["detected"]),
    "wrong pair": ("wrong_pair", lambda r: r["detected"]),
    "unexplained": ("unexplained", lambda r: r["detected"]),
    "cannot tell": ("cannot_tell", lambda r: r["detected"]),
}


def true_names(truth):
    """The hidden mechanisms; particles of another size are one that the library has."""
    return {m[0] for m in truth["mechanisms"]} | ({"mesh_size"} if truth["edge_factor"] != 1.0 else set())


def foretold(truth, verdict):
    """Whether these tests were said to show what is hidden: `detectable_amplitude` knows the mechanisms, and not what is there."""
    detectable = verdict.get("detectable_amplitude", {})
    return any(detectable.get(id) is not None and detectable[id] <= amplitude for id, amplitude in truth["mechanisms"])


def judge(truth, verdict):
    """What of a verdict is right."""
    status, causes = verdict["status"], set(verdict["causes"])
    hidden, allowed = {m[0] for m in truth["mechanisms"]}, true_names(truth)
    tells = status in ("named", "two_causes") or (status == "indistinguishable" and len(causes) <= MOST_NAMES)
    return {
        "status": status, "causes": sorted(causes), "detected": status != "nothing_found",
        "in_set": bool(hidden) and tells and hidden <= causes,
        "among_all": bool(hidden) and hidden <= causes,
        "partly": bool(allowed & causes) and tells,
        "wrong_single": status == "named" and not causes <= allowed,
        "wrong_pair": status == "two_causes" and not causes & allowed,
        "unexplained": status == "unexplained",
        "cannot_tell": status == "indistinguishable" and len(causes) > MOST_NAMES,
        "foretold": foretold(truth, verdict),
    }


ALARM_LEVELS = (0.01, 0.02, 0.03, 0.05)
MISFIT_LEVEL = 1e-4  # of the whole misfit, whatever the alarm level


def gate_of(verdict):
    """The probabilities by which a verdict's gate decides."""
    return {name: verdict["gate"][name] for name in ("p_explained", "p_misfit")}


def at_alarm_level(row, level):
    """The row as a smaller level would have had it: beyond the gate a verdict does not depend on it."""
    if row["p_explained"] < level or row["p_misfit"] < MISFIT_LEVEL:
        return row
    return row | {"status": "nothing_found", "causes": [], "gain": None} | {key: False for key, _ in RATES.values()}


def by_alarm_level(rows):
    """Alarms and names where nothing is hidden, and what becomes of effects, by the gate's level up to the one that was run."""
    seen = {}
    for level in ALARM_LEVELS:
        at = [at_alarm_level(row, level) for row in rows]
        if any(a["detected"] != row["detected"] for a, row in zip(at, rows)) or level == ALARM_LEVELS[0]:
            seen[f"{level:g}"] = at
    seen["run"] = rows
    return {level: {"alarms on null data": rate(at, "detected", lambda r: r["kind"] == "null"),
                    "names on null data": rate(at, "wrong_single", lambda r: r["kind"] == "null"),
                    "detected": rate(at, "detected", is_effect),
                    "truth in the set": rate(at, "in_set", lambda r: is_effect(r) and r["detected"]),
                    "truth among all names": rate(at, "among_all", lambda r: is_effect(r) and r["detected"]),
                    "wrong single name": rate(at, "wrong_single", lambda r: is_effect(r) and r["detected"])} for level, at in seen.items()}


def is_effect(row):
    return row["kind"] not in ("null", "outside")


def binomial_tail(successes, trials, p):
    """P(X >= successes)."""
    return sum(math.comb(trials, k) * p**k * (1 - p) ** (trials - k) for k in range(successes, trials + 1))


def bisected(rises, low=0.0, high=1.0):
    """Where a predicate that turns true with p does so."""
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if rises(middle) else (middle, high)
    return 0.5 * (low + high)


def binomial_interval(successes, trials, level=0.95):
    """The exact interval (Clopper & Pearson 1934) of a rate."""
    if trials == 0:
        return 0.0, 1.0
    tail = 0.5 * (1 - level)
    low = 0.0 if successes == 0 else bisected(lambda p: binomial_tail(successes, trials, p) >= tail)
    high = 1.0 if successes == trials else bisected(lambda p: 1 - binomial_tail(successes + 1, trials, p) <= tail)
    return low, high


def rate(rows, key, of):
    of_rows = [r for r in rows if of(r)]
    hits = sum(r[key] for r in of_rows)
    return {"count": hits, "of": len(of_rows), "interval_95": binomial_interval(hits, len(of_rows))}


def rates(rows):
    return {name: rate(rows, key, of) for name, (key, of) in RATES.items()}


def foretold_rates(rows):
    """How a verdict's `detectable_amplitude` keeps its word, at the alarm level that it was made for: rows as they were run."""
    effects = [r for r in rows if is_effect(r)]
    return {"detected where foretold": rate(effects, "detected", lambda r: r["foretold"]),
            "detected where not": rate(effects, "detected", lambda r: not r["foretold"])}


def rate_text(r):
    low, high = r["interval_95"]
    return f"{r['count']}/{r['of']} ({100 * low:.1f}-{100 * high:.1f} %)" if r["of"] else "-"


def answer_of(row):
    """A verdict as one word of a confusion matrix."""
    if row["status"] == "named":
        return row["causes"][0]
    return "cannot_tell" if row["cannot_tell"] else row["status"]


def confusion(rows):
    """hidden case -> answer -> count; of a tie that holds the truth the answer is "tie_with_truth"."""
    matrix = {}
    for row in rows:
        tie = row["status"] == "indistinguishable" and row["in_set"]
        answers = matrix.setdefault(row["case"], {})
        answer = "tie_with_truth" if tie else answer_of(row)
        answers[answer] = answers.get(answer, 0) + 1
    return matrix


OTHER_ANSWERS = {"tie_with_truth": "a tie with the truth", "indistinguishable": "a tie without it", "cannot_tell": "more than three",
                 "two_causes": "two causes", "unexplained": "unexplained", "nothing_found": "nothing found"}


def confusion_matrix(matrix, ids):
    """What `asperity report --confusion` draws: hidden cases by answers, mechanisms on the diagonal, then nothing and what is outside.
    Columns are what is hidden and whatever else was named, so that every data set stands in one."""
    place = {id: number for number, id in enumerate(sorted(ids))}
    cases = sorted(matrix, key=lambda case: (place.get(case.split("@")[0], len(place)), case))
    named = {answer for answers in matrix.values() for answer in answers} - OTHER_ANSWERS.keys()
    answers = [*sorted(named | set(ids)), *OTHER_ANSWERS]
    return {"rows": [case.removesuffix("@1").replace("@", " × ") for case in cases], "columns": [OTHER_ANSWERS.get(a, a) for a in answers],
            "counts": [[matrix[case].get(answer, 0) for answer in answers] for case in cases]}


def beyond_scatter(rms_z):
    """What of a deviation in standard deviations is the model's: a right one has 1 of scatter alone, and squares add."""
    return math.sqrt(max(0.0, rms_z**2 - 1.0))


def pooled_share(gains):
    """Of all verdicts together, whose scatter averages out; nothing where the base errs by no more than that."""
    pooled = {when: beyond_scatter(math.sqrt(statistics.mean(g[f"rms_z_{when}"] ** 2 for g in gains))) for when in ("before", "after")}
    return {"pooled_share_beyond_scatter": pooled["after"] / pooled["before"]} if pooled["before"] > 0 else {}


def gain_summary(rows):
    """On the hold-out tests, of verdicts with an extension: change of expected log predictive density, and the extension's
    root mean square deviation over the recalibrated base's, as it is and beyond what scatter makes."""
    gains = [r["gain"] for r in rows if r.get("gain") and r["gain"]["elpd_change"] is not None]
    if not gains:
        return None
    changes = [g["elpd_change"] for g in gains]
    shares = [g["rms_z_after"] / g["rms_z_before"] for g in gains]
    model_shares = [beyond_scatter(g["rms_z_after"]) / beyond_scatter(g["rms_z_before"]) for g in gains if g["rms_z_before"] > 1.0]
    beyond = {f"where_the_base_errs_by_{n}": [s for s, g in zip(shares, gains) if g["rms_z_before"] > n] for n in (2, 3)}
    return {f"{name}{what}": of for name, some in beyond.items() if some
            for what, of in (("_verdicts", len(some)), ("_median_error_share", statistics.median(some)))} | {
            "verdicts": len(gains), "mean_elpd_change": statistics.mean(changes), "claimed": sum(g["claimed"] for g in gains),
            "median_error_share": statistics.median(shares), "halved": sum(share <= 0.5 for share in shares),
            "median_error_before": statistics.median(g["rms_z_before"] for g in gains)} | ({
            "where_the_base_errs_beyond_scatter": len(model_shares),
            "median_share_beyond_scatter": statistics.median(model_shares)} if model_shares else {}) | pooled_share(gains)
