#!/usr/bin/env python3
"""PBX-9501 of spheres and of discs: runs the decks, prints the tables of docs/two-or-three-dimensions.md and draws its figure.

    examples/space/two_or_three.py [FIGURE]

Half an hour of processor time. What has been run before is read and not run again. The program is `breccia` of the path, or
BRECCIA of the environment; results are in `results/space`, or the directory RESULTS of the environment."""

import json
import subprocess
import sys
from math import exp, isinf

from runs import RESULTS, ROOT, directory_of, read

TIMES = [1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2]
MPA = 1e6

THREE, FOUR, GRAINS = "../pbx9501-3d.toml", "four-stages.toml", "../pbx9501-grains-3d.toml"
CASES = {  # name: deck, keys
    "three-24": (THREE, {"stages.*.cells": 24}),
    "three-48": (THREE, {}),
    "three-96": (THREE, {"stages.*.cells": 96, "tests.fields": '"none"'}),
    "three-discs": (THREE, {"dimensions": 2, "stages.*.cells": 375}),
    "four-24": (FOUR, {"stages.*.cells": 24}),
    "four-32": (FOUR, {}),
    "four-discs": (FOUR, {"dimensions": 2, "stages.*.cells": 200}),
    "grains-48": (GRAINS, {}),
}


def moduli(directory):
    """Shear moduli [Pa] at the times of each stage and load, by Prony series."""
    series = {}
    for row in read(directory / "prony.csv"):
        if row["load"].startswith("shear"):
            term = float(row["relaxation_time_s"]), float(row["modulus_Pa"])
            series.setdefault((row["stage"], row["load"]), []).append(term)
    return {key: [modulus_of(terms, time) for time in TIMES] for key, terms in series.items()}


def modulus_of(terms, time):
    return sum(modulus * (1.0 if isinf(tau) else exp(-time / tau)) for tau, modulus in terms)


def measured():
    table = read(ROOT / "data" / "pbx9501_measured_relaxation.csv")
    terms = [(float(row["relaxation_time_s"]), float(row["shear_modulus_Pa"])) for row in table]
    return [modulus_of(terms, time) for time in TIMES]


def line(name, values, form="{:.4g}"):
    print("| " + " | ".join([name, *(form.format(value) for value in values)]) + " |")


def ratio(some, others):
    return [one / other for one, other in zip(some, others)]


def figure(curves, path):
    """Moduli [MPa] over time, one curve for each name."""
    data, plots = "", []
    for number, (name, style, values) in enumerate(curves):
        block = f"$c{number}"
        points = "".join(f"{time} {value / MPA}\n" for time, value in zip(TIMES, values))
        data += f"{block} << EOD\n{points}EOD\n"
        plots.append(f'{block} using 1:2 with linespoints {style} title "{name}"')
    script = f"""set terminal svg size 720,460 font "sans,13" background "white"
set logscale xy
set format x "10^{{%T}}"
set xlabel "time [s]"
set ylabel "shear modulus [MPa]"
set grid
set key bottom left
set xrange [1e-8:1e-2]
set yrange [100:6000]
{data}plot {", ".join(plots)}
"""
    with open(path, "w") as file:
        subprocess.run(["gnuplot"], input=script, text=True, stdout=file, check=True)


def main():
    if len(sys.argv) > 2:
        sys.exit(__doc__)
    found = {name: moduli(directory_of(name, *CASES[name])) for name in CASES}
    for name in CASES:
        print(f"\n{name}, G [MPa]")
        for (stage, load), values in found[name].items():
            line(f"{stage} {load}", [value / MPA for value in values])
    for spheres, discs in (("three-48", "three-discs"), ("three-96", "three-discs"), ("four-32", "four-discs")):
        print(f"\n{spheres} over {discs}")
        for (stage, load), values in found[spheres].items():
            line(stage, ratio(values, found[discs][stage, load]), "{:.2f}")
    print("\nover the measured modulus")
    for name in CASES:
        for (stage, load), values in found[name].items():
            if stage == "PBX-9501":
                line(f"{name} {load}", ratio(values, measured()), "{:.2f}")
    print("\nprocessor seconds and memory [MB]")
    for name in CASES:
        cost = json.loads((RESULTS / name / "cost.json").read_text())
        print(name, f"{cost['processor_s']:.0f}", f"{cost['memory_B'] / 1e6:.0f}")
    if len(sys.argv) == 2:
        last = ("PBX-9501", "shear")
        figure(
            [
                ("measured", 'lc "#222222" lw 2 pt 7 ps 0.5', measured()),
                ("spheres, three stages, 96 cells", 'lc "#c44e52" lw 2 pt 5 ps 0.5', found["three-96"][last]),
                ("spheres, three stages, 24 cells", 'lc "#c44e52" dt 2 pt 4 ps 0.5', found["three-24"][last]),
                ("discs, three stages", 'lc "#c44e52" dt 3 lw 2 pt 6 ps 0.7', found["three-discs"][last]),
                ("spheres, four stages, 32 cells", 'lc "#4c72b0" lw 2 pt 9 ps 0.6', found["four-32"][last]),
                ("discs, four stages", 'lc "#4c72b0" dt 3 lw 2 pt 10 ps 0.7', found["four-discs"][last]),
            ],
            sys.argv[1],
        )


if __name__ == "__main__":
    main()
