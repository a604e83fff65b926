#!/usr/bin/env python3
"""C11, C12 and C44 of a sphere in a Maxwell cube over time, and their errors, as a table.

    examples/space/maxwell_cube.py [CELLS ...]      by default 32 and 64; seconds and half a minute each"""

import sys
from math import pi

from runs import REFERENCE, header, measured, read, row

CELLS = [int(cells) for cells in sys.argv[1:]] or [32, 64]

header("fraction", "time", *(f"{cells} cells: C11, C12, C44 [GPa]; errors" for cells in CELLS))
for reference in read(REFERENCE / "sphere_in_maxwell_cube.csv"):
    fraction, time = reference["fraction"], float(reference["time_s"])
    diameter = (6.0 * float(fraction) / pi) ** (1.0 / 3.0)
    cells_of_row = []
    for cells in CELLS:
        run = measured(f"maxwell-{fraction}-{cells}", "maxwell-cube.toml",
                       {"stages.0.cells": cells, "stages.0.filler.sizes.diameter": f'"{diameter:.9g} mm"'})
        bulk, shear, c44 = (run.modulus(load, time) for load in ("bulk", "shear-xx-yy", "shear"))
        found = {"C11": bulk + 4.0 / 3.0 * shear, "C12": bulk - 2.0 / 3.0 * shear, "C44": c44}
        errors = (100.0 * (found[name] / float(reference[f"{name}_Pa"]) - 1.0) for name in found)
        values = ", ".join(f"{value / 1e9:.4f}" for value in found.values())
        cells_of_row.append(f"{values}; {', '.join(f'{error:+.2f}' for error in errors)} %")
    row(fraction, f"{time:.0f} s", *cells_of_row)
