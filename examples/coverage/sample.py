#!/usr/bin/env python3
"""How much the modulus of a random periodic box scatters from packing to packing, against a rule for it (Eq. 43h of the
theory): standard deviation of ln M = a |ln (M / M of the matrix)| / sqrt(n), n the effective number of particles.

    examples/coverage/sample.py [DIMENSIONS [FIRST LAST]]      the composites from FIRST to LAST, by default 1 to 30

A composite is a kind of box, a fraction, a filler and a binder that relaxes by 10 to 1e5; it is computed for 16 packings
(in space 10) of 15 to 100 particles (12 to 30) with 7 cells (5) across the smallest one. A value is a modulus of one
packing at one decade of time; it is held where it lies within twice the deviation by the rule about the mean of all
packings. The means of both shears of the plane have a second row, with the error that the two shears of a box lower (Eq.
43i), and the share that is held of those that are lowered. The program is `breccia` of the path, or BRECCIA of the
environment; results are in `results/sample`, or the directory RESULTS of the environment, and what is there is not run
again."""

import os
import random
import sys
import tomllib
from math import exp, log, sqrt
from pathlib import Path
from statistics import mean, median, stdev

from boxes import box_of
from runs import rows_of, run

RESULTS = Path(os.environ.get("RESULTS", "results/sample"))
KINDS = {2: ["discs", "sizes", "ellipses", "polygons", "grains", "soft"], 3: ["spheres", "sizes", "soft"]}
APART = range(31, 37)  # composites of the plane whose discs have gaps of 8 to 20 %
PARTICLES = {2: (15, 100), 3: (12, 30)}
PACKINGS = {2: 16, 3: 10}
ACROSS = {2: 7, 3: 5}
# Factors a of the rule: of the mean of all shears, of one shear, and of the bulk modulus.
FACTORS = {"grains": (0.06, 0.18, 0.03), 2: (0.2, 0.33, 0.1), 3: (0.14, 0.33, 0.1)}


def kind_of(dim, seed):
    return "apart" if dim == 2 and seed in APART else KINDS[dim][seed % len(KINDS[dim])]


def composite_of(dim, kind, seed):
    """The deck of a composite."""
    draw = random.Random(f"particles {seed}")
    low, high = PARTICLES[dim]
    side, deck = box_of(dim, kind, seed, round(low * (high / low) ** draw.random()))
    deck = deck.replace("CELLS", str(round(ACROSS[dim] * side)))
    loads = '["shear", "shear-xx-yy", "bulk"]'
    assert loads in deck
    return deck.replace(loads, '["isotropic", "bulk"]').replace("points_per_decade = 5", "points_per_decade = 1")


def modulus_at(series, time):
    """A modulus of the deck at a time [Pa]."""
    if isinstance(series, str):
        return float(series.split()[0])
    value = float(series["equilibrium"].split()[0])
    return value + sum(float(term["modulus"].split()[0]) * exp(-time / float(term["time"].split()[0])) for term in series["terms"])


def matrix_modulus(binder, load, dim, time):
    """The modulus of the matrix under a load [Pa]."""
    shear, bulk = modulus_at(binder["shear"], time), modulus_at(binder["bulk"], time)
    return shear if load != "bulk" else bulk + shear / 3.0 if dim == 2 else bulk


def effective_number(path):
    """(sum of the volumes)^2 / sum of their squares of the particles of a box."""
    for name, column, power in (("grains.csv", "grain_area_m2", 1.0), ("microstructure.csv", "diameter_m", None),
                                ("polygons.csv", None, None)):
        if (path / name).exists():
            rows = rows_of(path / name)
            break
    if not rows:
        return 0.0
    if name == "polygons.csv":
        return float(len({row["particle"] for row in rows}))
    dim = 3 if "z_m" in rows[0] else 2
    if name == "grains.csv":
        volumes = [float(row.get("grain_area_m2") or row["grain_volume_m3"]) for row in rows]
    elif column in rows[0]:
        volumes = [float(row[column]) ** dim for row in rows]
    else:
        volumes = [float(row["axis_1_m"]) * float(row["axis_2_m"]) * float(row.get("axis_3_m", 1.0)) for row in rows]
    return sum(volumes) ** 2 / sum(volume**2 for volume in volumes)


def scatter_of(dim, kind, seed):
    """For each load: times with ln R, the deviation of ln M, each packing's distance from the mean, and how far its two
    shears have been apart so far; and n."""
    deck = composite_of(dim, kind, seed)
    directory = run(RESULTS, f"{dim}-{kind}-{seed}", deck, "--seeds", str(PACKINGS[dim]))
    if directory is None:
        return None
    binder = tomllib.loads(deck)["materials"]["binder"]
    found = {}
    for row in rows_of(directory / "sweep.csv"):
        found.setdefault((row["load"], float(row["time_s"])), []).append(log(float(row["modulus_Pa"])))
    apart, largest = {}, [0.0] * PACKINGS[dim]
    for time in sorted(time for load, time in found if load == "shear"):
        shears = zip(found["shear", time], found["shear-xx-yy", time])
        apart[time] = largest = [max(before, abs(one - other)) for before, (one, other) in zip(largest, shears)]
    numbers = [effective_number(path / "box") for path in sorted(directory.glob("seed-*"))]
    loads = {}
    for (load, time), values in found.items():
        ratio = mean(values) - log(matrix_modulus(binder, load, dim, time))
        distances = [value - mean(values) for value in values]
        loads.setdefault(load, []).append((time, ratio, stdev(values), distances, apart[time]))
    return mean(numbers), loads


def deviation_of_one(dim, kind, load, ratio):
    """The deviation by the rule, times the root of the number of particles."""
    mean_shear, one_shear, bulk = FACTORS.get(kind, FACTORS[dim])
    if load != "bulk":
        return (mean_shear if load == "isotropic" else one_shear) * abs(ratio)
    return 0.2 * min(-ratio, 2.0) if ratio < 0.0 else bulk * ratio


def print_lowered(lowered):
    """Prints the share of the means of both shears that is held by both equations."""
    print("\n| kind | held with the shears | lowered | held of these | error, median |\n|---|---|---|---|---|")
    for kind, values in [*lowered.items(), ("all", [value for values in lowered.values() for value in values])]:
        fewer = [is_held for is_held, is_lower, _ in values if is_lower]
        print(f"| {kind} | {mean(held for held, _, _ in values):.1%} | {len(fewer) / len(values):.0%} | "
              f"{mean(fewer) if fewer else 1.0:.1%} | {median(error for _, _, error in values):.2%} |")


def main():
    dim = int(sys.argv[1]) if len(sys.argv) > 1 else 2
    first, last = (int(sys.argv[2]), int(sys.argv[3])) if len(sys.argv) > 3 else (1, 30)
    found, lowered = {}, {}
    for seed in range(first, last + 1):
        kind = kind_of(dim, seed)
        known = scatter_of(dim, kind, seed)
        if known is None:
            continue
        number, loads = known
        for load, times in loads.items():
            name = load if load in ("isotropic", "bulk") else "one shear"
            rows = found.setdefault((name, "grains" if kind == "grains" else kind), [])
            for _, ratio, deviation, distances, apart in times:
                rule = deviation_of_one(dim, kind, load, ratio) / sqrt(number)
                # The mean of the packings has an error of its own.
                own = sqrt(1.0 - 1.0 / len(distances))
                held = sum(abs(distance) <= 2.0 * rule * own for distance in distances)
                rows.append((deviation * sqrt(number) / max(abs(ratio), 1e-3), deviation, rule, held, len(distances)))
                if dim == 2 and load == "isotropic":
                    errors = [min(2.0 * rule, max(rule, far / 0.35)) if ratio > 0.0 else 2.0 * rule for far in apart]
                    both = [(abs(distance) <= error * own, error < 2.0 * rule, error) for distance, error in zip(distances, errors)]
                    lowered.setdefault(kind, []).extend(both)
            print(kind, seed, f"n {number:.0f}", load, " ".join(
                f"[{ratio:.2f} {deviation:.2%} {deviation * sqrt(number) / max(abs(ratio), 1e-3):.2f}]"
                for _, ratio, deviation, *_ in times[::2]), file=sys.stderr, flush=True)
    print("| modulus | kind | values | held | a, median | a, largest | deviation, median | by the rule, median |\n"
          "|---|---|---|---|---|---|---|---|")
    for (load, kind), rows in sorted(found.items()):
        factors, deviations, rules, held, count = zip(*rows)
        print(f"| {load} | {kind} | {sum(count)} | {sum(held) / sum(count):.1%} | {median(factors):.3f} | {max(factors):.2f} | "
              f"{median(deviations):.2%} | {median(rules):.2%} |")
    if lowered:
        print_lowered(lowered)


main()
