#!/usr/bin/env python3
"""How often the whole error that a run prints holds, that of the grid and of the packing together: random composites
against the mean of many packings on a grid that is much finer.

    examples/coverage/whole.py [DIMENSIONS [FIRST LAST]]      the composites from FIRST to LAST, by default 1 to 100 of the plane

A composite is a kind of box, a fraction, a filler and a binder that relaxes by 10 to 1e5; it is computed for 20 packings of
15 to 40 particles (in space 5 packings of 14 to 20, twice as many where sizes differ: the scatter of fewer has no rule),
with 8 to 11 cells across the smallest particle (in space 3.5 to 4.5), on one grid or, of every second composite and in
space, on two. The truth is the mean of the packings times the ratio, in one of them, of four times as many cells a side
to these (in space of the limit of these and twice as many to that of these and half as many); the mean of all shears and
the bulk modulus are held against it at whole decades. A value is held if it is off the truth by no more than the error
that its run prints, a run if all its values are. The program is `breccia` of the path, or BRECCIA of the environment;
results are in `results/whole`, or the directory RESULTS of the environment, and what is there is not run again."""

import os
import random
import sys
from math import isfinite
from pathlib import Path
from statistics import mean, median

from boxes import box_of
from runs import rows_of, run

RESULTS = Path(os.environ.get("RESULTS", "results/whole"))
KINDS = {2: ["discs", "sizes", "ellipses", "polygons", "grains", "soft", "apart"], 3: ["spheres", "sizes", "soft"]}
PARTICLES = {2: (15, 40), 3: (14, 20)}
PACKINGS = {2: 20, 3: 5}
ACROSS = {2: (8.0, 11.0), 3: (3.5, 4.5)}
LOADS = ("isotropic", "bulk")


def composite_of(dim, kind, seed):
    """The deck of a composite, with the word CELLS in place of its cells, and the cells a side."""
    draw = random.Random(f"whole {seed}")
    low, high = PARTICLES[dim]
    count = low * (high / low) ** draw.random()
    side, deck = box_of(dim, kind, seed, round(2 * count if dim == 3 and kind == "sizes" else count))
    low, high = ACROSS[dim]
    cells = 2 * round(side * draw.uniform(low, high) / 2.0)
    loads = '["shear", "shear-xx-yy", "bulk"]'
    assert loads in deck
    deck = deck.replace(loads, '["isotropic", "bulk"]')
    return deck.replace("points_per_decade = 5", "points_per_decade = 1"), cells


def moduli_of(directory):
    """The modulus and its error at each load and time of the finest grid, or of the limit of two; the error of a modulus
    is nan where the run prints none."""
    return {(row["load"], row["time_s"]): (float(row["modulus_Pa"]), float(row["error"] or "nan"))
            for row in rows_of(directory / "errors.csv") if row["load"] in LOADS}


def runs_of(dim, kind, seed):
    """For each packing a list of (distance from the truth, printed error), one for each load and time."""
    deck, cells = composite_of(dim, kind, seed)
    name = f"{dim}-{kind}-{seed}"
    grids = [cells // 2, cells] if dim == 3 or seed % 2 else cells
    packings = run(RESULTS, name, deck.replace("CELLS", str(grids)), "--seeds", str(PACKINGS[dim]))
    packing = (seed - 1) % PACKINGS[dim] + 1
    finer = [cells, 2 * cells] if dim == 3 else 4 * cells
    fine = run(RESULTS, f"{name}-fine", deck.replace("CELLS", str(finer)).replace(f"seed = {seed}", f"seed = {packing}"))
    if packings is None or fine is None:
        return []
    found = [moduli_of(path) for path in sorted(packings.glob("seed-*"))]
    one, better = moduli_of(packings / f"seed-{packing}"), moduli_of(fine)
    truth = {key: mean(moduli[key][0] for moduli in found) * better[key][0] / one[key][0] for key in one}
    return [[(modulus / truth[key] - 1.0, error) for key, (modulus, error) in moduli.items()] for moduli in found]


def is_held(value):
    distance, error = value
    return abs(distance) <= error


def main():
    dim = int(sys.argv[1]) if len(sys.argv) > 1 else 2
    first, last = (int(sys.argv[2]), int(sys.argv[3])) if len(sys.argv) > 3 else (1, {2: 100, 3: 40}[dim])
    found = {kind: [] for kind in KINDS[dim]}
    for seed in range(first, last + 1):
        kind = KINDS[dim][seed % len(KINDS[dim])]
        runs = runs_of(dim, kind, seed)
        found[kind].append(runs)
        values = [value for one in runs for value in one]
        known = [value for value in values if isfinite(value[1])]
        print(f"{dim}-{kind}-{seed}: {sum(map(is_held, known))} of {len(known)} values held, {len(values) - len(known)} without an "
              f"error; largest distance {max((abs(distance) for distance, _ in values), default=0.0):.1%}, error in the median "
              f"{median([error for _, error in known] or [0.0]):.1%}", file=sys.stderr, flush=True)
    print("| kind | composites | values with an error | held | runs held | distance, median | largest | error, median | largest |\n"
          "|---|---|---|---|---|---|---|---|---|")
    for kind, composites in [*found.items(), ("all", [runs for each in found.values() for runs in each])]:
        runs = [[value for value in one if isfinite(value[1])] for composite in composites for one in composite]
        values = [value for one in runs for value in one]
        if not values:
            continue
        whole = [all(map(is_held, one)) for one in runs if one]
        distances, errors = [abs(distance) for distance, _ in values], [error for _, error in values]
        print(f"| {kind} | {len(composites)} | {len(values)} of {sum(len(one) for composite in composites for one in composite)} "
              f"| {mean(map(is_held, values)):.1%} | {mean(whole):.0%} | {median(distances):.1%} | {max(distances):.0%} "
              f"| {median(errors):.1%} | {max(errors):.0%} |")


main()
