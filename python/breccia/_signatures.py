"""The parameters of the classes of the library, which their constructors in C++ do not show: for help() and editors."""

from __future__ import annotations

import inspect
from typing import Any, Callable

from . import _native


def _prony_series(terms: Any = (), equilibrium: float | str = 0.0) -> None: ...


def _creep_compliance(instantaneous: float, terms: Any = (), fluidity: float = 0.0) -> None: ...


def _solid(name: str, *, density: float, bulk: _native.PronySeries, shear: _native.PronySeries) -> None: ...


#: The classes that a caller makes, and functions of the same parameters.
CONSTRUCTORS: dict[type, Callable[..., None]] = {
    _native.PronySeries: _prony_series, _native.CreepCompliance: _creep_compliance, _native.Solid: _solid,
}


def show_signatures() -> None:
    """Gives the classes the signatures that inspect.signature() returns."""
    for made, constructor in CONSTRUCTORS.items():
        setattr(made, "__signature__", inspect.signature(constructor))
