#!/usr/bin/env python3
"""How far the rules for the error of one grid hold on fine grids of the plane: random boxes with 12, 24 and 48 cells across
the smallest particle, against 144.

    examples/coverage/interfaces.py [SEED ...]      by default 201 and 202

A row has the largest error of the mean of both shears at any decade of time on each grid, and the error that the program
prints for it. The finest grid is taken to have a third of the error of 48 cells. The program is `breccia` of the path, or
BRECCIA of the environment; results are in `results/interfaces`, or the directory RESULTS of the environment, and what is
there is not run again."""

import os
import sys
from pathlib import Path

from boxes import box_of
from runs import rows_of, run

RESULTS = Path(os.environ.get("RESULTS", "results/interfaces"))
KINDS = ["apart", "discs", "sizes", "ellipses", "polygons"]
ACROSS, FINEST, PARTICLES = (12, 24, 48), 144, 20


def moduli_of(kind, seed, across):
    """The moduli on a grid by time [Pa], and the printed error of the grid."""
    side, deck = box_of(2, kind, seed, PARTICLES)
    deck = deck.replace('loads = ["shear", "shear-xx-yy", "bulk"]', 'loads = "isotropic"').replace("CELLS", str(round(across * side)))
    directory = run(RESULTS, f"{kind}-{seed}-{across}", deck.replace("points_per_decade = 5", "points_per_decade = 1"))
    rows = [row for row in rows_of(directory / "errors.csv") if row["load"] == "isotropic"]
    return {row["time_s"]: float(row["modulus_Pa"]) for row in rows}, rows[-1]["grid_error"]


def main():
    print("| box | cells | error | printed |\n|---|---|---|---|")
    for seed in map(int, sys.argv[1:] or ("201", "202")):
        for kind in KINDS:
            finest, _ = moduli_of(kind, seed, FINEST)
            for across in ACROSS:
                moduli, printed = moduli_of(kind, seed, across)
                error = max((moduli[time] / finest[time] - 1.0 for time in finest), key=abs)
                print(f"| {kind} {seed} | {across} | {error:+.2%} | {float(printed) if printed else float('nan'):.2%} |", flush=True)


main()
