#!/usr/bin/env python3
"""Stands in for the executable where a test is about the pool: `run CONFIG ... --out DIR` writes a curve that follows from the seed.

Seeds that 5 divides fail as a numerical guard would have them, seeds that 7 divides as an interrupted run.
"""
import json
import pathlib
import sys

COLUMNS = ("axial_strain", "axial_stress_mpa", "lateral_strain", "gauge_axial_strain", "platen_displacement_mm", "load_n_per_mm", "shear_displacement_mm",
           "shear_stress_mpa", "dilation_mm", "dilation_front_mm", "dilation_rear_mm", "cracks_tension", "cracks_shear")


def main():
    config = json.loads(pathlib.Path(sys.argv[2]).read_text())
    out = pathlib.Path(sys.argv[sys.argv.index("--out") + 1])
    seed = config["particles"]["seed"]
    if seed % 5 == 0:
        sys.exit(4)
    if seed % 7 == 0:
        sys.exit(130)
    out.mkdir(parents=True)
    rows = [",".join(str(i * seed if "crack" not in c else i) for c in COLUMNS) for i in range(300)]
    (out / "curves.csv").write_text("\n".join([",".join(COLUMNS), *rows]) + "\n")


main()
