"""Fits of what was measured."""

from __future__ import annotations

import os
from typing import Sequence, Tuple

from numpy.typing import ArrayLike

from . import _native
from ._calculations import si
from ._study import PathLike, Quantity

Sweep = Tuple[float, ArrayLike, ArrayLike, ArrayLike]


def read_sweeps(file: PathLike, kind: str | None = None) -> list[Sweep]:
    """The frequency sweeps in a file of an instrument, as `breccia fit` reads it, for master_curve().

    kind: "shear", "young" or "bulk", where the names of the columns do not say what was measured. A sweep is its
    temperature [K], angular frequencies [rad/s], storage and loss moduli [Pa]; temperatures within 0.5 K count as one.
    Raises InputError with every mistake, and FileError.
    """
    return _native.read_sweeps(os.fspath(file), kind)


def master_curve(sweeps: Sequence[Sweep], reference_temperature: Quantity, *,
                 times_per_decade: float = 10.0) -> _native.MasterCurve:
    """Shifts frequency sweeps at several temperatures to one curve, with a Prony series for all of them.

    sweeps: a list of (temperature [K], angular frequencies [rad/s], storage moduli [Pa], loss moduli [Pa]), as of
    read_sweeps(); reference_temperature: that of one of them [K]; times_per_decade: relaxation times that are offered
    to the fit. Raises InputError and NumericalError.
    """
    reference = si("reference_temperature", reference_temperature, "temperature")
    return _native.master_curve(sweeps, reference, times_per_decade=times_per_decade)
