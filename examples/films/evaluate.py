#!/usr/bin/env python3
"""Prints the tables of "Grains and films" in docs/pbx9501-grains.md.

    examples/films/evaluate.py RESULTS

RESULTS holds what examples/films/run.sh has computed, a directory for each case."""

import sys
from pathlib import Path
from statistics import mean, stdev

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "grains"))

from evaluate import MPA, Case, head, over_measured, row  # noqa: E402


def curves(results, pattern, boundary="periodic"):
    """The curves [Pa] of all seeds."""
    return [Case(directory).curve(boundary) for directory in sorted(results.glob(pattern))]


def mean_of(curves):
    return [mean(values) for values in zip(*curves)]


def spread_of(curves):
    """Standard deviation of one box over the mean [%]."""
    return [100.0 * stdev(values) / mean(values) for values in zip(*curves)]


def main():
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
    faster = [Case(directory).curve(faster=10.0) for directory in sorted(results.glob("periodic-1000-*"))]
    row("1000 grains, binder ten times faster", over_measured(mean_of(faster)))


if __name__ == "__main__":
    main()
