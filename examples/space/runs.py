"""Runs of decks, and what they leave: for the scripts beside this file.

`measured(name, deck, keys)` runs a deck with some of its keys replaced, on one thread, and returns the results. What has been
run before is read and not run again. The program is `breccia` of the path, or BRECCIA of the environment; results are in
`results/space`, or the directory RESULTS of the environment."""

import csv
import json
import os
import subprocess
import sys
from math import exp
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
REFERENCE = ROOT / "tests" / "reference"
RESULTS = Path(os.environ.get("RESULTS", "results/space"))


def read(path):
    """The rows of a table as dictionaries, without its comments."""
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


class Run:
    """The results of a run of one stage on one grid."""

    def __init__(self, directory):
        self.terms = {}
        for row in read(directory / "prony.csv"):
            term = float(row["relaxation_time_s"]), float(row["modulus_Pa"])
            self.terms.setdefault((row["boundary"], row["load"]), []).append(term)
        stage = json.loads((directory / "study.json").read_text())["stages"][0]
        self.iterations = {test["boundary"]: test["linear"]["most_iterations"] for test in stage["tests"]}
        self.unknowns = stage["tests"][0]["linear"]["unknowns"]
        cost = json.loads((directory / "cost.json").read_text())
        self.processor_seconds = cost["processor_s"]
        self.memory = cost["memory_B"]

    def modulus(self, load, time=0.0, boundary="periodic"):
        """The relaxation modulus [Pa] at a time [s]."""
        return sum(m * exp(-time / tau) for tau, m in self.terms[boundary, load])


def directory_of(name, deck, keys):
    """The results of a deck with these keys, as TOML; those of an earlier run of the same name if there are any."""
    directory = RESULTS / name
    if not (directory / "cost.json").exists():
        command = [os.environ.get("BRECCIA", "breccia"), "run", str(HERE / deck), "--out", str(directory)]
        command += ["--threads", "1", "--quiet", "--overwrite"]
        for key, value in keys.items():
            command += ["--set", f"{key}={value}"]
        process = subprocess.Popen(command)
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            sys.exit(f"{' '.join(command)}: failed")
        cost = {"processor_s": usage.ru_utime + usage.ru_stime, "memory_B": 1024 * usage.ru_maxrss}
        (directory / "cost.json").write_text(json.dumps(cost) + "\n")
    return directory


def measured(name, deck, keys):
    """The same for a deck of one stage, read."""
    return Run(directory_of(name, deck, keys))


def row(*cells):
    """Prints a row of a table."""
    print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)


def header(*cells):
    row(*cells)
    row(*["---"] * len(cells))
