"""Reads the results of the figure decks."""

import csv
import json
from math import exp, log
from pathlib import Path

FIELDS = ("stage", "load", "boundary", "method", "cells")


def modulus_at(curve, time):
    """G [Pa] at a time [s] of a list of (time, modulus): a power of time between two samples."""
    for (t0, g0), (t1, g1) in zip(curve, curve[1:]):
        if t0 * (1 - 1e-9) <= time <= t1 * (1 + 1e-9):
            return g0 * exp(log(g1 / g0) * log(time / t0) / log(t1 / t0))
    raise ValueError(f"{time} s is outside of the curve")


class Curves:
    """The curves of a run or a sweep, by what tells them apart."""

    def __init__(self, directory):
        path = Path(directory) / "sweep.csv"
        if not path.exists():
            path = Path(directory) / "curves.csv"
        with open(path, newline="") as file:
            rows = list(csv.DictReader(file))
        keys = [name for name in rows[0] if name not in ("task", "time_s", "modulus_Pa")]
        # Of a swept key the last step of its path tells enough.
        self.names = [key if key in FIELDS else key.split(".")[-1] for key in keys]
        self.curves = {}
        for row in rows:
            point = (float(row["time_s"]), float(row["modulus_Pa"]))
            self.curves.setdefault(tuple(row[key] for key in keys), []).append(point)

    def one(self, **wanted):
        """The curve with the given values, the others being those of all that are left."""
        found = [curve for key, curve in self.curves.items()
                 if all(dict(zip(self.names, key)).get(name) == str(value) for name, value in wanted.items())]
        if len(found) != 1:
            raise ValueError(f"{len(found)} curves with {wanted}")
        return found[0]

    def at(self, time, **wanted):
        return modulus_at(self.one(**wanted), time)

    def largest_difference(self, first, second, **common):
        """Of one curve from another, relative, where both are known."""
        reference = self.one(**common, **second)
        ends = reference[0][0] * (1 - 1e-9), reference[-1][0] * (1 + 1e-9)
        return max(abs(g / modulus_at(reference, t) - 1) for t, g in self.one(**common, **first) if ends[0] <= t <= ends[1])


def study(directory):
    return json.loads((Path(directory) / "study.json").read_text())


def wall_time(directory):
    """Wall time of all runs [s]."""
    sweep = Path(directory) / "sweep.json"
    if sweep.exists():
        return sum(task["wall_time_s"] for task in json.loads(sweep.read_text())["tasks"])
    return study(directory)["wall_time_s"]


def runs(directory, stage):
    """The histories of the dynamic runs of a stage, each with its mass scaling factor, from the data of the report."""
    page = (Path(directory) / "report.html").read_text()
    begin = page.index('id="data">') + len('id="data">')
    histories = json.loads(page[begin:page.index("</script>", begin)])["histories"][stage]
    tests = next(one for one in study(directory)["stages"] if one["name"] == stage)["tests"]
    domains = next(test["time_domains"] for test in tests if "time_domains" in test)
    return [(domains[run["domain"]], list(zip(run["time_s"], run["value"]))) for run in histories]


def table(heads, rows):
    """A table in Markdown."""
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines) + "\n"


def digits(value, count=4):
    return f"{value:.{count}g}"


def percent(share):
    return f"{100 * share:.2g}" if abs(share) < 0.0995 else f"{100 * share:.0f}"
