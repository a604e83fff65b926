"""Unknown numbers of materials from measurements of composites."""

from __future__ import annotations

import html
import os
from dataclasses import dataclass
from typing import Any, Mapping, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._calculations import solved
from ._errors import InputError
from ._quantities import PathLike

Files = Union[PathLike, Sequence[PathLike]]


@dataclass(frozen=True)
class Estimate:
    """What a calibration has found of an unknown number, in SI units."""

    name: str  #: "interphase.shear", "binder.spectrum at 1 us", "model of composite"
    unit: str  #: SI unit; empty without one
    value: float  #: the most likely value
    interval: tuple[float, float]  #: holds the truth in 95 of 100 cases
    before: tuple[float, float]  #: the interval of what was assumed
    learned: float  #: share of the variance that the data have removed, from 0 to 1


@dataclass(frozen=True)
class Calibration:
    """What calibrate() has found."""

    estimates: dict[str, Estimate]  #: by their names
    correlation: NDArray[np.float64]  #: of the estimates, in their order
    predictions: dict[str, Any]  #: columns: composite, modulus, curve, at, measured, predicted, lower, upper, deviation
    materials: dict[str, _native.Solid]  #: the materials that were changed, for respond()
    noise: float  #: standard deviation of the data, relative to them
    independent_samples: float | None  #: from which the intervals are; None of the normal distribution
    warnings: list[str]
    remarks: list[str]  #: what the data say of the unknowns and of the model

    def __getitem__(self, name: str) -> Estimate:
        return self.estimates[name]

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{html.escape(one.name)}</td><td>{one.value:.4g} {one.unit}</td>"
            f"<td>{one.interval[0]:.4g} to {one.interval[1]:.4g}</td><td>{100 * one.learned:.0f} %</td></tr>"
            for one in self.estimates.values())
        warnings = "".join(f"<div>{html.escape(text)}</div>" for text in self.warnings + self.remarks)
        return ("<div><table><tr><th>unknown</th><th>found</th><th>95 % interval</th><th>learned</th></tr>"
                f"{rows}</table><div>noise of the data: {100 * self.noise:.2g} %</div>{warnings}</div>")


def calibrate(results: _native.Result | Mapping[str, _native.Result], measured: Files | Mapping[str, Files],
              unknowns: str | Sequence[str] | Mapping[str, str | None], *, modulus: str | None = None,
              stage: str | None = None, noise: float | None = None, model_error: float | None = None,
              samples: int = 0) -> Calibration:
    """Finds unknown numbers of materials from measurements of composites, with 95 % intervals.

    results: a Result, or several by names; measured: the file or the files of what was measured, with several results
    by their names; unknowns: names such as "interphase.shear", "binder.times", "binder.modulus", "binder.spectrum", or
    names with what is known of them: {"hmx.shear": '{ value = "5.84 GPa", sd = "0.6 GPa" }', "binder.times": None};
    modulus: "shear", "young" or "bulk", where the columns do not say it; stage: the one that was measured, the last one
    unless told; noise: standard deviation of the data, relative to them, as their scatter shows unless told;
    model_error: error of the moduli of the run, as it states unless told; samples: number of samples of the posterior in
    place of the normal distribution. Raises InputError with every mistake, and FileError.
    """
    named = dict(results) if isinstance(results, Mapping) else {"composite": results}
    composites = [(str(name), solved(result)) for name, result in named.items()]
    if isinstance(unknowns, Mapping):
        asked = [name if prior is None else f"{name}={prior}" for name, prior in unknowns.items()]
    else:
        asked = [unknowns] if isinstance(unknowns, str) else list(unknowns)
    require_shares(noise=noise, model_error=model_error)
    return calibration_of(_native.calibrate(composites, _data(measured, list(named)), asked, modulus, stage, noise,
                                            model_error, samples))


def calibration_of(entries: dict[str, Any]) -> Calibration:
    """A calibration from what the library has found."""
    estimates = {one["name"]: Estimate(**one) for one in entries.pop("estimates")}
    return Calibration(estimates=estimates, **entries)


def require_shares(**shares: float | None) -> None:
    """Raises InputError for an argument that is no share between 0 and 1."""
    for argument, share in shares.items():
        if share is not None and not (isinstance(share, (int, float)) and 0.0 < share < 1.0):
            raise InputError(f"{argument}: expected a share between 0 and 1, got {share!r}")


def _data(measured: Files | Mapping[str, Files], names: list[str]) -> list[tuple[int, str]]:
    """Pairs of the number of a result and a file."""
    if isinstance(measured, Mapping):
        unknown = [name for name in measured if name not in names]
        if unknown:
            raise InputError(f"measured: no results are called {unknown[0]!r}; there are {', '.join(names)}")
        return [(names.index(name), path) for name, files in measured.items() for path in paths_of(files)]
    if len(names) != 1:
        raise InputError(f"measured: expected files by the names of the results, {', '.join(names)}, got {measured!r}")
    return [(0, path) for path in paths_of(measured)]


def paths_of(files: Files) -> list[str]:
    """The paths of one file or several."""
    if isinstance(files, (str, os.PathLike)):
        return [os.fspath(files)]
    return [os.fspath(file) for file in files]
