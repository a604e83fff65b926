"""Materials of studies that are built in Python, and what all parts of such a study have in common.

A quantity is text with a unit, such as "0.5 um" or "3.6 GPa", as in a deck, or a number in the SI unit that stands in
brackets. Every class also takes further keys of a deck by their names, and a study reports all mistakes at once.
"""

from __future__ import annotations

import os
from typing import Any, Iterable, Mapping, Type, TypeVar, Union

import numpy as np

from . import _deck, _native
from ._errors import InputError
from ._quantities import PathLike, Quantity, in_deck

Part = TypeVar("Part", bound="Table")
Modulus = Union[str, float, _native.PronySeries, Mapping[str, Any]]


def _is_given(value: Any) -> bool:
    return value is not None and (isinstance(value, np.ndarray) or value not in ((), {}))


class Table:
    """A table of a deck."""

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        """What was given, by the keys of a deck; numbers have no unit yet (in_deck)."""
        raise NotImplementedError

    def __repr__(self) -> str:
        given = (f"{key.lstrip('_')}={value!r}" for key, value in vars(self).items() if _is_given(value))
        return f"breccia.{type(self).__name__}({', '.join(given)})"


class Material(Table):
    """A linear viscoelastic solid, by its density [kg/m^3] and two of bulk, shear, young and poisson.

    bulk, shear, young: bulk, shear and Young's modulus [Pa]: a quantity, a PronySeries, or a table as in a deck, such as
    {"prony": "binder.csv"}; poisson: Poisson's ratio, a number between -0.9 and 0.5, constant in time: steel is
    Material("steel", density=7850, young="210 GPa", poisson=0.3); temperature_shift: a table as in a deck, or the law of
    a master curve, for moduli at its reference temperature; thermal_expansion: linear [1/K].
    """

    def __init__(self, name: str, *, density: Quantity | None = None, bulk: Modulus | None = None,
                 shear: Modulus | None = None, young: Modulus | None = None, poisson: float | None = None,
                 temperature_shift: Mapping[str, Any] | _native.WilliamsLandelFerry | None = None,
                 thermal_expansion: Quantity | None = None, **keys: Any) -> None:
        self.name = name
        self.density = density
        self.bulk = bulk
        self.shear = shear
        self.young = young
        self.poisson = poisson
        self.temperature_shift = temperature_shift
        self.thermal_expansion = thermal_expansion
        self.keys = keys

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        return {"density": self.density, "bulk": self.bulk, "shear": self.shear, "young": self.young,
                "poisson": self.poisson, "temperature_shift": self.temperature_shift,
                "thermal_expansion": self.thermal_expansion, **self.keys}

    def _shifted(self, directory: PathLike = ".") -> _native.ShiftedSolid:
        """The material in SI units with the law of its temperature shift."""
        table = in_deck("", self._table(_deck.Files()))
        return _native.shifted_from_text("\n".join(_deck.lines_of(table)) + "\n", self.name, os.fspath(directory))

    def solid(self, directory: PathLike = ".") -> _native.Solid:
        """The material in SI units. Files that it names are relative to the directory. Raises InputError."""
        return self._shifted(directory).solid


def name_of(argument: str, named: Any) -> str | None:
    """The name of a material or a stage; None where the argument was left out, which the rules of a deck refuse."""
    name = named if named is None or isinstance(named, str) else getattr(named, "name", None)
    if name is None and named is not None:
        raise InputError(f"{argument}: expected a name, a material or a stage, got {named!r}")
    return name


def several_of(argument: str, kind: Type[Part], parts: Part | Iterable[Part] | None) -> tuple[Part, ...]:
    """The parts of a study in an argument: one, several or none."""
    if parts is None or isinstance(parts, kind):
        return () if parts is None else (parts,)
    found = tuple(parts) if isinstance(parts, Iterable) and not isinstance(parts, str) else (parts,)
    for part in found:
        if not isinstance(part, kind):
            raise InputError(f"{argument}: expected a {kind.__name__} or several, got {part!r}")
    return found
