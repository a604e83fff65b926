#!/usr/bin/env python3
"""How often the intervals of `breccia calibrate` hold the truth: a binder of 22 terms, and two scalars, found back from G(t)
of grains and films with noise.

    examples/coverage/calibration.py [SEEDS]

The composite is PBX-9501 of examples/pbx9501-films.toml in a box of 0.9 mm. Its own G(t), ten values a decade from 10 ns to
1 s, gets 1 % of noise for each of SEEDS seeds (100 unless told). Unknown are the moduli of the 22 terms at their times; then
the factors of the binder's times and moduli together. The tables say for each unknown how often the 95 % interval holds the
truth, and what the data have taught on average. The last table has a second composite of the same binder, with half as much
binder in its films: how wide the intervals are, on average over the terms and the seeds, from each alone and from both. The
program is `breccia` of the path, or BRECCIA of the environment; results are in `results/calibration`, or the directory
RESULTS of the environment."""

import math
import os
import random
import subprocess
import sys
import time
from pathlib import Path

from runs import rows_of

EXAMPLES = Path(__file__).resolve().parent.parent
RESULTS = Path(os.environ.get("RESULTS", "results/calibration"))
BRECCIA = os.environ.get("BRECCIA", "breccia")
NOISE = 0.01


def breccia(*arguments):
    subprocess.run([BRECCIA, *arguments], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def solved(name, *settings):
    """The directory of a run, which is made once."""
    run = RESULTS / name
    options = [part for setting in ("stages.0.box=0.9 mm", 'tests.times=["10 ns", "1 s"]', *settings)
               for part in ("--set", setting)]
    if not (run / "study.json").exists():
        breccia("run", EXAMPLES / "pbx9501-films.toml", *options, "--out", run)
    return run


def measured(run, seed):
    """A file with the curve of the run and noise."""
    draw = random.Random(seed)
    path = RESULTS / f"{run.name}-measured-{seed}.csv"
    rows = [row for row in rows_of(run / "curves.csv") if row["load"] == "isotropic"]
    lines = [f"{row['time_s']},{float(row['modulus_Pa']) * math.exp(draw.gauss(0.0, NOISE))}\n" for row in rows[::2]]
    path.write_text("time_s,shear_modulus_Pa\n" + "".join(lines), encoding="utf-8")
    return path


def table_of(name, run, seeds, unknowns, truth):
    """Prints how often the intervals hold the truth, by unknown."""
    held, learned, seconds = [0] * len(truth), [0.0] * len(truth), 0.0
    for seed in range(1, seeds + 1):
        out = RESULTS / f"{name}-{seed}"
        start = time.perf_counter()
        options = [part for unknown in unknowns for part in ("--unknown", unknown)]
        breccia("calibrate", run, "--measured", measured(run, seed), *options, "--out", out, "--overwrite", "--quiet")
        seconds += time.perf_counter() - start
        rows = rows_of(out / "estimates.csv")
        assert len(rows) == len(truth), rows
        for i, (row, true) in enumerate(zip(rows, truth)):
            held[i] += float(row["lower_95"]) <= true <= float(row["upper_95"])
            learned[i] += float(row["learned"]) / seeds
    print(f"\n{'unknown':32} {'truth':>10}   held  learned")
    for row, true, count, share in zip(rows, truth, held, learned):
        print(f"{row['unknown']:32} {true:10.4g}  {100 * count / seeds:4.0f} %  {100 * share:4.0f} %")
    print(f"all: {100 * sum(held) / (seeds * len(truth)):.1f} % of {seeds * len(truth)}, {seconds / seeds:.2f} s each")


def widths_of(name, measured_runs, unknown):
    """The logarithms of upper over lower end of the 95 % intervals."""
    out = RESULTS / name
    data = [part for run, file in measured_runs for part in ("--measured", f"{run.name}={file}")]
    breccia("calibrate", *[run for run, _ in measured_runs], *data, "--unknown", unknown, "--out", out, "--overwrite",
            "--quiet")
    return [math.log(float(row["upper_95"]) / float(row["lower_95"])) for row in rows_of(out / "estimates.csv")]


def table_of_two(runs, seeds, unknown):
    """Prints how wide the intervals of a spectrum are, from one composite and from two."""
    cases = {**{run.name: [run] for run in runs}, "both": runs}
    print(f"\n{'composites':12}  ln(upper / lower), mean over the terms, {seeds} seeds")
    for name, those in cases.items():
        widths = [sum(each) / len(each) for each in (
            widths_of(f"two-{name}-{seed}", [(run, measured(run, seed + 1000 * i)) for i, run in enumerate(those)], unknown)
            for seed in range(1, seeds + 1))]
        print(f"{name:12}  {sum(widths) / seeds:.3f}")


def main():
    seeds = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    RESULTS.mkdir(parents=True, exist_ok=True)
    run = solved("run")
    terms = rows_of(EXAMPLES.parent / "data" / "pbx9501_binder_prony.csv")
    times = [float(row["relaxation_time_s"]) for row in terms]
    spectrum = f'binder.spectrum={{ from = "{min(times)} s", to = "{max(times)} s", per_decade = 1 }}'
    table_of("spectrum", run, seeds, [spectrum], [float(row["shear_modulus_Pa"]) for row in reversed(terms)])
    table_of("scalars", run, seeds, ["binder.times", "binder.modulus"], [1.0, 1.0])
    table_of_two([run, solved("fuller", "stages.0.filler.fraction=0.964")], min(seeds, 20), spectrum)


if __name__ == "__main__":
    main()
