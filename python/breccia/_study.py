"""Studies, read from decks or built in Python.

A quantity is text with a unit, such as "0.5 um" or "3.6 GPa", as in a deck, or a number in the SI unit that stands in
brackets. Every class also takes further keys of a deck by their names, and a study reports all mistakes at once.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Iterable, Mapping, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _deck, _native
from ._errors import InputError

Quantity = Union[str, float]
Modulus = Union[str, float, _native.PronySeries, Mapping[str, Any]]
PathLike = Union[str, "os.PathLike[str]"]


def _modulus(value: Any) -> Any:
    """A modulus as a deck has it."""
    if isinstance(value, _native.PronySeries):
        if value.is_elastic:
            return _deck.quantity(value.equilibrium, "Pa")
        terms = [{"time": f"{time!r} s", "modulus": f"{modulus!r} Pa"} for time, modulus in value.terms.tolist()]
        return {"terms": terms, "equilibrium": f"{value.equilibrium!r} Pa" if value.equilibrium > 0.0 else None}
    return _deck.quantity(value, "Pa")


def _shift(value: Any) -> Any:
    """A temperature shift as a deck has it; of a law alone, for moduli at its reference temperature."""
    if isinstance(value, _native.WilliamsLandelFerry):
        reference = f"{value.reference_temperature!r} K"
        return {"law": "wlf", "c1": value.c1, "c2": f"{value.c2!r} K", "reference": reference, "temperature": reference}
    return value


class _Table:
    """A table of a deck."""

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        raise NotImplementedError

    def __repr__(self) -> str:
        given = (f"{key.lstrip('_')}={value!r}" for key, value in vars(self).items() if value not in (None, (), {}))
        return f"breccia.{type(self).__name__}({', '.join(given)})"


class Material(_Table):
    """A linear viscoelastic solid.

    bulk, shear: bulk and shear modulus [Pa]: a quantity, a PronySeries, or a table as in a deck, such as
    {"prony": "binder.csv"}; density: [kg/m^3]; temperature_shift: a table as in a deck, or the law of a master curve,
    for moduli at its reference temperature.
    """

    def __init__(self, name: str, *, density: Quantity | None = None, bulk: Modulus | None = None,
                 shear: Modulus | None = None,
                 temperature_shift: Mapping[str, Any] | _native.WilliamsLandelFerry | None = None, **keys: Any) -> None:
        self.name = name
        self.density = density
        self.bulk = bulk
        self.shear = shear
        self.temperature_shift = temperature_shift
        self.keys = keys

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        return {"density": _deck.quantity(self.density, "kg/m^3"), "bulk": _modulus(self.bulk),
                "shear": _modulus(self.shear), "temperature_shift": _shift(self.temperature_shift),
                **{key: _modulus(value) for key, value in self.keys.items()}}

    def solid(self, directory: PathLike = ".") -> _native.Solid:
        """The material in SI units. Files that it names are relative to the directory. Raises InputError."""
        table = self._table(_deck.Files())
        lines = [f"{key} = {_deck.text_of(value)}" for key, value in table.items() if value is not None]
        return _native.solid_from_text("\n".join(lines) + "\n", self.name, os.fspath(directory))


class Coating(_Table):
    """A layer of another material around each particle. thickness: [m]."""

    def __init__(self, material: Material | str, *, thickness: Quantity, **keys: Any) -> None:
        self.material = material
        self.thickness = thickness
        self.keys = keys

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        return {"material": name_of(self.material), "thickness": _deck.quantity(self.thickness, "m"), **self.keys}


class Filler(_Table):
    """The particles of one kind in a stage.

    diameter: of particles of one size [m]; or sizes: the name of a table of sizes, an array of the diameters of all
    particles [m], or a table as in a deck, such as {"lognormal": [{"median": "20 um", "sigma": 0.4}]}; fraction: share
    of the box, 0.35 or "35 %"; smallest, largest: ends of the distribution [m]; gap: between surfaces [m]; shape: a
    table such as {"aspect": 1.5}.
    """

    def __init__(self, material: Material | str, *, fraction: float | str | None = None,
                 diameter: Quantity | None = None, sizes: PathLike | Sequence[float] | Mapping[str, Any] | None = None,
                 smallest: Quantity | None = None, largest: Quantity | None = None, gap: Quantity | None = None,
                 shape: Mapping[str, Any] | None = None, coating: Coating | None = None, **keys: Any) -> None:
        if diameter is not None and sizes is not None:
            raise InputError("Filler: expected diameter or sizes, not both")
        self.material = material
        self.fraction = fraction
        self.diameter = diameter
        self.sizes = sizes
        self.smallest = smallest
        self.largest = largest
        self.gap = gap
        self.shape = shape
        self.coating = coating
        self.keys = keys

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        sizes: Any = self.sizes
        if self.diameter is not None:
            sizes = {"diameter": _deck.quantity(self.diameter, "m")}
        elif isinstance(sizes, (list, tuple, np.ndarray)):
            sizes = {"list": _deck.quantities(np.asarray(sizes).tolist(), "m")}
        return {"material": name_of(self.material), "fraction": self.fraction, "sizes": sizes,
                "from": _deck.quantity(self.smallest, "m"), "to": _deck.quantity(self.largest, "m"),
                "gap": _deck.quantity(self.gap, "m"), "shape": self.shape,
                "coating": None if self.coating is None else self.coating._table(files), **self.keys}


class Packing(_Table):
    """Where the particles of all fillers are.

    method: "lubachevsky-stillinger", "random-sequential", "regular", "explicit", "laguerre"; the keys of each are those
    of a deck, such as seed, walls, columns, rows, lattice, film. particles: of an explicit packing, a file or an array
    of n rows x, y, diameter [m], in a cube x, y, z, diameter.
    """

    def __init__(self, method: str | None = None, *, seed: int | None = None, walls: bool | str | None = None,
                 particles: PathLike | NDArray[Any] | None = None, film: Quantity | None = None, **keys: Any) -> None:
        self.method = "explicit" if method is None and particles is not None else method
        self.seed = seed
        self.walls = walls
        self.particles = particles
        self.film = film
        self.keys = keys

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        particles: Any = self.particles
        if isinstance(particles, (list, tuple, np.ndarray)):
            rows = np.asarray(particles, dtype=float)
            names = {3: ["x_m", "y_m", "diameter_m"], 4: ["x_m", "y_m", "z_m", "diameter_m"]}
            if rows.ndim != 2 or rows.shape[1] not in names:
                raise InputError("Packing: particles: expected n rows x, y, diameter or x, y, z, diameter, got an array "
                                 f"of shape {rows.shape}")
            particles = files.table(dict(zip(names[rows.shape[1]], rows.T)))
        return {"method": self.method, "seed": self.seed, "walls": self.walls, "particles": particles,
                "film": _deck.quantity(self.film, "m"), **self.keys}


class Image(_Table):
    """An image in place of particles.

    labels: an array of whole numbers, [y, x] with the top row first, or [z, y, x] in a cube; or a file; materials: the
    material of each value; pixel: side of a pixel [m]; periodic: whether the image continues at its sides.
    """

    def __init__(self, labels: PathLike | NDArray[Any], *, materials: Mapping[int, Material | str],
                 pixel: Quantity | None = None, periodic: bool | None = None, **keys: Any) -> None:
        self.labels = labels
        self.materials = dict(materials)
        self.pixel = pixel
        self.periodic = periodic
        self.keys = keys

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        file = self.labels if isinstance(self.labels, (str, os.PathLike)) else files.image(self.labels)
        labels = [{"value": int(value), "material": name_of(material)} for value, material in self.materials.items()]
        return {"method": "image", "file": file, "pixel": _deck.quantity(self.pixel, "m"), "labels": labels,
                "periodic": self.periodic, **self.keys}

    def __repr__(self) -> str:
        shape = self.labels if isinstance(self.labels, (str, os.PathLike)) else np.shape(self.labels)
        return f"breccia.Image({shape}, pixel={self.pixel!r})"


class Stage(_Table):
    """A box of matrix with particles.

    matrix: a material, or an earlier stage, whose result it is then; box: side [m]; cells: per side, or several
    numbers for an extrapolation; fillers: a Filler or several; packing: a Packing, the method alone, or an Image.
    """

    def __init__(self, name: str, *, matrix: Material | Stage | str, box: Quantity | None = None,
                 cells: int | Sequence[int] | None = None, fillers: Filler | Iterable[Filler] = (),
                 packing: Packing | Image | str | None = None, **keys: Any) -> None:
        self.name = name
        self.matrix = matrix
        self.box = box
        self.cells = cells
        self.fillers = (fillers,) if isinstance(fillers, Filler) else tuple(fillers)
        self.packing = Packing(packing) if isinstance(packing, str) else packing
        self.keys = keys

    def _materials(self) -> Iterable[Material]:
        named: list[Any] = [self.matrix]
        for filler in self.fillers:
            named += [filler.material, filler.coating.material if filler.coating is not None else None]
        if isinstance(self.packing, Image):
            named += self.packing.materials.values()
        return (material for material in named if isinstance(material, Material))

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        fillers = [filler._table(files) for filler in self.fillers]
        return {"name": self.name, "matrix": name_of(self.matrix), "box": _deck.quantity(self.box, "m"),
                "cells": self.cells, "filler": fillers[0] if len(fillers) == 1 else fillers or None,
                "packing": None if self.packing is None else self.packing._table(files), **self.keys}


class Tests(_Table):
    """The virtual tests of every stage.

    times: first and last time of the curves [s]; frequencies: in their place, the first and the last of the dynamic
    moduli [Hz]; loads: "shear", "bulk", ...; boundaries: "displacement" (upper bound), "traction" (lower bound),
    "periodic"; method: "quasistatic", "dynamic" or both; fields: "none", "last" or times [s]; quasistatic, dynamic:
    tables of their settings. All other keys are those of [tests] in a deck.
    """

    __test__ = False  # this is no test of pytest

    def __init__(self, *, times: Sequence[Quantity] | None = None, frequencies: Sequence[Quantity] | None = None,
                 loads: Sequence[str] | str | None = None, boundaries: Sequence[str] | str | None = None,
                 method: str | Sequence[str] | None = None, points_per_decade: int | None = None,
                 fields: str | Sequence[Quantity] | None = None, quasistatic: Mapping[str, Any] | None = None,
                 dynamic: Mapping[str, Any] | None = None, **keys: Any) -> None:
        self.times = times
        self.frequencies = frequencies
        self.loads = [loads] if isinstance(loads, str) else loads
        self.boundaries = [boundaries] if isinstance(boundaries, str) else boundaries
        self.method = method
        self.points_per_decade = points_per_decade
        self.fields = fields
        self.quasistatic = quasistatic
        self.dynamic = dynamic
        self.keys = keys

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        return {"times": _deck.quantities(self.times, "s"),
                "frequencies": _deck.quantities(self.frequencies, "Hz"), "loads": self.loads,
                "boundaries": self.boundaries, "method": self.method, "points_per_decade": self.points_per_decade,
                "fields": _deck.quantities(self.fields, "s"), "quasistatic": self.quasistatic, "dynamic": self.dynamic,
                **self.keys}


class Measurement(_Table):
    """A measured shear relaxation modulus, which G(t) of a stage is compared with.

    shear: a PronySeries, (times [s], moduli [Pa]), or a table as in a deck; stage: the last one by default; times: at
    which the measurement is valid [s].
    """

    def __init__(self, name: str, *, shear: Any, stage: Stage | str | None = None,
                 times: Sequence[Quantity] | None = None, **keys: Any) -> None:
        self.name = name
        self.shear = shear
        self.stage = stage
        self.times = times
        self.keys = keys

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        shear = self.shear
        if isinstance(shear, (tuple, list)):
            shear = {"curve": files.table({"time_s": np.asarray(shear[0]), "shear_modulus_Pa": np.asarray(shear[1])})}
        stage = None if self.stage is None else name_of(self.stage)
        return {"name": self.name, "shear": _modulus(shear), "stage": stage,
                "times": _deck.quantities(self.times, "s"), **self.keys}


def name_of(named: Any) -> str:
    """The name of a material or a stage."""
    return named if isinstance(named, str) else str(named.name)


def _by_name(materials: Iterable[Material], files: _deck.Files) -> tuple[dict[str, Any], list[str]]:
    """The tables of materials by their names, and a line for each name of several."""
    tables: dict[str, Any] = {}
    mistakes = []
    for material in materials:
        table = material._table(files)
        if tables.setdefault(material.name, table) != table:
            mistakes.append(f"study: materials.{material.name}: two different materials have this name")
    return tables, list(dict.fromkeys(mistakes))


class Study:
    """What is asked for: stages, from the smallest scale up, and their tests.

    The study is checked at once: InputError has a line for every mistake. dimensions: 2 (plane strain) or 3;
    materials: those that stages name by text; directory: what the names of files are relative to. read_study() reads a
    study from a deck. A study can be pickled; one from a deck is read again from there.
    """

    def __init__(self, stages: Stage | Iterable[Stage], tests: Tests, *, title: str | None = None,
                 dimensions: int | None = None, materials: Iterable[Material] = (),
                 measurements: Iterable[Measurement] = (), directory: PathLike = ".", **keys: Any) -> None:
        self._files = _deck.Files()
        self._directory = os.fspath(Path(directory).absolute())
        self._deck_path: str | None = None
        stages = [stages] if isinstance(stages, Stage) else list(stages)
        named = [material for stage in stages for material in stage._materials()]
        tables, mistakes = _by_name([*materials, *named], self._files)
        deck = {"title": title, "dimensions": dimensions, **keys, "materials": tables,
                "stages": [stage._table(self._files) for stage in stages], "tests": tests._table(self._files),
                "measurements": [measurement._table(self._files) for measurement in measurements]}
        try:
            self._checked = _native.study_from_text(_deck.deck_text(deck), self._directory)
        except InputError as error:
            raise InputError("\n".join([*mistakes, str(error)])) from None
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
        return _built_again, (self._checked.deck, self._directory, self._files.contents(), self._files.place)

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
    def times(self) -> tuple[float, float]:
        """First and last time of the curves [s]."""
        return self._checked.times

    @property
    def deck(self) -> str:
        """The study as a deck. Of one that was read, as it stands in its file, without overrides."""
        return self._checked.deck

    def __repr__(self) -> str:
        return repr(self._checked)


def _override_lines(overrides: Mapping[str, Any] | Iterable[str]) -> list[str]:
    """Overrides as the command line has them."""
    if isinstance(overrides, Mapping):
        return [f"{key}={_deck.text_of(value)}" for key, value in overrides.items()]
    return list(overrides)


def read_study(deck: PathLike, overrides: Mapping[str, Any] | Iterable[str] = ()) -> Study:
    """The study of a deck; its sweep is ignored.

    overrides: values by the paths of their keys, {"stages.0.cells": 96, "tests.method": "quasistatic"}, or lines
    "key.path=value". Raises InputError with a line for every mistake, and FileError.
    """
    path = os.path.abspath(deck)
    return Study._of(_native.read_study(os.fspath(deck), _override_lines(overrides)), path)


def read_sweep(deck: PathLike, overrides: Mapping[str, Any] | Iterable[str] = (), *,
               keys: Mapping[str, Sequence[Any]] | None = None) -> dict[str, Study]:
    """The studies of the sweep of a deck, by the names of its tasks.

    overrides: as of read_study(); keys: further keys to sweep, with their values: {"stages.*.packing.seed": [1, 2]}.
    Raises as read_study().
    """
    path = os.path.abspath(deck)
    lines = [f"{key}={_deck.text_of(list(values))}" for key, values in (keys or {}).items()]
    tasks = _native.read_sweep(os.fspath(deck), _override_lines(overrides), lines)
    return {name: Study._of(study, path) for name, study in tasks}


def _read_again(deck: str, overrides: list[str], hash_: str) -> Study:
    """A pickled study that was read from a deck."""
    study = Study._of(_native.read_study(deck, overrides), deck)
    if study._checked.hash != hash_:
        raise InputError(f"{deck}: the deck or a file that it names has changed since the study was pickled")
    return study


def _built_again(deck: str, directory: str, files: dict[str, bytes], place: str) -> Study:
    """A pickled study that was built in Python, with the files of its arrays in a place of their own."""
    study = Study.__new__(Study)
    study._files = _deck.Files.of(files)
    study._directory = directory
    study._deck_path = None
    text = deck.replace(place, study._files.place) if files else deck
    study._checked = _native.study_from_text(text, directory)
    return study
