"""Results of earlier runs, from their directories."""

from __future__ import annotations

import json
import os
from pathlib import Path

from . import _native
from ._errors import InputError
from ._quantities import PathLike


def read_results(directory: PathLike) -> _native.Result:
    """The results that `breccia run` or run() has left in a directory, complete or not.

    They have what a Result has but for the microstructures and the fields, which are files of their own there; of
    several methods and grids the series of the preferred one. respond() and export() take them. Raises InputError where
    the directory has no results of a study, and FileError.
    """
    return _native.read_results(os.fspath(directory))


def read_sweep_results(directory: PathLike) -> dict[str, _native.Result]:
    """The results of the finished tasks of a sweep by their names, from its directory. Raises as read_results()."""
    record = Path(directory, "sweep.json")
    if not record.is_file():
        raise InputError(f"{os.fspath(directory)}: no sweep.json, which `breccia run` writes for a sweep")
    tasks = json.loads(record.read_text(encoding="utf-8"))["tasks"]
    return {task["name"]: read_results(Path(directory, task["name"])) for task in tasks if task["state"] == "done"}
