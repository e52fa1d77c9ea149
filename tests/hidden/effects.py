"""What may be hidden: mechanisms of the library, and effects that exist here alone.

An effect of the second kind acts on a specimen's run configuration (`on_config`), on the curve that was recorded (`on_curve`), or both.
"""
import dataclasses
from types import MappingProxyType

from laboratory import scale

SLIP_BEGINS, SLIP_KEEPS = 0.3, 0.4      # of the peak load; of the lateral strain behind it
CELL_LIMIT_N_PER_MM, CELL_KEEPS = 250.0, 0.75  # load up to which the cell is true; what it shows of the rest
PORE_SHARE = 0.4                        # of the confining pressure that stands in the pores
WEAK_BLOCK = 0.75                       # strength of the discs' block over the others'
WEAK_PLANE_DEG = 60                     # direction of the library's weak plane in cores that are not turned


def pore_pressure_config(config):
    if config["experiment"]["type"] == "triaxial":
        scale(config, "/experiment/confining_pressure_mpa", 1 - PORE_SHARE)


def pore_pressure_curve(curve, test):
    """The cell's ram carries the pore pressure too: total stress is the skeleton's and what stands in the pores."""
    if test.experiment == "triaxial":
        pore = PORE_SHARE * test.keys["confining_pressure_mpa"]
        curve["load"] = [load + pore for load in curve["load"]]


def weak_discs(config):
    if config["experiment"]["type"] == "brazilian":
        for name in ("tensile_strength_mpa", "cohesion_mpa"):
            scale(config, f"/contacts/{name}", WEAK_BLOCK)


def width_of(test):
    """Factor from a recorded load to N per mm of thickness."""
    return 1.0 if test.experiment == "brazilian" else test.keys.get("width_mm", 1.0)


def yielding_cell(curve, test):
    """A press's load cell that yields: above a load it shows a share of what comes. A shear box has its own cell."""
    if test.experiment == "direct_shear":
        return
    limit = CELL_LIMIT_N_PER_MM / width_of(test) + test.keys.get("confining_pressure_mpa", 0.0)
    curve["load"] = [min(load, limit) + CELL_KEEPS * max(load - limit, 0.0) for load in curve["load"]]


def slipping_gauge(curve, test):
    """A lateral gauge that slips from a share of the peak load on, and then follows a part of what comes."""
    if "lateral_strain" not in curve:
        return
    slips = next(i for i, load in enumerate(curve["load"]) if load >= SLIP_BEGINS * max(curve["load"]))
    held = curve["lateral_strain"][slips]
    curve["lateral_strain"] = [e if i < slips else held + SLIP_KEEPS * (e - held) for i, e in enumerate(curve["lateral_strain"])]


def acting(id, amplitude, prepared):
    """Entries of a mechanism in a test whose specimens were prepared so."""
    if id == "platen_friction" and prepared.get("lubricated_platens"):
        return []
    if id == "weak_plane" and prepared.get("core_angle_deg"):
        return [{"type": id, "amplitude": amplitude, "angle_deg": (WEAK_PLANE_DEG - prepared["core_angle_deg"] + 90) % 180 - 90}]
    return [{"type": id, "amplitude": amplitude}]


@dataclasses.dataclass(frozen=True)
class Outside:
    on_config: object = None
    on_curve: object = None


OUTSIDE = {"pore_pressure": Outside(pore_pressure_config, pore_pressure_curve), "weak_discs": Outside(on_config=weak_discs),
           "yielding_cell": Outside(on_curve=yielding_cell), "slipping_gauge": Outside(on_curve=slipping_gauge)}


@dataclasses.dataclass(frozen=True)
class Effects:
    """`mechanisms`: pairs of an id and its amplitude; `outside`: a name of OUTSIDE or None; `acts_in`: id -> experiments."""
    mechanisms: tuple = ()
    outside: str = None
    acts_in: dict = dataclasses.field(default_factory=dict, compare=False)

    def apply(self, config, prepared=MappingProxyType({})):
        """`prepared`: what a test's keys say of its specimens that a run has no key for."""
        kind = config["experiment"]["type"]
        entries = [entry for id, amplitude in self.mechanisms if kind in self.acts_in[id] for entry in acting(id, amplitude, prepared)]
        if entries and config.get("mechanisms"):
            raise RuntimeError("the base has mechanisms of its own, beside which nothing is hidden")
        if entries:
            config["mechanisms"] = entries
        outside = OUTSIDE[self.outside].on_config if self.outside else None
        if outside:
            outside(config)

    def record(self, curve, test):
        """What the recording makes of a curve, in place."""
        outside = OUTSIDE[self.outside].on_curve if self.outside else None
        if outside:
            outside(curve, test)

    def names(self):
        return sorted(id for id, _ in self.mechanisms)

    def in_the_rock(self):
        """Key of what changes runs: effects that only the recording knows share the runs of data without an effect."""
        simulated = self.outside if self.outside and OUTSIDE[self.outside].on_config else ""
        return f"{sorted(self.mechanisms)}{simulated}"

    def visible_in(self, experiments):
        return all(set(self.acts_in[id]) & set(experiments) for id, _ in self.mechanisms)
