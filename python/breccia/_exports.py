"""What finite element programs and analysers are compared with: material cards, and moduli over the temperature."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _html, _native
from ._calculations import solved
from ._errors import InputError
from ._materials import name_of
from ._quantities import PathLike, Quantity, share, si, window
from ._stages import Stage

ISOCHRONAL_FORMAT = "dma"
_STEP = 2.0  # [K]
_FREQUENCY = 1.0  # [Hz]


def export(result: _native.Result, format: str, file: PathLike | None = None, *, stage: Stage | str | None = None,
           boundary: str | None = None, load: str | None = None, tolerance: float | str | None = None,
           times: Sequence[Quantity] | None = None, bulk: Quantity | None = None, poisson: float | None = None,
           units: str | None = None, frequency: Quantity | None = None, temperatures: Sequence[Quantity] | None = None,
           step: Quantity | None = None, overwrite: bool = False) -> str:
    """The moduli of a composite as text, as `breccia export` writes it.

    format: "abaqus", "ansys", "ls-dyna", "openradioss", "comsol", "moose" or "csv", a material card; or "dma", a table over the
    temperature; file: where to write it, too; overwrite: whether an existing one may be replaced; stage: the last one
    by default; boundary: needed where several were tested; load: which shear gives G(t).

    Of a card: tolerance: largest relative deviation of G(t) and K(t), 0.01 or "1 %", by default that; times: first and
    last time at which it holds [s]; bulk: an elastic bulk modulus [Pa], or poisson: a constant Poisson's ratio, in place of the
    bulk test; units: "m-kg-s" or "mm-t-s". Of the table: frequency [Hz], temperatures [K] and step [K] as of
    isochrone(). Raises InputError with every mistake, and FileError.
    """
    of_card = {"tolerance": tolerance, "times": times, "bulk": bulk, "poisson": poisson, "units": units}
    of_table = {"frequency": frequency, "temperatures": temperatures, "step": step}
    foreign = of_card if format == ISOCHRONAL_FORMAT else of_table
    mistakes = [f"{name}: the format {format} has none" for name, value in foreign.items() if value is not None]
    if file is not None and os.path.lexists(file) and not overwrite:
        mistakes.append(f"{os.fspath(file)}: the file exists; replace it (overwrite=True) or choose another name")
    if mistakes:
        raise InputError("\n".join(mistakes))
    composite = _native.composite(solved(result), name_of("stage", stage), boundary, load)
    if format == ISOCHRONAL_FORMAT:
        text = _native.isochronal_table(composite, *_isochronal_arguments(frequency, temperatures, step))
    else:
        text = _native.card(composite, format, 0.01 if tolerance is None else share("tolerance", tolerance),
                            None if times is None else window("times", times, "time"),
                            None if bulk is None else si("bulk", bulk, "pressure"), poisson, units or "m-kg-s")
    if file is not None:
        _native.write_text(os.fspath(file), text)
    return text


@dataclass(frozen=True)
class Isochrone:
    """The complex moduli of a composite at one frequency over the temperature."""

    frequency: float  #: [Hz]
    temperature: NDArray[np.float64]  #: [K]
    log10_shift_factor: NDArray[np.float64]  #: from the temperature of the study [-]
    shear: NDArray[np.complex128]  #: G' + i G'' [Pa]
    young: NDArray[np.complex128] | None  #: E' + i E'' [Pa]; None without a bulk test
    poisson: NDArray[np.complex128] | None  #: complex Poisson's ratio [-], likewise

    def __repr__(self) -> str:
        return (f"<breccia.Isochrone: {self.frequency:g} Hz, {len(self.temperature)} temperatures from "
                f"{self.temperature[0] - 273.15:.4g} to {self.temperature[-1] - 273.15:.4g} degC>")

    def _repr_html_(self) -> str:
        if self.young is not None:
            return _html.isochrone_html(self.young, self.temperature, "E", repr(self))
        return _html.isochrone_html(self.shear, self.temperature, "G", repr(self))


def isochrone(result: _native.Result, frequency: Quantity = _FREQUENCY, *,
              temperatures: Sequence[Quantity] | None = None, step: Quantity = _STEP,
              stage: Stage | str | None = None, boundary: str | None = None, load: str | None = None) -> Isochrone:
    """The complex moduli of a composite at one frequency over the temperature, as a dynamic mechanical analyser shows
    them.

    frequency: [Hz]; temperatures: first and last one [K], by default all within 100 K of that of the study at which
    its times cover the frequency; step: between them [K]; stage, boundary, load: as of export(). The binder needs a
    temperature_shift, and nothing else may relax. Raises InputError.
    """
    composite = _native.composite(solved(result), name_of("stage", stage), boundary, load)
    omega, range_, kelvins = _isochronal_arguments(frequency, temperatures, step)
    return Isochrone(omega / (2.0 * math.pi), **_native.isochronal(composite, omega, range_, kelvins))


def _isochronal_arguments(frequency: Quantity | None, temperatures: Sequence[Quantity] | None,
                          step: Quantity | None) -> tuple[float, Union[tuple[float, float], None], float]:
    """Angular frequency [rad/s], first and last temperature [K], step [K]."""
    cycles = si("frequency", _FREQUENCY if frequency is None else frequency, "frequency")
    if not (math.isfinite(cycles) and cycles > 0.0):
        raise InputError(f"frequency: expected a positive number in Hz, got {cycles:g}")
    range_ = None if temperatures is None else window("temperatures", temperatures, "temperature")
    return 2.0 * math.pi * cycles, range_, si("step", _STEP if step is None else step, "temperature difference")
