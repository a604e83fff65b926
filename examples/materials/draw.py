#!/usr/bin/env python3
"""Draws the figures of docs/validation.md from the runs of evaluate.py, by gnuplot: validation-MATERIAL.svg.

    examples/materials/draw.py DIRECTORY

RESULTS of the environment is that of evaluate.py."""

import math
import subprocess
import sys
from pathlib import Path

from evaluate import DAY, HERE, RESULTS, modulus_of, of_stage, rows_of

COLOURS = ("#4477aa", "#cc6677", "#228833", "#777777")


def points(xy, colour, label):
    return list(xy), f'with points pt 7 ps 0.5 lc rgb "{colour}" title "{label}"'


def line(xy, colour, label):
    return list(xy), f'with lines lw 2 lc rgb "{colour}" title "{label}"'


def plot(path, x, y, curves, settings=""):
    data = "".join(f"$d{i} << EOD\n" + "".join(f"{a:.6g} {b:.6g}\n" for a, b in xy) + "EOD\n"
                   for i, (xy, _) in enumerate(curves))
    script = f"""set terminal svg size 720,440 font "sans-serif,14" background "white"
set logscale x
set format x "%g"
set grid lc rgb "#dddddd"
set key outside right top Left reverse samplen 2
set xlabel "{x}"
set ylabel "{y}"
{settings}
{data}
plot {", ".join(f"$d{i} {style}" for i, (_, style) in enumerate(curves))}
"""
    with open(path, "w", encoding="utf-8") as file:
        subprocess.run(["gnuplot"], input=script, text=True, stdout=file, check=True)


def concrete(path):
    curves = []
    for mix, colour in zip(("P28-10", "P50-0"), COLOURS):
        measured = rows_of(HERE / "concrete" / f"concrete_{mix}.csv")
        predicted = of_stage(RESULTS / f"concrete-{mix}-70-percent", "engineering.csv", "concrete")
        curves.append(points([(float(row["time_day"]), float(row["youngs_compliance_1_per_TPa"])) for row in measured
                              if float(row["time_day"]) < 110.0], colour, f"{mix}, measured"))
        curves.append(line([(float(row["time_s"]) / DAY, 1e12 * float(row["tensile_compliance_1_per_Pa"]))
                            for row in predicted], colour, f"{mix}, predicted"))
    plot(path, "time / d", "J(t) of the concrete / (1/TPa)", curves, "set yrange [0:*]")


def polyethylene(path):
    predicted = of_stage(RESULTS / "polyethylene", "engineering_dynamic.csv", "composite")
    of_matrix, of_composite = ([(float(row["frequency_Hz"]), float(row["youngs_storage_modulus_MPa"])) for row in
                                rows_of(HERE / "polyethylene-silica" / name)] for name in ("polyethylene.csv", "composite.csv"))
    plot(path, "frequency / Hz", "E' / MPa", [
        points(of_matrix, COLOURS[3], "polyethylene, measured"), points(of_composite, COLOURS[0], "with silica, measured"),
        line([(float(row["angular_frequency_rad_per_s"]) / math.tau, 1e-6 * float(row["youngs_storage_modulus_Pa"]))
              for row in predicted], COLOURS[0], "with silica, predicted")], "set yrange [400:*]")


def asphalt(path):
    laws = {(row["sample"], row["what"]): row for row in rows_of(HERE / "asphalt" / "parameters.csv")}
    omegas = [10.0 ** (0.25 * i) for i in range(-12, 10)]
    curves = []
    for sample, colour in zip(("H0", "W0", "W6"), COLOURS):
        curves.append(points([(omega, abs(modulus_of(laws[sample, "mixture"], omega))) for omega in omegas], colour,
                             f"{sample}, measured (2S2P1D)"))
        rows = of_stage(RESULTS / ("asphalt-grains" + ("" if sample == "H0" else f"-{sample}")), "engineering_dynamic.csv", "mixture")
        curves.append(line([(float(row["angular_frequency_rad_per_s"]), 1e-6 * abs(complex(
            float(row["youngs_storage_modulus_Pa"]), float(row["youngs_loss_modulus_Pa"])))) for row in rows], colour,
            f"{sample}, predicted as grains"))
    plot(path, "angular frequency / (rad/s)", "|E*| of the mixture / MPa", curves, 'set logscale y\nset format y "%g"')


def main():
    directory = Path(sys.argv[1])
    directory.mkdir(parents=True, exist_ok=True)
    for draw in (concrete, polyethylene, asphalt):
        draw(directory / f"validation-{draw.__name__}.svg")


if __name__ == "__main__":
    main()
