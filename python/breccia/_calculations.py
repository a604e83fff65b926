"""What is done with a study: solve, pack, run, respond."""

from __future__ import annotations

import os
from typing import Any, Mapping, Sequence, Union

from . import _native
from ._errors import InputError
from ._progress import Progress, shown
from ._study import Material, PathLike, Quantity, Study

AnyMaterial = Union[Material, _native.Solid, _native.PronySeries, PathLike]


def solve(study: Study, *, threads: int = 0, ignore_memory: bool = False,
          progress: Progress = None) -> _native.Result:
    """Packs the stages of a study and runs their tests. No file is written.

    threads: of the dynamic method, 0: all cores; ignore_memory: start even if the study may not fit into the memory;
    progress: True or False, or a function (what, share, details) that is called a few times a second; by default it is
    shown in terminals and notebooks. Ctrl-C ends it. Raises InputError and NumericalError.
    """
    with shown(progress) as show:
        return _native.solve(study._checked, threads, ignore_memory, show)


def pack(study: Study, directory: PathLike | None = None, *, overwrite: bool = False,
         progress: Progress = None) -> _native.Result:
    """Packs the stages of a study without any test: result[stage].microstructure.

    directory: where to write them, too, as `breccia pack` does; see run().
    """
    with shown(progress) as show:
        if directory is None:
            return _native.pack(study._checked, show)
        return _native.pack_in_directory(study._checked, os.fspath(directory), overwrite, show)


def run(study: Study, directory: PathLike, *, resume: bool = False, overwrite: bool = False,
        time_limit: Quantity | None = None, threads: int = 0, ignore_memory: bool = False,
        progress: Progress = None) -> _native.Result:
    """Solves a study and writes its results to a directory, as `breccia run` does.

    resume: continue a run that was interrupted; overwrite: replace results of another study; time_limit: [s], after
    which a checkpoint is written and Interrupted raised. Ctrl-C writes a checkpoint, too. Raises as solve(), and
    FileError.
    """
    limit = None if time_limit is None else si("time_limit", time_limit, "time")
    with shown(progress) as show:
        return _native.run(study._checked, os.fspath(directory), resume, overwrite, limit, threads, ignore_memory, show)


def respond(result: _native.Result, binder: AnyMaterial | None = None, *,
            materials: Mapping[str, AnyMaterial] | None = None, temperature: Quantity | None = None,
            times: Sequence[Quantity] | None = None) -> _native.Result:
    """The curves of the same boxes with other materials or at another temperature, in milliseconds.

    binder: a new matrix: a Material, a PronySeries for its shear modulus alone, or a TOML file; materials: others by
    the names of those that they replace; temperature: [K] or "40 degC", by the temperature_shift of the study; times:
    first and last time [s]. Raises InputError where the result does not cover the materials; the message has the times
    that it covers.
    """
    replaced = dict(materials or {})
    if binder is not None:
        replaced["matrix"] = binder
    if bool(replaced) == (temperature is not None):
        raise InputError("respond: expected either other materials (binder, materials) or a temperature")
    kelvin = None if temperature is None else si("temperature", temperature, "temperature")
    covered = None if times is None else window("times", times, "time")
    solids = [(name, _solid(result, name, material)) for name, material in replaced.items()]
    return _native.respond(result, solids, kelvin, covered)


def si(argument: str, value: Any, dimension: str) -> float:
    """An argument that is a quantity as text, or a number, in the SI unit."""
    if not isinstance(value, str):
        return float(value)
    try:
        return _native.quantity(value, dimension)
    except InputError as error:
        raise InputError(f"{argument}: {error}") from None


def window(argument: str, ends: Sequence[Quantity], dimension: str) -> tuple[float, float]:
    """An argument that is a first and a last quantity, in the SI unit."""
    if isinstance(ends, str) or len(ends) != 2:
        raise InputError(f"{argument}: expected the first and the last one, got {ends!r}")
    return si(argument, ends[0], dimension), si(argument, ends[1], dimension)


def _solid(result: _native.Result, replaced: str, material: AnyMaterial) -> _native.Solid:
    """A material of a caller in SI units."""
    if isinstance(material, _native.Solid):
        return material
    if isinstance(material, Material):
        return material.solid()
    if isinstance(material, _native.PronySeries):
        own = _replaced_solid(result, replaced)
        return _native.Solid(own.name, density=own.density, bulk=own.bulk, shear=material)
    return _native.read_solid(os.fspath(material))


def _replaced_solid(result: _native.Result, name: str) -> _native.Solid:
    """The material of the study that a name stands for, whose density and bulk modulus stay."""
    for material in result.materials:
        if material.name == (result.binder if name == "matrix" else name):
            return material
    names = ", ".join(material.name for material in result.materials)
    raise InputError(f'materials: "{name}" is none of {names}: give a whole Material in place of a PronySeries')
