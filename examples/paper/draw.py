#!/usr/bin/env python3
"""Draws the figures of docs/reproducing-the-paper.md from the results of the figure decks, by gnuplot.

    examples/paper/draw.py RESULTS DIRECTORY [FIGURE...]

RESULTS holds a directory for each deck, fig01 and so on; DIRECTORY receives paper-fig02.svg and so on."""

import subprocess
import sys
from pathlib import Path

from evaluate import measured_modulus
from results import Curves, modulus_at, runs

MS, MPA = 1e-3, 1e6
COLOURS = ("#4477aa", "#228833", "#ccaa33", "#cc6677", "#7755bb", "#009999", "#bb5500", "#777777")


class Line:
    """A line of a plot: points (x, y) and how it looks."""

    def __init__(self, points, label="", colour="#222222", width=1.6, dash=1, marks=False):
        self.points, self.label = list(points), label
        style = "linespoints pt 7 ps 0.6" if marks else "lines"
        title = f'title "{label}"' if label else "notitle"
        self.command = f'with {style} lc rgb "{colour}" lw {width} dt {dash} {title}'


def plot(path, x, y, lines, settings=""):
    data = "".join(f"$d{i} << EOD\n" + "".join(f"{a:.6g} {b:.6g}\n" for a, b in line.points) + "EOD\n"
                   for i, line in enumerate(lines))
    script = f"""set terminal svg size 720,480 font "sans-serif,14" background "white"
set logscale xy
set format x "%g"
set format y "%g"
set grid lc rgb "#dddddd"
set key outside right top Left reverse samplen 2
set xlabel "{x}"
set ylabel "{y}"
{settings}
{data}
plot {", ".join(f"$d{i} {line.command}" for i, line in enumerate(lines))}
"""
    with open(path, "w") as file:
        subprocess.run(["gnuplot"], input=script, text=True, stdout=file, check=True)


def scaled(curve, x, y):
    return [(t / x, g / y) for t, g in curve if t > 0 and g > 0]


def fig01(directory, path):
    curves = Curves(directory)
    domain, history = runs(directory, "model")[0]
    begin = domain["valid_s"][0]
    linear = "unset logscale\nset key inside\nset yrange [0:*]"
    in_units = lambda points: [(t / MS, g / MPA) for t, g in points]
    plot(path, "time / ms", "G(t) / MPa", [
        Line(in_units(p for p in history if p[0] <= begin), "before it counts", "#99bbdd", 0.8),
        Line(in_units(p for p in history if p[0] >= begin), "dynamic", COLOURS[0], 1.2),
        Line(in_units(curves.one(method="quasistatic")), "quasi-static", width=2, dash=3)], linear)


def fig02(directory, path):
    curves, lines = Curves(directory), []
    for volumetric, dash in (("standard", 1), ("averaged", 2)):
        finest = {m: curves.one(resolution="64 /mm", volumetric=volumetric, method=m) for m in ("quasistatic", "dynamic")}
        for colour, resolution in zip(COLOURS, ("8 /mm", "16 /mm", "32 /mm")):
            curve = curves.one(resolution=resolution, volumetric=volumetric, method="dynamic")
            points = [(t / MS, g / modulus_at(finest["dynamic"], t) - 1) for t, g in curve]
            lines.append(Line(points, f"{resolution[:-4]} points/mm, {volumetric}", colour, 1.8, dash))
    plot(path, "time / ms", "deviation from 64 points/mm", lines)


def fig03(directory, path):
    curves, lines = Curves(directory), []
    for colour, r in zip(COLOURS, (8, 16, 32)):
        for stage, factor, dash in (("2mm", 1, 1), ("1mm", 2, 2)):
            at = lambda resolution: curves.one(stage=stage, resolution=f"{resolution} /mm", method="dynamic")
            reference = at(64 * factor)
            points = [(t / MS, g / modulus_at(reference, t) - 1) for t, g in at(r * factor)]
            lines.append(Line(points, f"{stage[0]} mm, {r * factor} points/mm", colour, 1.8, dash))
    plot(path, "time / ms", "deviation from the finest", lines)


def fig04(directory, path):
    curves = Curves(directory)
    lines = [Line(scaled(curves.one(seed=s, volumetric=v, method="dynamic"), MS, MPA), f"packing {s}, {v}", colour, 1.6, dash)
             for v, dash in (("standard", 1), ("averaged", 2)) for s, colour in zip((1, 2, 3), COLOURS)]
    plot(path, "time / ms", "G(t) / MPa", lines)


def fig05(directory, path):
    curves, lines = Curves(directory), []
    for case, colour in (("regular", COLOURS[0]), ("random", COLOURS[3])):
        for kind, dash in (("resolved", 1), ("two-stage", 2)):
            curve = curves.one(stage=f"{case}-{kind}", load="shear", method="dynamic")
            lines.append(Line(scaled(curve, MS, MPA), f"{case}, {kind}", colour, 1.8, dash))
    plot(path, "time / ms", "G(t) / MPa", lines)


def fig06(directory, path):
    lines = []
    for colour, (domain, history) in zip(COLOURS, runs(directory, "2mm")):
        begin = domain["valid_s"][0]
        lines.append(Line(scaled(history, MS, MPA), "", colour, 0.8))
        lines.append(Line(scaled([p for p in history if p[0] >= begin], MS, MPA),
                          f"density × {domain['density_factor']:g}", colour, 2.4))
    lines.append(Line(scaled(Curves(directory).one(method="quasistatic"), MS, MPA), "quasi-static", width=1.4, dash=3))
    plot(path, "time / ms", "G(t) / MPa", lines, "set xrange [0.05:100]\nset yrange [0.01:1]")


def fig08(directory, path):
    curves, lines = Curves(directory), []
    for volumetric, colour in (("standard", COLOURS[0]), ("averaged", COLOURS[3])):
        for method, dash in (("quasistatic", 1), ("dynamic", 2)):
            points = [(2 * cells / 0.048, curves.at(10 * MS, cells=cells, volumetric=volumetric, method=method) / MPA)
                      for cells in (50, 100, 150, 200, 300)]
            if method == "quasistatic":
                finest = Curves(directory.with_name(directory.name + "-600"))
                points.append((25000, finest.at(10 * MS, volumetric=volumetric) / MPA))
            lines.append(Line(points, f"{volumetric}, {method}", colour, 1.8, dash, marks=True))
    plot(path, "points / mm", "G(10 ms) / MPa", lines)


def fig09(directory, path):
    lines = []
    for colour, (domain, history) in zip(COLOURS, runs(directory, "HB-1")):
        begin = domain["valid_s"][0]
        lines.append(Line(scaled(history, 1, MPA), "", colour, 0.6))
        lines.append(Line(scaled([p for p in history if p[0] >= begin], 1, MPA),
                          f"density × {domain['density_factor']:g}", colour, 2.4))
    lines.append(Line(scaled(Curves(directory).one(method="quasistatic"), 1, MPA), "quasi-static", width=1.4, dash=3))
    plot(path, "time / s", "G(t) / MPa", lines, 'set format x "10^{%L}"\nset xrange [1e-9:1e-2]\nset yrange [100:4e3]')


def fig10(directory, path):
    curves, lines = Curves(directory), []
    limit = Curves(directory.with_name(directory.name + "-limit"))
    for boundary, bound, colour in (("displacement", "upper", COLOURS[0]), ("traction", "lower", COLOURS[3])):
        wanted = dict(stage="PBX-9501", load="shear", boundary=boundary)
        lines.append(Line(scaled(curves.one(method="dynamic", **wanted), 1, MPA), f"{bound}, dynamic, standard", colour, 2))
        lines.append(Line(scaled(limit.one(cells="extrapolated", **wanted), 1, MPA), f"{bound}, averaged, h → 0", colour, 2, 2))
    times = [10 ** (-8 + 0.05 * i) for i in range(121)]
    lines.append(Line([(t, measured_modulus(t) / MPA) for t in times], "measured", width=2.4))
    plot(path, "time / s", "G(t) / MPa", lines, 'set format x "10^{%L}"\nset xrange [1e-8:1e-2]')


def main():
    results, pictures = Path(sys.argv[1]), Path(sys.argv[2])
    for name in sys.argv[3:] or [f"fig{i:02}" for i in (1, 2, 3, 4, 5, 6, 8, 9, 10)]:
        globals()[name](results / name, pictures / f"paper-{name}.svg")


if __name__ == "__main__":
    if len(sys.argv) < 3 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    main()
