"""One data set: which effect, which block of rock, which specimens; written as a bare measured file, its truth sealed elsewhere."""
import dataclasses
import hashlib
import json
import os
import subprocess

import laboratory
import recording
from draw import draw_block, draw_specimen, stream
from effects import Effects
from pool import LostSpecimen


@dataclasses.dataclass(frozen=True)
class Plan:
    """How data sets are drawn: blocks of rock an effect has, meshes a test of a block has, specimens a data set takes of them."""
    suite: str = "rich"
    specimens: int = 6
    blocks: int = 3
    meshes: int = 8
    other_edges: bool = False
    seed: str = "1"  # of blocks and meshes: the pool's
    noise: float = 1.0  # factor on the instrument's errors


def block_of(base, plan, effects, number):
    return draw_block(base, stream(plan.seed, "block", effects.in_the_rock(), number), plan.other_edges)


def config_of(base, plan, effects, number, test, mesh):
    """Run configuration of one mesh of a test."""
    specimen = draw_specimen(stream(plan.seed, "specimen", effects.in_the_rock(), number, test.id, mesh))
    return laboratory.specimen_config(base, test, plan.suite, block_of(base, plan, effects, number), specimen, effects)


def tests_of(plan):
    return [laboratory.TESTS[id] for id in laboratory.SUITES[plan.suite]]


def all_configs(base, plan, effects):
    """Every run that data sets of this effect can need."""
    return [config_of(base, plan, effects, number, test, mesh)
            for number in range(plan.blocks) for mesh in range(plan.meshes) for test in tests_of(plan)]


@dataclasses.dataclass(frozen=True)
class Draw:
    """One data set's own draws; rng streams are named by `seed`."""
    effects: Effects
    block: int
    seed: str
    name: str


def draw_set(plan, effects, seed):
    rng = stream(seed, "set")
    return Draw(effects, rng.randrange(plan.blocks), seed, f"D{rng.randrange(100, 1000)}")


def drawn_configs(base, plan, draw, test):
    """The meshes of a test in the order in which this data set takes specimens from them."""
    order = stream(draw.seed, "meshes", test.id).sample(range(plan.meshes), plan.meshes)
    return [config_of(base, plan, draw.effects, draw.block, test, mesh) for mesh in order]


def needed_configs(base, plan, draw):
    return [c for test in tests_of(plan) for c in drawn_configs(base, plan, draw, test)[:plan.specimens]]


def intact_curves(pool, configs, count):
    """Curves of the first specimens that were not lost."""
    curves = []
    for config in configs:
        try:
            curves.append(pool.curve(config))
        except LostSpecimen:
            continue
        if len(curves) == count:
            return curves
    raise LostSpecimen(f"only {len(curves)} of {len(configs)} specimens can be tested")


def record_test(base, plan, draw, pool, test):
    """Text of a test's table."""
    rng = stream(draw.seed, "instrument", test.id)
    instrument = recording.instrument_of(plan.noise)
    errors, units = recording.draw_test_errors(instrument, rng), recording.draw_units(test, rng)
    columns = recording.kept_columns(test, plan.suite)
    specimens = {}
    for curve in intact_curves(pool, drawn_configs(base, plan, draw, test), plan.specimens):
        curve = {name: list(values) for name, values in curve.items() if name in columns}
        draw.effects.record(curve, test)
        specimens[f"{len(specimens) + 1}"] = recording.recorded(curve, test, instrument, errors, rng)
    return recording.csv_text(specimens, columns, units)


def measured_json(plan, draw):
    tests = []
    for number, test in enumerate(tests_of(plan), 1):
        entry = {"id": test.id, "experiment": test.experiment, **test.keys, "curve": f"T{number}.csv", "use": test.use}
        tests.append(entry)
    return {"name": draw.name, "material": "plaster", "source": "laboratory", "instrument": recording.instrument_of(plan.noise), "tests": tests}


def write_json(path, value):
    path.write_text(json.dumps(value, indent=2) + "\n")


def say_what_did_not_fail(binary, path, data):
    """A specimen that was not taken to failure is told as such: what the reader of measured files asks for."""
    result = subprocess.run([str(binary), "validate", str(path)], capture_output=True, text=True)
    if result.returncode == 0:
        return
    ends = {line.split(".csv:")[0].split("/")[-1] for line in result.stderr.splitlines() if "ends at its peak" in line}
    for test in data["tests"]:
        if test["curve"].removesuffix(".csv") in ends:
            test["ends_before_peak"] = True
    write_json(path, data)
    result = subprocess.run([str(binary), "validate", str(path)], capture_output=True, text=True)
    if result.returncode != 0:
        raise RuntimeError(f"a generated file is refused: {result.stderr}")


def write_set(base, plan, draw, pool, folder):
    """Writes NAME.json and its tables; the path of the JSON file."""
    folder.mkdir(parents=True)
    for number, test in enumerate(tests_of(plan), 1):
        (folder / f"T{number}.csv").write_text(record_test(base, plan, draw, pool, test))
    data, path = measured_json(plan, draw), folder / f"{draw.name}.json"
    write_json(path, data)
    say_what_did_not_fail(pool.binary, path, data)
    return path


def truth_of(base, plan, draw):
    block = block_of(base, plan, draw.effects, draw.block)
    return {"mechanisms": [list(m) for m in draw.effects.mechanisms], "outside": draw.effects.outside, "edge_factor": block["edge_factor"],
            "parameters": block["parameters"], "block": draw.block, "seed": draw.seed}


def seal(truth, path):
    """Writes what is true beside a random number, so that guesses cannot be tried against the hash; the hash."""
    text = json.dumps({"salt": os.urandom(16).hex(), "truth": truth}, indent=2)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    return hashlib.sha256(text.encode()).hexdigest()


def open_seal(path, sha256, verdict):
    """The truth, once there is a verdict, if nobody has changed it."""
    if not verdict.exists():
        raise RuntimeError(f"{path} may be opened after {verdict} is written")
    text = path.read_text()
    if hashlib.sha256(text.encode()).hexdigest() != sha256:
        raise RuntimeError(f"{path} is not what was sealed")
    return json.loads(text)["truth"]
