#!/usr/bin/env python3
"""Prints the tables of docs/studies/pbx9501-grains.md and draws its figure, by gnuplot.

    examples/grains/evaluate.py RESULTS [FIGURE]

RESULTS holds what examples/grains/run.sh has computed, a directory for each case."""

import csv
import subprocess
import sys
from math import exp, log
from pathlib import Path
from statistics import mean, stdev

ROOT = Path(__file__).resolve().parents[2]
TIMES = [10.0**decade for decade in range(-8, -1)]
SHEARS = ("shear", "shear-xx-yy")
MPA = 1e6


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def measured(time):
    """The measured relaxation modulus [Pa]."""
    rows = read(ROOT / "data" / "pbx9501_measured_relaxation.csv")
    return sum(float(row["shear_modulus_Pa"]) * exp(-time / float(row["relaxation_time_s"])) for row in rows)


class Case:
    """The moduli of the last stage of a run: the Prony series of each boundary and load."""

    def __init__(self, directory):
        rows = read(directory / "prony.csv")
        self.terms = {}
        for row in rows:
            if row["stage"] != rows[-1]["stage"]:
                continue
            term = float(row["relaxation_time_s"]), float(row["modulus_Pa"])
            self.terms.setdefault((row["boundary"], row["load"]), []).append(term)

    def boundaries(self):
        return list(dict.fromkeys(boundary for boundary, _ in self.terms))

    def modulus(self, boundary, load, time):
        return sum(g * exp(-time / tau) for tau, g in self.terms[boundary, load])

    def isotropic(self, boundary, time):
        """The mean of the two shears [Pa]: that of all orientations of the box in its plane."""
        return mean(self.modulus(boundary, load, time) for load in SHEARS)

    def curve(self, boundary="periodic", faster=1.0):
        """The mean of the two shears at TIMES [Pa], of a binder that relaxes `faster` by a factor."""
        return [self.isotropic(boundary, faster * time) for time in TIMES]


def row(name, values, form="{:.2f}"):
    print("| " + " | ".join([name, *(form.format(value) for value in values)]) + " |")


def head(title):
    print(f"\n| {title} | 10 ns | 100 ns | 1 µs | 10 µs | 100 µs | 1 ms | 10 ms |\n|" + "---|" * 8)


def over_measured(curve):
    return [modulus / measured(time) for modulus, time in zip(curve, TIMES)]


def tables(results):
    cases = {path.name: Case(path) for path in sorted(results.iterdir()) if (path / "prony.csv").exists()}
    head("MPa, mean of both shears")
    row("measured", [measured(time) / MPA for time in TIMES], "{:.0f}")
    for name, case in cases.items():
        for boundary in case.boundaries():
            row(f"{name}, {boundary}", [g / MPA for g in case.curve(boundary)], "{:.0f}")

    head("over the measured modulus")
    for name, case in cases.items():
        for boundary in case.boundaries():
            row(f"{name}, {boundary}", over_measured(case.curve(boundary)))
            row(f"{name}, {boundary}, 1.5e6 s", over_measured(case.curve(boundary, 10.0)))

    head("seeds: spread of one, per cent")
    for prefix in ("equal-32-seed", "equal-128-seed", "sizes-seed", "three-stages-seed"):
        curves = [case.curve() for name, case in cases.items() if name.startswith(prefix)]
        if len(curves) < 2:
            continue
        row(f"{prefix}: {len(curves)}", [100 * stdev(at) / mean(at) for at in zip(*curves)], "{:.1f}")
        shears = [case.modulus("periodic", load, time) for time in TIMES[-1:] for load in SHEARS
                  for name, case in cases.items() if name.startswith(prefix)]
        print(f"|   single shears at 10 ms: {100 * stdev(shears) / mean(shears):.0f} % |")
    return cases


def figure(cases, path):
    lines = (("equal-512-seed1", "periodic", "509 equal grains", "#4477aa", 1),
             ("equal-128-bounds", "displacement", "127 of them, upper bound", "#4477aa", 3),
             ("equal-128-bounds", "traction", "127 of them, lower bound", "#4477aa", 3),
             ("sizes-seed1", "periodic", "50 to 500 µm", "#cc6677", 1),
             ("sizes-wide", "periodic", "20 µm to 1 mm", "#ccaa33", 1),
             ("three-stages-seed1", "periodic", "all sizes, three stages", "#228833", 1))
    times = [10.0**(-8 + step / 20) for step in range(121)]
    data = "$measured << EOD\n" + "".join(f"{t:.6g} {measured(t) / MPA:.6g}\n" for t in times) + "EOD\n"
    plots = ['$measured with lines lc rgb "black" lw 2.4 title "measured"']
    for number, (name, boundary, label, colour, dash) in enumerate(lines):
        if name not in cases:
            continue
        data += f"$d{number} << EOD\n"
        data += "".join(f"{t:.6g} {cases[name].isotropic(boundary, t) / MPA:.6g}\n" for t in times) + "EOD\n"
        plots.append(f'$d{number} with lines lc rgb "{colour}" lw 1.8 dt {dash} title "{label}"')
    script = f"""set terminal svg size 720,480 font "sans-serif,14" background "white"
set logscale xy
set format x "10^{{%T}}"
set grid lc rgb "#dddddd"
set key bottom left samplen 2
set xlabel "time / s"
set ylabel "G(t) / MPa"
set xrange [1e-8:1e-2]
set yrange [100:6000]
{data}plot {", ".join(plots)}
"""
    with open(path, "w") as file:
        subprocess.run(["gnuplot"], input=script, text=True, stdout=file, check=True)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    cases = tables(Path(sys.argv[1]))
    if len(sys.argv) == 3:
        figure(cases, sys.argv[2])


if __name__ == "__main__":
    main()
