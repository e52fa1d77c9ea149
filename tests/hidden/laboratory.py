"""The laboratory whose data hide an effect: its tests, and the run configuration of one specimen.

Bases and parameters are those of configs/confrontation/laboratory.json, so that what a confrontation calibrates is what a hidden
laboratory may have moved. A specimen's configuration is a whole run configuration: nothing else decides what its run gives.
"""
import copy
import dataclasses
import json


@dataclasses.dataclass(frozen=True)
class LabTest:
    """One test: `keys` are what the measured file says of it, `pointers` the same in a run configuration."""
    id: str
    experiment: str
    keys: dict
    pointers: dict
    use: str = "fit"


def compression(id, height_mm, pressure_mpa=None, use="fit"):
    keys = {"width_mm": 50, "height_mm": height_mm, "plane": "strain"}
    if pressure_mpa is not None:
        keys["confining_pressure_mpa"] = pressure_mpa
    return LabTest(id, "uniaxial" if pressure_mpa is None else "triaxial", keys, {f"/experiment/{k}": v for k, v in keys.items()}, use)


def joint(id, normal_stress_mpa):
    """One tooth."""
    keys = {"normal_stress_mpa": normal_stress_mpa, "profile": [{"angle_deg": 30, "height_mm": 5, "gap_before_mm": 3.5}], "end_gap_mm": 3.5}
    pointers = {"/experiment/normal_stress_mpa": normal_stress_mpa, "/joint/profile": keys["profile"], "/joint/end_gap_mm": keys["end_gap_mm"]}
    return LabTest(id, "direct_shear", keys, pointers)


PREPARATION = ("core_angle_deg", "lubricated_platens")  # keys of a measured test that a run configuration does not have


TESTS = {t.id: t for t in (
    compression("U", 100),
    compression("S", 50),
    compression("T1", 100, 0.5),
    compression("T3", 100, 1.5),
    LabTest("B", "brazilian", {"diameter_mm": 50}, {"/experiment/diameter_mm": 50}),
    joint("J", 1.47),
    joint("J2", 0.49),
    compression("T2", 100, 1.0, "hold_out"),
)}
# quick: the rich suite without its slowest tests. poor: as a small rock laboratory reports it.
SUITES = {"rich": ("U", "S", "T1", "T3", "B", "J", "J2", "T2"), "quick": ("U", "S", "T1", "T3", "B", "T2"), "poor": ("B", "U", "T1")}


def with_loops(suite):
    """Whether the suite's tests have what configs/confrontation/laboratory.json sets for single tests: loops of unloading."""
    return suite != "poor"


def read_base(source):
    """configs/confrontation/laboratory.json as it stands."""
    return json.loads((source / "configs/confrontation/laboratory.json").read_text())


def parent_of(config, pointer):
    keys = pointer.strip("/").split("/")
    for key in keys[:-1]:
        config = config.setdefault(key, {})
    return config, keys[-1]


def put(config, pointer, value):
    parent, key = parent_of(config, pointer)
    parent[key] = copy.deepcopy(value)


def scale(config, pointer, factor):
    parent, key = parent_of(config, pointer)
    parent[key] *= factor


def apply_parameter(config, parameter, value):
    """Sets a microparameter; pointers tied to it scale in proportion. A base without it (the joint's in a disc) has none to set."""
    if config["experiment"]["type"] not in parameter.get("only", [config["experiment"]["type"]]):
        return
    parent, key = parent_of(config, parameter["pointer"])
    for tied in parameter.get("tied", []):
        scale(config, tied, value / parent[key])
    parent[key] = value


def apply_edge(config, factor):
    """Particles of another size; contact stiffness times edge stays (as calibrated)."""
    scale(config, "/particles/edge_mm", factor)
    for key in ("tensile", "shear"):
        scale(config, f"/contacts/{key}_stiffness_mpa_per_mm", 1 / factor)


def virtual_test(base, test, suite):
    """The run configuration of a test, before a specimen's own values."""
    config = copy.deepcopy(base["bases"][test.experiment])
    settings = dict(test.pointers)
    if with_loops(suite):
        settings |= base["tests"].get(test.id, {}).get("set", {})
    for pointer, value in settings.items():
        put(config, pointer, value)
    config["name"] = "specimen"
    return config


def specimen_config(base, test, suite, block, specimen, effects):
    """`block`: values of the parameters and edge factor; `specimen`: seed, strength and stiffness factors; `effects`: see effects.py."""
    config = virtual_test(base, test, suite)
    for parameter in base["parameters"]:
        apply_parameter(config, parameter, block["parameters"][parameter["name"]])
    for name in ("tensile_strength_mpa", "cohesion_mpa"):
        scale(config, f"/contacts/{name}", specimen["strength"])
    for pointer in ("/particles/youngs_modulus_gpa", "/contacts/tensile_stiffness_mpa_per_mm", "/contacts/shear_stiffness_mpa_per_mm"):
        scale(config, pointer, specimen["stiffness"])
    if block["edge_factor"] != 1.0:
        apply_edge(config, block["edge_factor"])
    config["particles"]["seed"] = specimen["seed"]
    effects.apply(config, {key: value for key, value in test.keys.items() if key in PREPARATION})
    return config
