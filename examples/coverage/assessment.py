#!/usr/bin/env python3
"""The bands and shares of `breccia assess` against brute force: 500 runs for two inputs, each run by itself.

    examples/coverage/assessment.py [RUNS]

Discs with an interphase whose modulus is known within a factor 1.5, in a binder whose relaxation times are known within a
factor 2 (DECK below). Each of RUNS runs (500 unless told) has values of its own for both. By Saltelli's design a quarter of
them, A, and another quarter, B, are independent, and in the other half A has one input of B in its place. The total index of
that input is half the mean of (a - ab)^2 over the variance (Jansen), and the first-order index of the other input is 1 less
that, with its standard error by bootstrap. The table has for each
decade the share by `assess`, by brute force with its standard error, and the share of the runs of A and B within the band of
95 % of `assess`. The program is `breccia` of the path, or BRECCIA of the environment; results are in `results/assessment`,
or the directory RESULTS of the environment."""

import math
import os
import random
import shutil
import subprocess
import sys
from pathlib import Path

from runs import rows_of

RESULTS = Path(os.environ.get("RESULTS", "results/assessment"))
BRECCIA = os.environ.get("BRECCIA", "breccia")
FACTORS = {"materials.interphase.shear": 1.5, "materials.binder.factors.times": 2.0}

DECK = """
[materials.binder]
density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { equilibrium = "1 MPa", terms = [
  { time = "100 us", modulus = "500 MPa" }, { time = "1 ms", modulus = "300 MPa" }, { time = "10 ms", modulus = "90 MPa" }] }
factors = { times = TIMES }

[materials.glass]
density = "2.5 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"

[materials.interphase]
density = "1.2 g/cm^3"
bulk    = "2 GPa"
shear   = SHEAR

[[stages]]
name    = "discs"
matrix  = "binder"
box     = "6 mm"
cells   = 24
filler  = { material = "glass", sizes = { diameter = "1.8 mm" }, coating = { material = "interphase", thickness = "0.4 mm" } }
packing = { method = "regular", columns = 2, rows = 2, walls = false }

[tests]
loads             = ["shear"]
times             = ["1 ms", "1 s"]
points_per_decade = 2
fields            = "none"
mixing            = "series"
"""


def breccia(*arguments):
    subprocess.run([BRECCIA, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def curve(scores):
    """ln G at all times of a run with these scores of the two inputs."""
    shear, times = (f"{FACTORS[name] ** score:.17g}" for name, score in zip(FACTORS, scores))
    deck, out = RESULTS / "one.toml", RESULTS / "one"
    text = DECK.replace("SHEAR", f'"{100 * float(shear):.17g} MPa"').replace("TIMES", times)
    deck.write_text(text, encoding="utf-8")
    shutil.rmtree(out, ignore_errors=True)
    breccia("run", deck, "--out", out, "--threads", 1, "--quiet")
    return [math.log(float(row["modulus_Pa"])) for row in rows_of(out / "curves.csv") if row["load"] == "shear"]


def first_order(a, b, ab):
    """The first-order index of one of two inputs, where ab has the other one from b (M. J. W. Jansen, Computer Physics
    Communications 117, 35-43, 1999)."""
    both = a + b
    mean = sum(both) / len(both)
    variance = sum((one - mean) ** 2 for one in both) / len(both)
    return 1.0 - sum((x - z) ** 2 for x, z in zip(a, ab)) / (2 * len(a)) / variance


def with_error(a, b, ab, draw):
    """The index and its standard error by bootstrap."""
    found = []
    for _ in range(400):
        chosen = [draw.randrange(len(a)) for _ in a]
        found.append(first_order(*([one[i] for i in chosen] for one in (a, b, ab))))
    mean = sum(found) / len(found)
    return first_order(a, b, ab), math.sqrt(sum((one - mean) ** 2 for one in found) / len(found))


def main():
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 500
    RESULTS.mkdir(parents=True, exist_ok=True)
    deck = RESULTS / "deck.toml"
    known = {"SHEAR": f'{{ value = "100 MPa", factor = {FACTORS["materials.interphase.shear"]} }}',
             "TIMES": f'{{ value = 1, factor = {FACTORS["materials.binder.factors.times"]} }}'}
    text = DECK
    for place, value in known.items():
        text = text.replace(place, value)
    deck.write_text(text, encoding="utf-8")
    breccia("assess", deck, "--out", RESULTS / "assessed", "--overwrite")
    bands = rows_of(RESULTS / "assessed" / "assess" / "bands.csv")
    shares = rows_of(RESULTS / "assessed" / "assess" / "sensitivity.csv")

    draw = random.Random(1)
    quarter = runs // 4
    scores_a, scores_b = ([[draw.gauss(0, 1) for _ in FACTORS] for _ in range(quarter)] for _ in range(2))
    a, b = ([curve(scores) for scores in many] for many in (scores_a, scores_b))
    mixed = [[curve([y[k] if k == i else x[k] for k in range(len(FACTORS))]) for x, y in zip(scores_a, scores_b)]
             for i in range(len(FACTORS))]

    print(f"{'time':>10}  {'within 95 %':>11}", *(f"{name:>44}" for name in FACTORS))
    for t, band in enumerate(bands):
        time = float(band["time_s"])
        if abs(math.log10(time) - round(math.log10(time))) > 1e-6:
            continue
        at = [[one[t] for one in many] for many in (a, b, *mixed)]
        ends = [math.log(float(band[end])) for end in ("inputs_lower_95", "inputs_upper_95")]
        within = sum(ends[0] <= one <= ends[1] for one in at[0] + at[1]) / (2 * quarter)
        line = f"{time:>10.3g}  {100 * within:>9.1f} %"
        for i, name in enumerate(FACTORS):
            index, error = with_error(at[0], at[1], at[2 + (1 - i)], draw)
            own = next(float(row["alone"]) for row in shares
                       if row["input"] == name and float(row["time_s"]) == time)
            line += f"  {100 * own:>20.1f} %, {100 * index:>5.1f} +- {100 * error:.1f} %"
        print(line, flush=True)


main()
