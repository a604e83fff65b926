"""What is done with a study: plan, solve, pack, run, respond."""

from __future__ import annotations

import operator
import os
import time
from typing import Any, Callable, Mapping, Optional, Protocol, Sequence, Union

from . import _native
from ._errors import InputError
from ._materials import Material
from ._quantities import PathLike, Quantity, si, window
from ._progress import Progress, shown
from ._study import Study

AnyMaterial = Union[Material, _native.Solid, _native.PronySeries, PathLike]


class Stop(Protocol):
    """What can tell a calculation to end, such as a threading.Event."""

    def is_set(self) -> bool: ...


def _asked_to_end(stop: Stop | None, time_limit: Quantity | None) -> Optional[Callable[[], bool]]:
    """A function that is asked a few times a second whether a calculation shall end; None where nothing ends it."""
    if stop is not None and not callable(getattr(stop, "is_set", None)):
        raise InputError(f"stop: expected what has is_set(), such as a threading.Event, got {stop!r}")
    limit = None if time_limit is None else si("time_limit", time_limit, "time")
    if limit is not None and not limit > 0.0:
        raise InputError(f"time_limit: expected a positive number in s, got {limit:g}")
    if stop is None and limit is None:
        return None
    begin = time.monotonic()
    return lambda: bool((stop is not None and stop.is_set()) or (limit is not None and time.monotonic() - begin >= limit))


def _number_of_threads(threads: Any) -> int:
    try:
        return operator.index(threads)
    except TypeError:
        raise InputError(f"threads: expected a whole number from 0, got {threads!r}") from None


def solve(study: Study, *, threads: int = 0, ignore_memory: bool = False, time_limit: Quantity | None = None,
          stop: Stop | None = None, progress: Progress = None) -> _native.Result:
    """Packs the stages of a study and runs their tests. No file is written.

    threads: number of threads, 0 for as many as shorten the calculation, at most one for each core; ignore_memory: start
    even if the study may not fit into the memory; time_limit: [s], after which Interrupted is raised, as it is once
    stop.is_set(), of a threading.Event that another thread sets; progress: True or False, or a function (what, share,
    details) that is called a few times a second; by default it is shown in terminals and notebooks. Ctrl-C ends it.
    Raises InputError and NumericalError.
    """
    end = _asked_to_end(stop, time_limit)
    with shown(progress) as show:
        return _native.solve(checked(study), _number_of_threads(threads), ignore_memory, show, end)


def plan(study: Study) -> _native.Plan:
    """What a study is expected to take, as `breccia check` prints it: plan.seconds, plan.memory [B], plan.stages.

    plan[stage].grid_error is the largest relative error to be expected of the grid, plan[stage].cells_for(0.02) the
    cells per side for one of 2 %. The boxes are packed for it, and a dynamic test is tried for a fraction of a second.
    """
    return _native.plan(checked(study))


def pack(study: Study, directory: PathLike | None = None, *, overwrite: bool = False,
         progress: Progress = None) -> _native.Result:
    """Packs the stages of a study without any test: result[stage].microstructure.

    directory: where to write them, too, as `breccia pack` does; see run().
    """
    with shown(progress) as show:
        if directory is None:
            return _native.pack(checked(study), show)
        return _native.pack_in_directory(checked(study), os.fspath(directory), overwrite, show)


def run(study: Study, directory: PathLike, *, resume: bool = False, overwrite: bool = False,
        time_limit: Quantity | None = None, stop: Stop | None = None, threads: int = 0, ignore_memory: bool = False,
        progress: Progress = None) -> _native.Result:
    """Solves a study and writes its results to a directory, as `breccia run` does.

    resume: continue a run that was interrupted; overwrite: replace results of another study; time_limit, stop: as of
    solve(), but a checkpoint is written first. Ctrl-C writes one, too. Raises as solve(), and FileError.
    """
    end = _asked_to_end(stop, time_limit)
    with shown(progress) as show:
        return _native.run(checked(study), os.fspath(directory), resume, overwrite, _number_of_threads(threads),
                           ignore_memory, show, end)


def respond(result: _native.Result, binder: AnyMaterial | None = None, *,
            materials: Mapping[str, AnyMaterial] | None = None, temperature: Quantity | None = None,
            times: Sequence[Quantity] | None = None,
            frequencies: Sequence[Quantity] | None = None) -> _native.Result:
    """The curves of the same boxes with other materials or at another temperature, in milliseconds.

    binder: a new matrix: a Material, a PronySeries for its shear modulus alone, or a TOML file; materials: others by
    the names of those that they replace; temperature: [K] or "40 degC", by the temperature_shift of the study or of the
    new binder; times: first and last time [s]; frequencies: in their place, the first and the last frequency [Hz].
    Elastic materials vary only where the study asked for it:
    Tests(quasistatic={"vary": {"glass": {"shear": [3e9, 300e9]}}}). The answer can be asked again. Raises InputError
    where the result does not cover the materials; the message has the times that it covers.
    """
    solved(result)
    if materials is not None and not isinstance(materials, Mapping):
        raise InputError(f'materials: expected materials by the names of those they replace, as in {{"glass": steel}}, '
                         f"got {materials!r}")
    replaced = dict(materials or {})
    if binder is not None:
        replaced["matrix"] = binder
    if bool(replaced) == (temperature is not None):
        raise InputError("respond: expected either other materials (binder, materials) or a temperature")
    kelvin = None if temperature is None else si("temperature", temperature, "temperature")
    covered = None if times is None else window("times", times, "time")
    solids = [(name, _solid(result, name, material)) for name, material in replaced.items()]
    cycles = None if frequencies is None else window("frequencies", frequencies, "frequency")
    return _native.respond(result, solids, kelvin, covered, cycles)


def checked(study: Any) -> _native.CheckedStudy:
    """What a study is solved from. Raises InputError for anything else, such as the name of a deck."""
    if isinstance(study, Study):
        return study._checked
    advice = f": read_study({study!r}) makes one of a deck" if isinstance(study, (str, os.PathLike)) else ""
    raise InputError(f"study: expected a Study, got {study!r}{advice}")


def solved(result: Any) -> _native.Result:
    """A result. Raises InputError for anything else, such as the name of a directory."""
    if isinstance(result, _native.Result):
        return result
    advice = f": read_results({result!r}) reads that of a directory" if isinstance(result, (str, os.PathLike)) else ""
    raise InputError(f"result: expected a Result, got {result!r}{advice}")


def _solid(result: _native.Result, replaced: str, material: AnyMaterial) -> _native.ShiftedSolid:
    """A material of a caller in SI units."""
    if isinstance(material, _native.Solid):
        return _native.ShiftedSolid(material)
    if isinstance(material, Material):
        return material._shifted()
    if isinstance(material, _native.PronySeries):
        own = _replaced_solid(result, replaced)
        return _native.ShiftedSolid(_native.Solid(own.name, density=own.density, bulk=own.bulk, shear=material))
    if isinstance(material, (str, os.PathLike)):
        return _native.read_shifted(os.fspath(material))
    argument = "binder" if replaced == "matrix" else f"materials: {replaced}"
    raise InputError(f"{argument}: expected a Material, a PronySeries of its shear modulus, or the name of a TOML file, "
                     f"got {material!r}")


def _replaced_solid(result: _native.Result, name: str) -> _native.Solid:
    """The material of the study that a name stands for, whose density and bulk modulus stay."""
    for material in result.materials:
        if material.name == (result.binder if name == "matrix" else name):
            return material
    names = ", ".join(material.name for material in result.materials)
    raise InputError(f'materials: "{name}" is none of {names}: give a whole Material in place of a PronySeries')
