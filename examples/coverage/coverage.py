#!/usr/bin/env python3
"""How often the error of the grid that a run prints holds: random boxes on two grids against one that is much finer.

    examples/coverage/coverage.py [DIMENSIONS [FIRST LAST]]      the boxes from FIRST to LAST, by default 1 to 100 of the plane

A box of the plane takes half a minute on one core, one of space several.

Each box has N/2 and N cells a side, N drawn such that the smallest particle has 8 to 20 cells across it, at most 72 (in
space 8 to 16, at most 24), and again four times N (in space three times). A test, which is a box under one boundary
and one load, is covered if at every time the modulus with N cells is off that of the fine grid by no more than its half
band in extrapolation.csv. The program is `breccia` of the path, or BRECCIA of the environment; results are in
`results/coverage`, or the directory RESULTS of the environment, and what is there is not run again."""

import os
import random
import sys
from pathlib import Path
from statistics import median

from boxes import KINDS, box_of
from runs import rows_of, run

RESULTS = Path(os.environ.get("RESULTS", "results/coverage"))
FINER = {2: 4, 3: 3}


def cells_of(dim, side, seed):
    """Cells a side of the finer of the two grids of a box: an even number."""
    draw = random.Random(f"cells {seed}")
    across = 8.0 * (2.5 if dim == 2 else 2.0) ** draw.random()
    return min(2 * round(across * side / 2.0), 72 if dim == 2 else 24)


def run_on(name, deck, cells):
    return run(RESULTS, name, deck.replace("CELLS", str(cells)))


def tests_of(dim, kind, seed):
    """For each test of a box its largest relative error, the half band there, and the largest ratio of both at any time."""
    side, deck = box_of(dim, kind, seed)
    cells = cells_of(dim, side, seed)
    name = f"{dim}-{kind}-{seed}"
    pair, fine = run_on(name, deck, [cells // 2, cells]), run_on(f"{name}-fine", deck, FINER[dim] * cells)
    if pair is None or fine is None:
        return []
    true = {(row["boundary"], row["load"], row["time_s"]): float(row["modulus_Pa"]) for row in rows_of(fine / "curves.csv")}
    tests = {}
    for row in rows_of(pair / "extrapolation.csv"):
        value = true[row["boundary"], row["load"], row["time_s"]]
        error, band = abs(float(row["modulus_Pa"]) / value - 1.0), float(row["half_band_Pa"]) / float(row["modulus_Pa"])
        tests.setdefault((row["boundary"], row["load"]), []).append((error, band))
    return [(name, cells, *test, max(e for e, _ in both), max(b for _, b in both), max(e / max(b, 1e-12) for e, b in both))
            for test, both in tests.items()]


dim = int(sys.argv[1]) if len(sys.argv) > 1 else 2
first, last = (int(sys.argv[2]), int(sys.argv[3])) if len(sys.argv) > 3 else (1, {2: 100, 3: 40}[dim])
found = {kind: [] for kind in KINDS[dim]}
for seed in range(first, last + 1):
    kind = KINDS[dim][seed % len(KINDS[dim])]
    for test in tests_of(dim, kind, seed):
        found[kind].append(test)
        print("{}, {} cells, {} {}: error {:.2%}, band {:.2%}, ratio {:.2f}".format(*test), file=sys.stderr, flush=True)

print("| kind | tests | covered | error, median | worst | half band, median | worst |\n|---|---|---|---|---|---|---|")
for kind, tests in [*found.items(), ("all", [test for tests in found.values() for test in tests])]:
    if not tests:
        continue
    errors, bands, ratios = ([test[i] for test in tests] for i in (4, 5, 6))
    covered = sum(ratio <= 1.0 for ratio in ratios)
    print(f"| {kind} | {len(tests)} | {covered / len(tests):.0%} | {median(errors):.1%} | {max(errors):.0%} | "
          f"{median(bands):.1%} | {max(bands):.0%} |")
