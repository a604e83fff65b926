#!/usr/bin/env python3
"""Prints the tables of docs/studies/pbx9501-films.md and draws its figure, by gnuplot.

    examples/films/evaluate.py RESULTS [FIGURE]

RESULTS holds what examples/films/run.sh has computed, a directory for each case."""

import subprocess
import sys
from pathlib import Path
from statistics import mean, stdev

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "grains"))

from evaluate import MPA, Case, head, over_measured, row  # noqa: E402


def curves(results, pattern, boundary="periodic"):
    """The curves [Pa] of all seeds."""
    done = (directory for directory in sorted(results.glob(pattern)) if (directory / "prony.csv").exists())
    return [Case(directory).curve(boundary) for directory in done]


def mean_of(curves):
    return [mean(values) for values in zip(*curves)]


def spread_of(curves):
    """Standard deviation of one box over the mean [%]."""
    return [100.0 * stdev(values) / mean(values) for values in zip(*curves)]


def figure(found, path):
    """Moduli over the number of grains under the three boundaries, with the standard deviation of a single box."""
    names = {"displacement": "displacement (upper bound)", "periodic": "periodic", "traction": "traction (lower bound)"}
    colours = {"displacement": "#c44e52", "periodic": "#222222", "traction": "#4c72b0"}
    data, plots = "", []
    for boundary, name in names.items():
        for time, label in ((2, "1 µs"), (6, "10 ms")):
            block = f"${boundary}_{time}"
            data += f"{block} << EOD\n"
            for (count, of_boundary), values in found.items():
                if of_boundary != boundary:
                    continue
                moduli = [curve[time] / MPA for curve in values]
                data += f"{count} {mean(moduli)} {stdev(moduli)}\n"
            data += "EOD\n"
            style = f'with errorlines lc rgb "{colours[boundary]}" lw 1.5 pt 7 ps 0.6'
            title = f'title "{name}"' if time == 2 else "notitle"
            plots.append(f"{block} using 1:2:3 {style} {title}")
    script = f"""set terminal svg size 720,460 font "sans,13" background "white"
set logscale xy
set xlabel "number of grains in the box"
set ylabel "G / MPa"
set xrange [18:1500]
set yrange [300:5000]
set ytics (400, 600, 1000, 2000, 4000)
set xtics (25, 100, 400, 1000)
set key bottom right
set label "1 µs" at 1060, 3110
set label "10 ms" at 1060, 880
{data}plot {", ".join(plots)}
"""
    with open(path, "w") as file:
        subprocess.run(["gnuplot"], input=script, text=True, stdout=file, check=True)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    results = Path(sys.argv[1])
    head("G [MPa], mean of both shears and of the seeds")
    counts = [(count, boundary) for count in (25, 100, 400, 1000) for boundary in ("displacement", "periodic", "traction")]
    found = {}
    for count, boundary in counts:
        pattern = f"periodic-{count}-*" if boundary == "periodic" else f"bounds-{count}-*"
        found[count, boundary] = curves(results, pattern, boundary)
        row(f"{count} grains, {boundary}", [value / MPA for value in mean_of(found[count, boundary])], "{:.0f}")
    head("standard deviation of one box [%]")
    for count, boundary in counts:
        row(f"{count} grains, {boundary}", spread_of(found[count, boundary]), "{:.1f}")
    row("50 to 500 µm, periodic", spread_of(curves(results, "sizes-50-*")), "{:.1f}")

    head("halved elements over the default ones [%]")
    for name, coarse in (("mesh-400", "periodic-400-seed1"), ("mesh-sizes", "sizes-50-seed1")):
        pair = Case(results / name).curve(), Case(results / coarse).curve()
        row(name, [100.0 * (fine / rough - 1.0) for fine, rough in zip(*pair)], "{:+.2f}")

    head("over the measured modulus")
    for name, pattern in (
        ("1000 grains of one size", "periodic-1000-*"),
        ("90 %, 400 grains", "fraction-0.90"),
        ("92 %, 400 grains", "fraction-0.92"),
        ("93.7 %, 400 grains", "periodic-400-*"),
        ("95 %, 400 grains", "fraction-0.95"),
        ("50 to 500 µm", "sizes-50-*"),
        ("20 µm to 1 mm", "sizes-20-*"),
        ("10 µm to 1 mm", "sizes-10"),
    ):
        if of_case := curves(results, pattern):
            row(name, over_measured(mean_of(of_case)))
    for boundary in ("displacement", "traction"):
        if of_case := curves(results, "bounds-50-*", boundary):
            row(f"50 to 500 µm, {boundary}", over_measured(mean_of(of_case)))
    faster = [Case(directory).curve(faster=10.0) for directory in sorted(results.glob("periodic-1000-*"))]
    row("1000 grains, binder ten times faster", over_measured(mean_of(faster)))
    if len(sys.argv) == 3:
        figure(found, sys.argv[2])


if __name__ == "__main__":
    main()
