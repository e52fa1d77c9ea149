"""From a simulated curve to what a laboratory writes down: errors of scale and zero, noise of the rows, thinning, units, digits."""
import math

# Standard deviations of the instruments, as the measured file states them (docs/measured_data.md). A worse laboratory multiplies all.
INSTRUMENT = {"load_noise_percent": 0.3, "displacement_noise_percent": 0.1, "transverse_noise_percent": 0.5, "load_scale_percent": 1.0,
              "load_zero_percent": 0.2, "displacement_scale_percent": 0.5, "displacement_zero_mm": 0.02}
ROWS = (200, 280)  # kept of a specimen's curve; simulated ones have 300 and more
TRANSVERSE = ("lateral_strain", "dilation", "dilation_front", "dilation_rear")
# Columns of curves.csv (docs/measured_data.md), by the names used here.
COLUMNS = {
    "uniaxial": {"path": "axial_strain", "load": "axial_stress_mpa", "lateral_strain": "lateral_strain", "gauge": "gauge_axial_strain"},
    "brazilian": {"path": "platen_displacement_mm", "load": "load_n_per_mm"},
    "direct_shear": {"path": "shear_displacement_mm", "load": "shear_stress_mpa", "dilation": "dilation_mm",
                     "dilation_front": "dilation_front_mm", "dilation_rear": "dilation_rear_mm"},
}
COLUMNS["triaxial"] = COLUMNS["uniaxial"]
# Ways to write a column: unit's suffix, factor, digits behind the point.
STRAINS = (("", 1, 6), ("_percent", 100, 4), ("_permille", 1000, 3))
STRESSES = (("_mpa", 1, 3), ("_kpa", 1000, 0))
LENGTHS = (("_mm", 1, 4), ("_um", 1000, 1))
LINE_LOADS = (("_n_per_mm", 1, 2), ("_kn_per_m", 1, 2))
UNITS = {"axial_strain": STRAINS, "lateral_strain": STRAINS, "gauge_axial_strain": STRAINS, "axial_stress": STRESSES, "shear_stress": STRESSES,
         "platen_displacement": LENGTHS, "shear_displacement": LENGTHS, "dilation": LENGTHS, "dilation_front": LENGTHS, "dilation_rear": LENGTHS,
         "load": LINE_LOADS}
SUFFIXES = ("_n_per_mm", "_mpa", "_mm")


def curve_of_table(rows, experiment):
    """Columns of a curves.csv, as lists; cracks of both modes stand for acoustic events."""
    curve = {name: [float(row[column]) for row in rows] for name, column in COLUMNS[experiment].items()}
    curve["events"] = [int(row["cracks_tension"]) + int(row["cracks_shear"]) for row in rows]
    return curve


def kept_columns(test, suite):
    """What the suite's laboratory records of a test: a poor one has neither a gauge nor an ear."""
    names = list(COLUMNS[test.experiment])
    return [n for n in names if n != "gauge"] if suite == "poor" else names + ["events"]


def instrument_of(noise):
    return {name: noise * deviation for name, deviation in INSTRUMENT.items()}


def draw_test_errors(instrument, rng):
    """Errors that all specimens of one test share."""
    names = {"load": "load_scale_percent", "path": "displacement_scale_percent"}
    return {column: 1 + rng.gauss(0, instrument[name] / 100) for column, name in names.items()}


def add_noise(values, percent, rng):
    deviation = percent / 100 * max(map(abs, values))
    return [v + rng.gauss(0, deviation) for v in values]


def thinned(curve, rng):
    """Some of the rows, in their order, the first and the last among them."""
    rows = len(curve["path"])
    kept = min(rows, rng.randint(*ROWS))
    chosen = [0, *sorted(rng.sample(range(1, rows - 1), kept - 2)), rows - 1]
    return {name: [values[i] for i in chosen] for name, values in curve.items()}


def without_a_false_start(curve, pressure):
    """Leading rows that show less than half the confining pressure are left out: what a reader of measured files takes for a
    stress difference."""
    start = next(i for i, load in enumerate(curve["load"]) if load >= 0.5 * pressure) if pressure else 0
    return {name: values[start:] for name, values in curve.items()}


def recorded(curve, test, instrument, errors, rng):
    """One specimen's curve with the instrument's errors: of the test, of the specimen, of each row."""
    curve = thinned(curve, rng)
    length = test.keys.get("height_mm", 1.0)  # the path of a compression is a strain
    zero = rng.gauss(0, instrument["displacement_zero_mm"]) / length
    offset = rng.gauss(0, instrument["load_zero_percent"] / 100) * max(curve["load"])
    curve["path"] = add_noise([errors["path"] * v + zero for v in curve["path"]], instrument["displacement_noise_percent"], rng)
    curve["load"] = add_noise([errors["load"] * v + offset for v in curve["load"]], instrument["load_noise_percent"], rng)
    if "gauge" in curve:
        curve["gauge"] = add_noise(curve["gauge"], instrument["displacement_noise_percent"], rng)
    for name in TRANSVERSE:
        if name in curve and max(map(abs, curve[name])) > 0:
            curve[name] = add_noise(curve[name], instrument["transverse_noise_percent"], rng)
    return without_a_false_start(curve, test.keys.get("confining_pressure_mpa"))


def bare_name(column):
    return next((column[:-len(s)] for s in SUFFIXES if column.endswith(s)), column)


def draw_units(test, rng):
    """How the laboratory writes each column of a test: its name, the factor and the digits."""
    units = {}
    for name, column in COLUMNS[test.experiment].items():
        suffix, factor, digits = rng.choice(UNITS[bare_name(column)])
        units[name] = (bare_name(column) + suffix, factor, digits)
    return units | {"events": ("acoustic_events", 1, 0)}


def csv_text(specimens, columns, units):
    """The table of a test: specimens by name, one after the other."""
    lines = [",".join(["specimen", *(units[c][0] for c in columns)])]
    for name, curve in specimens.items():
        for i in range(len(curve["path"])):
            cells = [f"{curve[c][i] * units[c][1]:.{units[c][2]}f}" for c in columns]
            lines.append(",".join([name, *cells]))
    return "\n".join(lines) + "\n"


def finite(curve):
    return all(math.isfinite(v) for values in curve.values() for v in values)
