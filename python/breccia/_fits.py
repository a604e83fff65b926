"""Fits of what was measured."""

from __future__ import annotations

import os
from typing import Any, Iterable, Mapping, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._errors import InputError
from ._quantities import UNITS, PathLike, Quantity, is_number, si

#: The dimensions of the parameters of laws by their units.
_DIMENSIONS = {"Pa": "pressure", "1/Pa": "compliance", "s": "time"}

Sweep = Tuple[Union[str, float], ArrayLike, ArrayLike, ArrayLike]


def fit(time: ArrayLike, modulus: ArrayLike, *, ramp: Quantity = 0.0, times_per_decade: float = 10.0,
        law: str | None = None, keep: Mapping[str, Quantity] | None = None) -> _native.RelaxationFit:
    """A Prony series of a measured relaxation modulus: times [s], moduli [Pa].

    ramp: for how long the strain rose before it was held [s]; times_per_decade: relaxation times that are offered to the
    fit. law: "2s2p1d" or "fractional-zener", in place of a free spectrum; its parameters are in `law` of the result, a
    table for a Material; keep: parameters of the law that are known, {"glassy": "2 GPa"}. Raises InputError and
    NumericalError.
    """
    return _native.fit(time, modulus, ramp=_ramp(ramp, law), times_per_decade=_count(times_per_decade, law), law=law,
                       keep=_kept(keep, law))


def fit_creep(time: ArrayLike, compliance: ArrayLike, *, ramp: Quantity = 0.0, times_per_decade: float = 10.0,
              law: str | None = None, keep: Mapping[str, Quantity] | None = None) -> _native.CreepFit:
    """A retardation spectrum of a measured creep compliance: times [s], compliances [1/Pa]. Otherwise as fit(); ramp: for
    how long the stress rose [s]; law: "power-law-creep" or "logarithmic-creep"."""
    return _native.fit_creep(time, compliance, ramp=_ramp(ramp, law), times_per_decade=_count(times_per_decade, law),
                             law=law, keep=_kept(keep, law))


def fit_dynamic(angular_frequency: ArrayLike, storage: ArrayLike, loss: ArrayLike, *, times_per_decade: float = 10.0,
                law: str | None = None, keep: Mapping[str, Quantity] | None = None) -> _native.RelaxationFit:
    """A Prony series of measured dynamic moduli: angular frequencies [rad/s], storage and loss moduli [Pa]. Otherwise as
    fit()."""
    return _native.fit_dynamic(angular_frequency, storage, loss, times_per_decade=_count(times_per_decade, law),
                               law=law, keep=_kept(keep, law))


def _ramp(ramp: Quantity, law: str | None) -> float:
    duration = si("ramp", ramp, "time")
    if law is not None and duration != 0.0:
        raise InputError("ramp: not with a law, which takes the data as those of a step")
    return duration


def _kept(keep: Mapping[str, Quantity] | None, law: str | None) -> list[tuple[str, float]]:
    """The known parameters of a law in SI units."""
    if keep is not None and not isinstance(keep, Mapping):
        raise InputError(f'keep: expected values by parameters, as in {{"glassy": "2 GPa"}}, got {keep!r}')
    if keep and law is None:
        raise InputError("keep: expected a law whose parameters they are")
    return [(str(key), _parameter(str(key), value)) for key, value in (keep or {}).items()]


def _parameter(key: str, value: Any) -> float:
    dimension = _DIMENSIONS.get(UNITS.get(key, ""))
    if dimension is not None:
        return si(f"keep: {key}", value, dimension)
    if not is_number(value):
        raise InputError(f"keep: {key}: expected a number, got {value!r}")
    return float(value)


def _count(times_per_decade: Any, law: str | None = None) -> float:
    if not is_number(times_per_decade):
        raise InputError(f"times_per_decade: expected a number, got {times_per_decade!r}")
    if law is not None and times_per_decade != 10.0:
        raise InputError("times_per_decade: not with a law, which has no relaxation times of its own")
    return float(times_per_decade)


def read_measured(file: PathLike, kind: str | None = None, *,
                  columns: Mapping[str, str] | None = None) -> dict[str, NDArray[np.float64]]:
    """The columns of a table of measured data that are known by their names, in SI units, whatever those of the file.

    They are time [s], temperature [K], angular_frequency [rad/s], modulus, storage_modulus, loss_modulus,
    absolute_modulus [Pa], phase_angle [rad], loss_tangent [-], compliance [1/Pa]. kind: "shear", "young" or "bulk":
    refuses columns of another kind; columns: as of read_sweeps(). Raises InputError with every mistake, and FileError.
    """
    return _native.read_measured(os.fspath(file), kind, _pairs(columns))


def read_sweeps(file: PathLike, kind: str | None = None, *, columns: Mapping[str, str] | None = None) -> list[Sweep]:
    """The frequency sweeps in a file of an instrument, as `breccia fit` reads it, for master_curve().

    kind: "shear", "young" or "bulk", where the names of the columns do not say what was measured; columns: which column
    is which, where its name does not say it: {"storage": "E1 [MPa]", "loss": "E2 [MPa]"}, of the words time, frequency,
    temperature, storage, loss, absolute, phase, tangent, modulus and compliance. A sweep is its temperature [K], angular
    frequencies [rad/s], storage and loss moduli [Pa]; temperatures within 0.5 K count as one. Raises InputError with
    every mistake, and FileError.
    """
    return list(_native.read_sweeps(os.fspath(file), kind, _pairs(columns)))


def _pairs(columns: Mapping[str, str] | None) -> list[tuple[str, str]]:
    if columns is not None and not isinstance(columns, Mapping):
        raise InputError(f'columns: expected names by quantities, as in {{"storage": "E1 [MPa]"}}, got {columns!r}')
    return [(str(word), str(name)) for word, name in (columns or {}).items()]


def master_curve(sweeps: Iterable[Sweep], reference_temperature: Quantity, *,
                 times_per_decade: float = 10.0) -> _native.MasterCurve:
    """Shifts frequency sweeps at several temperatures to one curve, with a Prony series for all of them.

    sweeps: a list of (temperature [K], angular frequencies [rad/s], storage moduli [Pa], loss moduli [Pa]), as of
    read_sweeps(); a temperature may be text, "20 degC"; reference_temperature: that of one of them [K];
    times_per_decade: relaxation times that are offered to the fit. Raises InputError and NumericalError.
    """
    reference = si("reference_temperature", reference_temperature, "temperature")
    given = [_sweep(number, sweep) for number, sweep in enumerate(_listed(sweeps))]
    return _native.master_curve(given, reference, times_per_decade=times_per_decade)


def _listed(sweeps: Any) -> list[Any]:
    if isinstance(sweeps, (str, Mapping)) or not np.iterable(sweeps):
        raise InputError(f"sweeps: expected a list of sweeps, got {sweeps!r}")
    return list(sweeps)


def _sweep(number: int, sweep: Any) -> tuple[float, list[float], list[float], list[float]]:
    """A sweep in SI units."""
    place = f"sweeps[{number}]"
    parts = [] if isinstance(sweep, str) or not np.iterable(sweep) else list(sweep)
    if len(parts) != 4:
        raise InputError(f"{place}: expected (temperature [K], angular frequencies [rad/s], storage, loss [Pa]), got "
                         f"{sweep!r}")
    temperature, *columns = parts
    numbers = [_numbers(f"{place}: {name}", column)
               for name, column in zip(("angular frequencies", "storage", "loss"), columns)]
    return (si(f"{place}: temperature", temperature, "temperature"), numbers[0], numbers[1], numbers[2])


def _numbers(argument: str, values: Any) -> list[float]:
    try:
        array = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        array = np.empty((0, 0))
    if array.ndim != 1:
        raise InputError(f"{argument}: expected a list of numbers, got {values!r}")
    return [float(value) for value in array]
