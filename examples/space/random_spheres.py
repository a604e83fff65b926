#!/usr/bin/env python3
"""The shear modulus of rigid spheres at random over that of their nearly incompressible matrix, beside theories, as a table.

    examples/space/random_spheres.py [CELLS [PACKINGS [BOUNDARY ...]]]      by default 48 cells, 5 packings, periodic

Mean and standard deviation of the two shears of packings of 32 spheres. A packing of 32 cells takes four seconds."""

import sys
from math import exp, pi
from statistics import mean, stdev

from runs import header, measured, row

SPHERES = 32
FRACTIONS = [0.1, 0.2, 0.3, 0.4]
MATRIX_SHEAR = 1e6  # [Pa]
THEORIES = {
    "Hashin's lower bound": lambda f: 1.0 + 2.5 * f / (1.0 - f),
    "Krieger, Dougherty (0.63)": lambda f: (1.0 - f / 0.63) ** (-2.5 * 0.63),
    "differential": lambda f: (1.0 - f) ** -2.5,
    "Thomas": lambda f: 1.0 + 2.5 * f + 10.05 * f**2 + 0.00273 * exp(16.6 * f),
}

cells, packings = sys.argv[1:3] + ["48", "5"][len(sys.argv[1:3]):]
boundaries = sys.argv[3:] or ["periodic"]
header("fraction", *boundaries, *THEORIES)
for fraction in FRACTIONS:
    diameter = (6.0 * fraction / (pi * SPHERES)) ** (1.0 / 3.0)
    found = []
    for boundary in boundaries:
        ratios = []
        for seed in range(1, int(packings) + 1):
            run = measured(f"random-{fraction}-{boundary}-{cells}-{seed}", "random-spheres.toml", {
                "stages.0.cells": cells,
                "stages.0.filler.fraction": fraction,
                "stages.0.filler.sizes.diameter": f'"{diameter:.6g} mm"',
                "stages.0.packing.seed": seed,
                "stages.0.packing.walls": "false" if boundary == "periodic" else "true",
                "tests.boundaries": f'["{boundary}"]',
            })
            ratios += [run.modulus(load, boundary=boundary) / MATRIX_SHEAR for load in ("shear", "shear-xx-yy")]
        found.append(f"{mean(ratios):.2f} ({stdev(ratios):.2f})")
    row(f"{100 * fraction:g} %", *found, *(f"{theory(fraction):.2f}" for theory in THEORIES.values()))
