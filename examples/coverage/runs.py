"""Runs of decks for the studies beside it: each is run once, and what is in the directory of the results is not run again."""

import csv
import os
import subprocess
import sys
from pathlib import Path

DATA = str(Path(__file__).resolve().parents[2] / "data")


def run(results, name, deck, *options):
    """The directory of the results of a deck in `results`; nothing if it could not be run. The program is `breccia` of the
    path, or BRECCIA of the environment."""
    directory, status = results / name, results / f"{name}.status"
    if not status.exists():
        results.mkdir(parents=True, exist_ok=True)
        path = results / f"{name}.toml"
        path.write_text(deck.replace("../../data", DATA))
        command = [os.environ.get("BRECCIA", "breccia"), "run", str(path), "--out", str(directory), "--overwrite", "--quiet",
                   "--threads", "1", *options]
        finished = subprocess.run(command, capture_output=True, text=True)
        status.write_text(finished.stderr if finished.returncode else "")
    failure = status.read_text()
    if failure:
        print(f"{name}: {failure.strip()[:200]}", file=sys.stderr)
    return None if failure else directory


def rows_of(path):
    """The rows of a table without its comments."""
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))
