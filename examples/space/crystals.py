#!/usr/bin/env python3
"""Spheres of a cubic crystal in a cubic lattice, 20 %, with the axes of the box: each shear modulus against that of
isotropic spheres with the crystal's modulus for this shear, C44 or C' = (C11 - C12) / 2, on the same grid.

    examples/space/crystals.py [CELLS ...]      by default 8 16 32 48

The program is `breccia` of the path, or BRECCIA of the environment."""

import csv
import os
import subprocess
import sys
import tempfile
from math import pi
from pathlib import Path

BULK = 10e9
SHEARS = ((8e9, 2e9), (6e9, 3e9))  # C44 and C' [Pa]; the binder has 1 GPa

DECK = """dimensions = 3
[materials.binder]
density = "1 g/cm^3"
bulk = "3 GPa"
shear = "1 GPa"
[materials.filler]
density = "2 g/cm^3"
{filler}
[[stages]]
name = "box"
matrix = "binder"
box = "1 mm"
cells = {cells}
filler = {{ material = "filler"{orientations} }}
packing = {{ method = "explicit", particles = "sphere.csv", walls = false }}
[tests]
times = ["1 us", "10 us"]
loads = ["shear", "shear-xx-yy"]
mixing = "{mixing}"
points_per_decade = 1
fields = "none"
"""


def moduli(filler, orientations, cells, mixing):
    """The moduli of the two shears [Pa]."""
    with tempfile.TemporaryDirectory() as directory:
        path = Path(directory)
        diameter = 1000.0 * (6.0 * 0.2 / pi) ** (1.0 / 3.0)
        (path / "sphere.csv").write_text(f"x_um,y_um,z_um,diameter_um\n500,500,500,{diameter}\n")
        deck = DECK.format(filler=filler, orientations=orientations, cells=cells, mixing=mixing)
        (path / "deck.toml").write_text(deck)
        subprocess.run([os.environ.get("BRECCIA", "breccia"), "run", path / "deck.toml", "--out", path / "out", "--quiet"],
                       check=True)
        with open(path / "out" / "curves.csv", newline="") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return [next(float(row["modulus_Pa"]) for row in rows if row["load"] == load) for load in ("shear", "shear-xx-yy")]


def main():
    grids = [int(number) for number in sys.argv[1:]] or [8, 16, 32, 48]
    print("| C44 / C' | mixing | cells | shear xy | shear xx-yy |\n|---|---|---|---|---|")
    for c44, prime in SHEARS:
        constants = f'C11 = "{BULK + 4 / 3 * prime} Pa", C12 = "{BULK - 2 / 3 * prime} Pa", C44 = "{c44} Pa"'
        crystal = f'stiffness = {{ symmetry = "cubic", {constants} }}'
        for mixing in ("series", "points"):
            for cells in grids:
                found = moduli(crystal, ', orientations = "aligned"', cells, mixing)
                exact = [moduli(f'bulk = "{BULK} Pa"\nshear = "{shear} Pa"', "", cells, mixing)[load]
                         for load, shear in enumerate((c44, prime))]
                errors = [f"{one / other - 1.0:+.2%}" for one, other in zip(found, exact)]
                print(f"| {c44 / prime:g} | {mixing} | {cells} | {errors[0]} | {errors[1]} |", flush=True)


main()
