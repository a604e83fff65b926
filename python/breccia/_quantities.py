"""Quantities of a caller: text with a unit, such as "0.5 um" or "3.6 GPa", or a number in the SI unit."""

from __future__ import annotations

import os
from typing import Any, Mapping, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._errors import InputError

Quantity = Union[str, float]
PathLike = Union[str, "os.PathLike[str]"]

#: The SI units of the keys of a deck that are quantities, in whatever table they stand.
UNITS = {
    "activation_energy": "J/mol", "angle": "rad", "box": "m", "budget": "s", "bulk": "Pa", "c2": "K",
    "creep": "1/Pa", "d10": "m", "d50": "m", "d90": "m", "density": "kg/m^3", "diameter": "m", "equilibrium": "Pa",
    "fields": "s", "film": "m", "frequencies": "Hz", "from": "m", "fuller": "m", "gap": "m", "glassy": "Pa",
    "instantaneous": "1/Pa", "list": "m", "median": "m", "modulus": "Pa", "normal_stiffness": "Pa/m", "pixel": "m",
    "ramp": "s", "reference": "K", "reference_temperature": "K", "resolution": "1/m", "rosin_rammler": "m",
    "shear": "Pa", "size": "m", "sizes": "m", "static": "Pa", "tangential_stiffness": "Pa/m", "temperature": "K",
    "thermal_expansion": "1/K", "thickness": "m", "time": "s", "times": "s", "to": "m", "unrelaxed": "Pa", "young": "Pa",
}

#: The keys of a distribution, whose numbers have the unit of the key to which it belongs.
_OF_A_DISTRIBUTION = {"value", "sd", "factor", "from", "to", "scale", "any"}

#: What messages call the dimensions of arguments, with the SI unit.
_SI_UNITS = {"time": "s", "temperature": "K", "temperature difference": "K", "frequency": "Hz", "pressure": "Pa",
             "compliance": "1/Pa"}


def is_number(value: Any) -> bool:
    """Whether a value is a real number, and none of the two of logic."""
    return isinstance(value, (int, float, np.integer, np.floating)) and not isinstance(value, bool)


def in_deck(key: str, value: Any) -> Any:
    """The value of a key as a deck has it: numbers that are quantities, also in tables and lists, as text with the
    unit; series and laws as tables."""
    if isinstance(value, Mapping) and value and set(value) <= _OF_A_DISTRIBUTION:
        return {inner: entry if inner in ("factor", "scale") else in_deck(key, entry) for inner, entry in value.items()}
    if isinstance(value, Mapping):
        # The factors of a material have the names of its quantities.
        return dict(value) if key == "factors" else {inner: in_deck(inner, entry) for inner, entry in value.items()}
    if isinstance(value, _native.PronySeries):
        return _series(value)
    if isinstance(value, _native.WilliamsLandelFerry):
        reference = f"{value.reference_temperature!r} K"
        return {"law": "wlf", "c1": value.c1, "c2": f"{value.c2!r} K", "reference": reference, "temperature": reference}
    if isinstance(value, (list, tuple, np.ndarray)):
        _native.refuse_what_numpy_drops(key or "study", "numbers, or text with units", value)
        return [in_deck(key, entry) for entry in (value.tolist() if isinstance(value, np.ndarray) else value)]
    return f"{float(value)!r} {UNITS[key]}" if key in UNITS and is_number(value) else value


def _series(series: _native.PronySeries) -> Any:
    if series.is_elastic:
        return f"{series.equilibrium!r} Pa"
    terms = [{"time": f"{time!r} s", "modulus": f"{modulus!r} Pa"} for time, modulus in series.terms.tolist()]
    return {"terms": terms, "equilibrium": f"{series.equilibrium!r} Pa" if series.equilibrium > 0.0 else None}


def in_path(path: str, value: Any) -> Any:
    """The value of a key that is given by its path, "stages.0.box", as a deck has it. The tables of a sweep are left as
    they are: their ends belong to another key."""
    steps = [step for step in path.split(".") if not step.isdigit()]
    is_plain = not steps or steps[0] == "sweep" or "factors" in steps[:-1]
    return value if is_plain else in_deck(steps[-1], value)


def si(argument: str, value: Any, dimension: str) -> float:
    """An argument that is a quantity as text, or a number, in the SI unit."""
    if is_number(value):
        return float(value)
    if not isinstance(value, str):
        raise InputError(f"{argument}: expected a {dimension}, as text with a unit or as a number in "
                         f"{_SI_UNITS[dimension]}, got {value!r}")
    try:
        return _native.quantity(value, dimension)
    except InputError as error:
        raise InputError(f"{argument}: {error}") from None


def window(argument: str, ends: Sequence[Quantity], dimension: str) -> tuple[float, float]:
    """An argument that is a first and a last quantity, in the SI unit."""
    both = None if isinstance(ends, str) or not np.iterable(ends) else list(ends)
    if both is None or len(both) != 2:
        raise InputError(f"{argument}: expected the first and the last one, got {ends!r}")
    return si(argument, both[0], dimension), si(argument, both[1], dimension)


def numbers(argument: str, values: Any, unit: str) -> NDArray[np.float64]:
    """An argument that is numbers in an SI unit, as an array."""
    _native.refuse_what_numpy_drops(argument, f"numbers in {unit}", values)
    array = np.asarray(values)
    if array.dtype.kind not in "iuf":
        raise InputError(f"{argument}: expected numbers in {unit}, got something else among them")
    return array.astype(float)


def share(argument: str, value: Any) -> float:
    """An argument that is a share: a number, or text such as "1 %"."""
    text = value.strip() if isinstance(value, str) else value
    try:
        return float(text[:-1]) / 100.0 if isinstance(text, str) and text.endswith("%") else float(text)
    except (TypeError, ValueError):
        raise InputError(f'{argument}: expected a number or a share such as "1 %", got {value!r}') from None
