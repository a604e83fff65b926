"""Studies, read from decks or built in Python."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Iterable, Mapping, Sequence

import numpy as np

from . import _deck, _native
from ._errors import InputError
from ._materials import Material, Table, name_of, several_of
from ._quantities import PathLike, Quantity, in_deck, in_path, numbers
from ._stages import Stage


class Tests(Table):
    """The virtual tests of every stage.

    times: first and last time of the curves [s]; frequencies: in their place, the first and the last of the dynamic
    moduli [Hz]; accuracy: 0.03 or "3 %", for which boxes and cells are chosen that stages leave out; budget: time that
    this may take [s]; loads: "isotropic" (default), "stiffness" (the whole), "shear", "bulk", ...; boundaries: "periodic" (default of random packings),
    "displacement" (KUBC), "traction" (SUBC); method: "quasistatic", "dynamic" or a list of both; fields: "none",
    "last" or times [s]; quasistatic, dynamic:
    tables of their settings. All other keys are those of [tests] in a deck.
    """

    __test__ = False  # this is no test of pytest

    def __init__(self, *, times: Sequence[Quantity] | None = None, frequencies: Sequence[Quantity] | None = None,
                 accuracy: float | str | None = None, budget: Quantity | None = None,
                 loads: Sequence[str] | str | None = None, boundaries: Sequence[str] | str | None = None,
                 method: str | Sequence[str] | None = None, points_per_decade: int | None = None,
                 fields: str | Sequence[Quantity] | None = None, quasistatic: Mapping[str, Any] | None = None,
                 dynamic: Mapping[str, Any] | None = None, **keys: Any) -> None:
        self.times = times
        self.frequencies = frequencies
        self.accuracy = accuracy
        self.budget = budget
        self.loads = [loads] if isinstance(loads, str) else loads
        self.boundaries = [boundaries] if isinstance(boundaries, str) else boundaries
        self.method = method
        self.points_per_decade = points_per_decade
        self.fields = fields
        self.quasistatic = quasistatic
        self.dynamic = dynamic
        self.keys = keys

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        return {"times": self.times, "frequencies": self.frequencies, "accuracy": self.accuracy,
                "budget": self.budget, "loads": self.loads,
                "boundaries": self.boundaries, "method": self.method, "points_per_decade": self.points_per_decade,
                "fields": self.fields, "quasistatic": self.quasistatic, "dynamic": self.dynamic, **self.keys}


class Measurement(Table):
    """A measured relaxation modulus, which that of a stage is compared with.

    shear, young or bulk: one of them, a PronySeries, (times [s], moduli [Pa]), or a table as in a deck; stage: the last
    one by default; times: at which the measurement is valid [s].
    """

    def __init__(self, name: str, *, shear: Any = None, young: Any = None, bulk: Any = None,
                 stage: Stage | str | None = None, times: Sequence[Quantity] | None = None, **keys: Any) -> None:
        self.name = name
        self.shear = shear
        self.young = young
        self.bulk = bulk
        self.stage = stage
        self.times = times
        self.keys = keys

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        moduli = {"shear": self.shear, "young": self.young, "bulk": self.bulk}
        for kind, modulus in moduli.items():
            if isinstance(modulus, (tuple, list)):
                moduli[kind] = {"curve": files.table(_curve(kind, modulus), f"{kind} of Measurement {self.name}")}
        return {"name": self.name, **moduli, "stage": name_of("Measurement: stage", self.stage),
                "times": self.times, **self.keys}


_COLUMNS = {"shear": "shear_modulus_Pa", "young": "youngs_modulus_Pa", "bulk": "bulk_modulus_Pa"}


def _curve(kind: str, curve: Sequence[Any]) -> dict[str, Any]:
    """The columns of a measured curve: times and moduli."""
    columns = [numbers(f"Measurement: {kind}", column, unit) for column, unit in zip(curve, ("s", "Pa"))]
    if len(curve) != 2 or columns[0].ndim != 1 or columns[0].shape != columns[1].shape:
        shapes = " and ".join(str(np.shape(column)) for column in curve)
        raise InputError(f"Measurement: {kind}: expected (times [s], moduli [Pa]), two lists of one length, got {shapes}")
    return {"time_s": columns[0], _COLUMNS[kind]: columns[1]}


def _by_name(materials: Iterable[Material], files: _deck.Files) -> tuple[dict[str, Any], list[str]]:
    """The tables of materials by their names, and a line for each name of several."""
    tables: dict[str, Any] = {}
    mistakes = []
    for material in materials:
        table = in_deck("", material._table(files))
        if tables.setdefault(material.name, table) != table:
            mistakes.append(f"study: materials.{material.name}: two different materials have this name")
    return tables, list(dict.fromkeys(mistakes))


class Study:
    """What is asked for: stages, from the smallest scale up, and their tests.

    The study is checked at once: InputError has a line for every mistake. dimensions: 2 (plane strain) or 3;
    materials: those that stages name by text; tests, measurements: Tests or a dictionary of its arguments, and one
    Measurement or several; directory: what the names of files are relative to. read_study() reads a study from a deck.
    A study can be pickled; one from a deck is read again from there.
    """

    def __init__(self, stages: Stage | Iterable[Stage], tests: Tests | Mapping[str, Any], *, title: str | None = None,
                 dimensions: int | None = None, materials: Material | Iterable[Material] = (),
                 measurements: Measurement | Iterable[Measurement] = (), directory: PathLike = ".", **keys: Any) -> None:
        self._files = _deck.Files()
        self._directory = os.fspath(Path(directory).absolute())
        self._deck_path: str | None = None
        stages = several_of("stages", Stage, stages)
        tests = Tests(**tests) if isinstance(tests, Mapping) else tests
        if not isinstance(tests, Tests):
            raise InputError(f'tests: expected Tests, as in Tests(times=("1 ms", "1 s")), got {tests!r}')
        named = [material for stage in stages for material in stage._materials()]
        tables, mistakes = _by_name([*several_of("materials", Material, materials), *named], self._files)
        deck = {"title": title, "dimensions": dimensions, **keys, "materials": tables,
                "stages": [stage._table(self._files) for stage in stages], "tests": tests._table(self._files),
                "measurements": [one._table(self._files)
                                 for one in several_of("measurements", Measurement, measurements)]}
        try:
            self._checked = _native.study_from_text(_deck.deck_text(in_deck("", deck)), self._directory, [])
        except InputError as error:
            raise InputError(self._files.in_words("\n".join([*mistakes, str(error)]))) from None
        if mistakes:
            raise InputError("\n".join(mistakes))

    @classmethod
    def _of(cls, checked: _native.CheckedStudy, deck: str) -> Study:
        study = cls.__new__(cls)
        study._files = _deck.Files()
        study._directory = os.path.dirname(deck)
        study._deck_path = deck
        study._checked = checked
        return study

    def __reduce__(self) -> tuple[Any, ...]:
        """A study is pickled as its deck: of one that was read the path, of one that was built the text and arrays."""
        if self._deck_path is not None:
            return _read_again, (self._deck_path, self._checked.overrides, self._checked.hash)
        return _built_again, (self._checked.deck, self._directory, self._files.contents(), self._files.place,
                              self._checked.overrides)

    def replace(self, overrides: Mapping[str, Any] | Iterable[str] | str) -> Study:
        """The same study with other values, by the paths of their keys: study.replace({"stages.0.filler.fraction": 0.4}).

        overrides: as of read_study(). What was replaced before, or overridden when the deck was read, stays as it is
        unless it is given again. The study itself is unchanged; a deck is not read again, the files that it names are,
        also when the study is pickled. A study whose deck has no title is called "study".
        Raises InputError with a line for every mistake.
        """
        given = _override_lines(overrides)
        paths = {line.partition("=")[0].strip() for line in given}
        kept = [line for line in self._checked.overrides if line.partition("=")[0].strip() not in paths]
        lines = [*kept, *given]
        study = Study.__new__(Study)
        study._files, study._directory, study._deck_path = self._files, self._directory, None
        try:
            study._checked = _native.study_from_text(self._checked.deck, self._directory, lines)
        except InputError as error:
            raise InputError(self._files.in_words(str(error))) from None
        return study

    @property
    def title(self) -> str:
        """What the results are called."""
        return self._checked.title

    @property
    def stages(self) -> list[str]:
        """Names of the stages, from the smallest scale up."""
        return self._checked.stages

    @property
    def materials(self) -> list[_native.Solid]:
        """The materials in SI units."""
        return self._checked.materials

    @property
    def overrides(self) -> list[str]:
        """What stands in place of values of the deck, as lines "key.path=value": overrides, and the values of a task of a
        sweep."""
        return self._checked.overrides

    @property
    def times(self) -> tuple[float, float]:
        """First and last time of the curves [s]."""
        return self._checked.times

    @property
    def deck(self) -> str:
        """The study as a deck. Of one that was read, as it stands in its file, without overrides."""
        return self._checked.deck

    def __repr__(self) -> str:
        return repr(self._checked)


def _override_lines(overrides: Mapping[str, Any] | Iterable[str] | str) -> list[str]:
    """Overrides as the command line has them."""
    if isinstance(overrides, Mapping):
        return [f"{path}=" + ("" if value is None else _deck.text_of(in_path(path, value)))
                for path, value in overrides.items()]
    return [overrides] if isinstance(overrides, str) else list(overrides)


def _sweep_line(path: str, values: Any) -> str:
    """A key of a sweep as the command line has it: with a list of values or a range of them."""
    if isinstance(values, Mapping):
        values = {key: in_path(path, value) if key in ("from", "to") else value for key, value in values.items()}
    elif isinstance(values, (str, bytes)) or not isinstance(values, (Iterable, np.ndarray)):
        raise InputError(f'keys: {path}: expected a list of values, or a range such as {{"from": 1, "to": 3}}, got '
                         f"{values!r}")
    else:
        values = in_path(path, list(values))
    return f"{path}={_deck.text_of(values)}"


def read_study(deck: PathLike, overrides: Mapping[str, Any] | Iterable[str] | str = ()) -> Study:
    """The study of a deck; its sweep is ignored.

    overrides: values by the paths of their keys, {"stages.0.cells": 96, "tests.method": "quasistatic"}, quantities as
    text or as numbers in the SI unit, None to remove a key; or lines "key.path=value", with quantities as text. Raises
    InputError with a line for every mistake, also where there is no such deck, and FileError where the deck cannot be
    read.
    """
    path = os.path.abspath(deck)
    return Study._of(_native.read_study(os.fspath(deck), _override_lines(overrides)), path)


def read_sweep(deck: PathLike, overrides: Mapping[str, Any] | Iterable[str] | str = (), *,
               keys: Mapping[str, Sequence[Any] | Mapping[str, Any]] | None = None) -> dict[str, Study]:
    """The studies of the sweep of a deck, by the names of its tasks.

    overrides: as of read_study(); keys: further keys to sweep, with their values: {"stages.*.packing.seed": [1, 2]}, or
    with a range of them as in a deck: {"from": 1, "to": 3}. Raises as read_study().
    """
    path = os.path.abspath(deck)
    lines = [_sweep_line(key, values) for key, values in (keys or {}).items()]
    tasks = _native.read_sweep(os.fspath(deck), _override_lines(overrides), lines)
    return {name: Study._of(study, path) for name, study in tasks}


def _read_again(deck: str, overrides: list[str], hash_: str) -> Study:
    """A pickled study that was read from a deck."""
    study = Study._of(_native.read_study(deck, overrides), deck)
    if study._checked.hash != hash_:
        raise InputError(f"{deck}: the deck or a file that it names has changed since the study was pickled")
    return study


def _built_again(deck: str, directory: str, files: dict[str, bytes], place: str, overrides: list[str]) -> Study:
    """A pickled study that was built in Python, with the files of its arrays in a place of their own."""
    study = Study.__new__(Study)
    study._files = _deck.Files.of(files)
    study._directory = directory
    study._deck_path = None
    text, lines = deck, overrides
    if files:
        text, *lines = (one.replace(place, study._files.place) for one in (deck, *overrides))
    study._checked = _native.study_from_text(text, directory, lines)
    return study
