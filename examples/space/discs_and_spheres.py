#!/usr/bin/env python3
"""What space changes: random discs and spheres of the same fraction, sizes and gaps, in the same binder.

    examples/space/discs_and_spheres.py [KIND[:FRACTION,...] ...]      by default all kinds with their fractions

The binder relaxes from 1 GPa to 1 MPa over four decades. A kind is a filler, G = K = 10 GPa or, of "soft", 10 kPa; sizes,
all of one or, of "sizes", lognormal from 0.6 to 1.8 mm; and a gap, 5 % of a diameter or, of "apart", 15 %, of "close" 2 %.
Boxes are periodic: 60 discs with 20 cells across each, eight packings; 16 spheres with 16 cells across, two packings; all
shears. The exponent s is that of R_3 = R_2^s, R being the modulus over that of the binder. The program is `breccia` of the
path, or BRECCIA of the environment; results are in `results/discs-and-spheres`, or the directory RESULTS of the
environment, and what is there is not run again."""

import csv
import os
import subprocess
import sys
from dataclasses import dataclass
from math import exp, log, pi
from pathlib import Path
from statistics import mean, stdev

RESULTS = Path(os.environ.get("RESULTS", "results/discs-and-spheres"))
PARTICLES, ACROSS, PACKINGS = {2: 60, 3: 16}, {2: 20, 3: 16}, {2: 8, 3: 2}
ONE_SIZE = 'sizes = { diameter = "1 mm" }'
SIZES = 'sizes = { lognormal = [{ median = "1 mm", sigma = 0.4 }] }, from = "0.6 mm", to = "1.8 mm"'


@dataclass
class Kind:
    fractions: tuple
    filler: str = "10 GPa"
    sizes: str = ONE_SIZE
    gap: float = 0.05


KINDS = {"equal": Kind((0.1, 0.2, 0.3, 0.4, 0.5)), "apart": Kind((0.2, 0.4), gap=0.15), "close": Kind((0.3, 0.5), gap=0.02),
         "sizes": Kind((0.3, 0.5), sizes=SIZES), "soft": Kind((0.1, 0.3), filler="10 kPa")}


def binder(time):
    return 1e6 + sum(modulus * exp(-time / relaxation) for relaxation, modulus in terms())


def terms():
    """Terms whose remainders fall from 1 GPa to 1 MPa in geometric progression."""
    moduli = [1e9 * 10.0 ** (-3.0 * k / 4.0) for k in range(5)]
    return [(10.0 ** (k - 6), upper - lower) for k, (upper, lower) in enumerate(zip(moduli, moduli[1:]))]


def deck(dim, kind, fraction):
    volume = pi / 4.0 if dim == 2 else pi / 6.0
    side = (PARTICLES[dim] * volume / fraction) ** (1.0 / dim)
    of = KINDS[kind]
    series = ", ".join(f'{{ time = "{time} s", modulus = "{modulus} Pa" }}' for time, modulus in terms())
    return f"""title = "{kind}, {100 * fraction:.0f} % in {dim} dimensions"
dimensions = {dim}
[materials.binder]
density = "1 g/cm^3"
bulk = "3 GPa"
shear = {{ equilibrium = "1 MPa", terms = [{series}] }}
[materials.filler]
density = "2 g/cm^3"
bulk = "{of.filler}"
shear = "{of.filler}"
[[stages]]
name = "box"
matrix = "binder"
box = "{side:.6g} mm"
cells = {round(ACROSS[dim] * side)}
filler = {{ material = "filler", fraction = {fraction}, {of.sizes}, gap = "{of.gap} mm" }}
packing = {{ method = "lubachevsky-stillinger", walls = false }}
[tests]
times = ["1 us", "10 ms"]
boundaries = ["periodic"]
loads = "isotropic"
mixing = "series"
points_per_decade = 1
fields = "none"
"""


def stiffening(dim, kind, fraction):
    """ln R at each time, of every packing."""
    directory = RESULTS / f"{dim}-{kind}-{100 * fraction:.0f}"
    if not (directory / "spread.csv").exists():
        RESULTS.mkdir(parents=True, exist_ok=True)
        path = directory.with_suffix(".toml")
        path.write_text(deck(dim, kind, fraction))
        subprocess.run([os.environ.get("BRECCIA", "breccia"), "run", str(path), "--out", str(directory), "--overwrite",
                        "--quiet", "--threads", "1", "--seeds", str(PACKINGS[dim])], check=True, stdout=subprocess.DEVNULL)
    found = {}
    with open(directory / "sweep.csv", newline="") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if row["load"] == "isotropic":
                time = float(row["time_s"])
                found.setdefault(time, []).append(log(float(row["modulus_Pa"]) / binder(time)))
    return found


def print_rows(kind, fraction):
    plane, space = stiffening(2, kind, fraction), stiffening(3, kind, fraction)
    for time in sorted(plane):
        two, three = mean(plane[time]), mean(space[time])
        scatter = sum(stdev(of[time]) ** 2 / len(of[time]) for of in (plane, space)) ** 0.5
        contrast = float(KINDS[kind].filler.split()[0]) * {"GPa": 1e9, "kPa": 1e3}[KINDS[kind].filler.split()[1]] / binder(time)
        print(f"| {kind} | {fraction:.0%} | {contrast:.2g} | {exp(two):.2f} | {exp(three):.2f} | {exp(three - two):.2f} | "
              f"{scatter:.1%} | {three / two:.2f} |", flush=True)


def main():
    print("| kind | fraction | filler over binder | R, discs | R, spheres | spheres over discs | scatter | s |\n"
          "|---|---|---|---|---|---|---|---|")
    for word in sys.argv[1:] or KINDS:
        kind, _, fractions = word.partition(":")
        for fraction in map(float, fractions.split(",")) if fractions else KINDS[kind].fractions:
            print_rows(kind, fraction)


main()
