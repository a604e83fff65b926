#!/usr/bin/env python3
"""What space changes: random discs and spheres of one size, of the same fraction and gap, in the same binder.

    examples/space/discs_and_spheres.py [FRACTION ...]      by default 0.1 to 0.5

The binder relaxes from 1 GPa to 1 kPa over seven decades, the filler has G = K = 10 GPa, the gaps have 5 % of the diameter.
Boxes are periodic: 60 discs with 20 cells across each (two grids would add nothing: a cell is as wide as the gap), 16
spheres likewise, three packings of each, all shears. The exponent s is that of R_3 = R_2^s, R being the modulus over
that of the binder. The program is `breccia` of the path, or BRECCIA of the environment; results are in
`results/discs-and-spheres`, or the directory RESULTS of the environment, and what is there is not run again."""

import csv
import os
import subprocess
import sys
from math import exp, log, pi
from pathlib import Path
from statistics import mean, stdev

RESULTS = Path(os.environ.get("RESULTS", "results/discs-and-spheres"))
PARTICLES, ACROSS, PACKINGS = {2: 60, 3: 16}, 20, 3


def binder(time):
    return 1e3 + sum(modulus * exp(-time / relaxation) for relaxation, modulus in terms())


def terms():
    """Terms whose remainders fall from 1 GPa to 1 kPa in geometric progression."""
    moduli = [1e9 * 10.0 ** (-6.0 * k / 7.0) for k in range(8)]
    return [(10.0 ** (k - 6), upper - lower) for k, (upper, lower) in enumerate(zip(moduli, moduli[1:]))]


def deck(dim, fraction):
    volume = pi / 4.0 if dim == 2 else pi / 6.0
    side = (PARTICLES[dim] * volume / fraction) ** (1.0 / dim)
    series = ", ".join(f'{{ time = "{time} s", modulus = "{modulus} Pa" }}' for time, modulus in terms())
    return f"""title = "{100 * fraction:.0f} % in {dim} dimensions"
dimensions = {dim}
[materials.binder]
density = "1 g/cm^3"
bulk = "3 GPa"
shear = {{ equilibrium = "1 kPa", terms = [{series}] }}
[materials.filler]
density = "2 g/cm^3"
bulk = "10 GPa"
shear = "10 GPa"
[[stages]]
name = "box"
matrix = "binder"
box = "{side:.6g} mm"
cells = {round(ACROSS * side)}
filler = {{ material = "filler", fraction = {fraction}, sizes = {{ diameter = "1 mm" }}, gap = "0.05 mm" }}
packing = {{ method = "lubachevsky-stillinger", walls = false }}
[tests]
times = ["1 us", "10 s"]
boundaries = ["periodic"]
loads = "isotropic"
mixing = "series"
points_per_decade = 1
fields = "none"
"""


def stiffening(dim, fraction):
    """ln R at each time, of every packing."""
    directory = RESULTS / f"{dim}-{100 * fraction:.0f}"
    if not (directory / "spread.csv").exists():
        RESULTS.mkdir(parents=True, exist_ok=True)
        path = RESULTS / f"{dim}-{100 * fraction:.0f}.toml"
        path.write_text(deck(dim, fraction))
        subprocess.run([os.environ.get("BRECCIA", "breccia"), "run", str(path), "--out", str(directory), "--overwrite",
                        "--quiet", "--threads", "1", "--seeds", str(PACKINGS)], check=True, stdout=subprocess.DEVNULL)
    found = {}
    with open(directory / "sweep.csv", newline="") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if row["load"] == "isotropic":
                time = float(row["time_s"])
                found.setdefault(time, []).append(log(float(row["modulus_Pa"]) / binder(time)))
    return found


def main():
    fractions = [float(word) for word in sys.argv[1:]] or [0.1, 0.2, 0.3, 0.4, 0.5]
    print("| fraction | time | filler over binder | R, discs | R, spheres | spheres over discs | scatter | s |\n"
          "|---|---|---|---|---|---|---|---|")
    for fraction in fractions:
        plane, space = stiffening(2, fraction), stiffening(3, fraction)
        for time in sorted(plane):
            two, three = mean(plane[time]), mean(space[time])
            scatter = (stdev(plane[time]) ** 2 + stdev(space[time]) ** 2) ** 0.5 / len(space[time]) ** 0.5
            print(f"| {fraction:.0%} | {time:.0e} s | {1e10 / binder(time):.0f} | {exp(two):.2f} | {exp(three):.2f} | "
                  f"{exp(three - two):.2f} | {scatter:.1%} | {three / two:.2f} |", flush=True)


main()
