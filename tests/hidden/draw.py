"""Everything that is drawn: a block of rock, its specimens, the instrument's errors. Streams are named; equal names give equal draws."""
import math
import random

SMALLEST_SEED, LARGEST_SEED = 10_000_000, 4_000_000_000  # of meshes; a confrontation's own lie below 1,000,000
STRENGTH_SCATTER, STIFFNESS_SCATTER = 0.025, 0.015       # standard deviations between specimens, beside their meshes' own
PARAMETER_RANGE = 0.08                                   # of a parameter, to either side of the base's
ANGLE_RANGE_DEG, RATIO_RANGE = 2.0, 0.03                 # of angles and of Poisson's ratio
OTHER_EDGES = (0.85, 1.15)


def stream(*names):
    return random.Random("/".join(map(str, names)))


def base_value(base, parameter):
    """Of the first experiment that has it."""
    experiment = parameter.get("only", ["uniaxial"])[0]
    value = base["bases"][experiment]
    for key in parameter["pointer"].strip("/").split("/"):
        value = value[key]
    return value


def drawn_value(parameter, value, rng):
    if parameter["transform"] == "tangent":
        return value + rng.uniform(-ANGLE_RANGE_DEG, ANGLE_RANGE_DEG)
    if parameter["transform"] == "linear":
        return value + rng.uniform(-RATIO_RANGE, RATIO_RANGE)
    return value * rng.uniform(1 - PARAMETER_RANGE, 1 + PARAMETER_RANGE)


def draw_block(base, rng, other_edges=False):
    """A laboratory's rock: its own microparameters, and, for one block in four where it is asked for, particles of another size."""
    parameters = {p["name"]: drawn_value(p, base_value(base, p), rng) for p in base["parameters"]}
    other = rng.random() < 0.25
    edge = rng.choice(OTHER_EDGES)
    return {"parameters": parameters, "edge_factor": edge if other_edges and other else 1.0}


def draw_specimen(rng):
    return {"seed": rng.randrange(SMALLEST_SEED, LARGEST_SEED), "strength": math.exp(rng.gauss(0, STRENGTH_SCATTER)),
            "stiffness": math.exp(rng.gauss(0, STIFFNESS_SCATTER))}
