#!/usr/bin/env python3
"""Iterations, processor seconds and memory of one elastic solution, by boundary, matrix and cells, as tables.

    examples/space/solver.py CELLS [BOUNDARY ...]      by default all three boundaries

The processor time and the memory are those of the whole program, packing and results included."""

import sys
from math import pi

from runs import header, measured, row

SHEARS = [2156, 100, 10, 1, 0.3]  # of the matrix [MPa]
PACKINGS = {0.35: (30, 14), 0.5: (200, 5)}  # by fraction: number of spheres, smallest gap [mm] in a box of 1 m


def rounded(seconds):
    return f"{seconds:.2g}" if seconds < 10 else f"{seconds:.0f}"


cells, *boundaries = sys.argv[1:]
for fraction, (number, gap) in PACKINGS.items():
    diameter = 1e3 * (6.0 * fraction / (pi * number)) ** (1.0 / 3.0)
    print(f"\n{number} spheres, {100 * fraction:g} %, {cells} cells; G of the composite; iterations, processor time\n")
    header("boundary", *(f"matrix G {shear:g} MPa" for shear in SHEARS), "memory an unknown")
    for boundary in boundaries or ("periodic", "displacement", "traction"):
        runs = [measured(f"solver-{fraction}-{boundary}-{cells}-{shear}", "solver.toml", {
            "stages.0.cells": cells,
            "stages.0.filler.fraction": fraction,
            "stages.0.filler.sizes.diameter": f'"{diameter:.6g} mm"',
            "stages.0.filler.gap": f'"{gap} mm"',
            "stages.0.packing.walls": "false" if boundary == "periodic" else "true",
            "materials.matrix.shear": f'"{shear} MPa"',
            "tests.boundaries": f'["{boundary}"]',
            "tests.fields": '"none"',
        }) for shear in SHEARS]
        costs = (f"{run.modulus('shear', boundary=boundary) / 1e6:.4g} MPa; {run.iterations[boundary]}, "
                 f"{rounded(run.processor_seconds)} s" for run in runs)
        row(boundary, *costs, f"{max(run.memory / run.unknowns for run in runs):.0f} B")
