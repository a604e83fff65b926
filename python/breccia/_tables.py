"""Results as tables in long form, with columns named as in the files that `breccia run` writes."""

from __future__ import annotations

import math
from typing import Any, Callable, Union

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._errors import InputError

Column = Union["list[str]", NDArray[np.float64]]
Table = dict[str, Column]
_Part = tuple[dict[str, str], dict[str, Any]]


def _test_columns(stage: _native.StageResult, test: Any) -> dict[str, str]:
    return {"stage": stage.name, "load": test.load, "boundary": test.boundary, "method": test.method}


def _grid_of(test: _native.TestResult) -> str:
    return str(test.grid)


def _unknown_like(values: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.full(len(values), math.nan)


def _curves(stage: _native.StageResult) -> list[_Part]:
    parts: list[_Part] = []
    for test in stage.tests:
        error = test.error if len(test.error) else _unknown_like(test.time)
        parts.append(({**_test_columns(stage, test), "cells": _grid_of(test)},
                      {"time_s": test.time, "modulus_Pa": test.modulus, "error": error}))
    return parts


def _dynamic(stage: _native.StageResult) -> list[_Part]:
    return [({**_test_columns(stage, test), "cells": _grid_of(test)},
             {"angular_frequency_rad_per_s": test.in_frequency.angular_frequency,
              "frequency_Hz": test.in_frequency.frequency, "storage_modulus_Pa": test.in_frequency.storage,
              "loss_modulus_Pa": test.in_frequency.loss, "loss_tangent": test.in_frequency.loss_tangent,
              "absolute_modulus_Pa": test.in_frequency.absolute, "phase_angle_deg": test.in_frequency.phase,
              "error": test.in_frequency.error})
            for test in stage.tests if len(test.in_frequency)]


def _engineering_moduli(stage: _native.StageResult) -> list[_native.EngineeringModuli]:
    """Those of each boundary condition under which a stage was tested in shear and in bulk."""
    found = []
    for boundary in dict.fromkeys(test.boundary for test in stage.tests):
        try:
            found.append(stage.engineering(boundary))
        except InputError:
            pass
    return found


def _engineering(stage: _native.StageResult) -> list[_Part]:
    return [(_test_columns(stage, moduli),
             {"time_s": moduli.time, "shear_modulus_Pa": moduli.shear, "bulk_modulus_Pa": moduli.bulk,
              "youngs_modulus_Pa": moduli.young, "poisson_ratio": moduli.poisson,
              "tensile_compliance_1_per_Pa": moduli.tensile_compliance, "bulk_modulus_error": moduli.bulk_error,
              "youngs_modulus_error": moduli.young_error, "poisson_ratio_error": moduli.poisson_error})
            for moduli in _engineering_moduli(stage)]


def _comparison(stage: _native.StageResult) -> list[_Part]:
    return [({"measurement": one["measurement"], "modulus": one["kind"], "stage": stage.name,
              "boundary": one["boundary"], "method": one["method"]},
             {"time_s": one["time"], "modulus_Pa": one["modulus"], "measured_Pa": one["measured"],
              "ratio": one["modulus"] / one["measured"], "error": one["error"]})
            for one in stage.comparisons if len(one["time"])]


_KINDS: dict[str, Callable[[_native.StageResult], list[_Part]]] = {
    "curves": _curves, "dynamic": _dynamic, "engineering": _engineering, "comparison": _comparison}


def stage_table(self: _native.StageResult, kind: str = "curves") -> Table:
    """A table of the stage in long form, a list or an array for each column: pandas.DataFrame(stage.table()).

    kind: "curves", the relaxation moduli with their errors; "dynamic", the complex moduli over the frequency;
    "engineering", Young's modulus, Poisson's ratio, K and the compliance in tension; "comparison", what was measured.
    Columns are named as in the files of these names, with the errors of all moduli; those that are not known are NaN.
    Without such data the table has no columns. Raises InputError for another kind.
    """
    return _joined([self], kind)


def result_table(self: _native.Result, kind: str = "curves") -> Table:
    """The tables of all stages, one below the other; see StageResult.table()."""
    return _joined(self.stages, kind)


def names_of_stages(self: Any) -> list[str]:
    """The names that result["..."] takes, for completion."""
    return [stage.name for stage in self.stages]


def _joined(stages: list[_native.StageResult], kind: str) -> Table:
    if kind not in _KINDS:
        raise InputError(f"kind: expected {', '.join(map(repr, _KINDS))}, got {kind!r}")
    table: dict[str, list[Any]] = {}
    for stage in stages:
        for texts, numbers in _KINDS[kind](stage):
            rows = len(next(iter(numbers.values())))
            for name, text in texts.items():
                table.setdefault(name, []).extend([text] * rows)
            for name, values in numbers.items():
                table.setdefault(name, []).append(np.asarray(values))
    return {name: values if isinstance(values[0], str) else np.concatenate(values) for name, values in table.items()}
