#!/usr/bin/env python3
"""The shear modulus of thirty spheres by matrix and cells, its distance from the finest one, and the cost, as a table.

    examples/space/spheres_30.py CELLS ...      by default 32, 48, 64 and 96

The processor time is that of the whole program."""

import sys

from runs import header, measured, row

SHEARS = [2156, 100, 10, 1]  # of the matrix [MPa]

cells = [int(number) for number in sys.argv[1:]] or [32, 48, 64, 96]
header("matrix G", *(f"{n} cells" for n in cells))
for shear in SHEARS:
    runs = [measured(f"spheres-30-{n}-{shear}", "spheres-30.toml",
                     {"stages.0.cells": n, "materials.matrix.shear": f'"{shear} MPa"'}) for n in cells]
    finest = runs[-1].modulus("shear")
    costs = (f"{run.modulus('shear') / 1e6:.4g} MPa ({100 * (run.modulus('shear') / finest - 1):+.2f} %), "
             f"{run.iterations['periodic']}, {run.processor_seconds:.2g} s" for run in runs)
    row(f"{shear} MPa", *costs)
