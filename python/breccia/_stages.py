"""Stages of studies that are built in Python: boxes of matrix with particles in them."""

from __future__ import annotations

import os
from typing import Any, Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from . import _deck
from ._errors import InputError
from ._materials import Material, Table, name_of, several_of
from ._quantities import PathLike, Quantity, numbers


class Coating(Table):
    """A layer of another material around each particle. thickness: [m]."""

    def __init__(self, material: Material | str, *, thickness: Quantity | Mapping[str, Any], **keys: Any) -> None:
        self.material = material
        self.thickness = thickness
        self.keys = keys

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        return {"material": name_of("Coating: material", self.material), "thickness": self.thickness, **self.keys}


class Filler(Table):
    """The particles of one kind in a stage.

    diameter: of particles of one size [m]; or sizes: the name of a table of sizes, an array of the diameters of all
    particles [m], or a table as in a deck, such as {"lognormal": [{"median": "20 um", "sigma": 0.4}]} or {"fuller":
    "16 mm"}; fraction: share of the box, 0.35 or "35 %", or amount={"mass": "65 %"}, the share of the whole composite;
    smallest, largest: ends of the distribution [m]; gap: between surfaces [m]; shape: a table such as {"aspect": 1.5}.
    """

    def __init__(self, material: Material | str, *, fraction: float | str | Mapping[str, Any] | None = None,
                 diameter: Quantity | Mapping[str, Any] | None = None, sizes: PathLike | Sequence[float] | Mapping[str, Any] | None = None,
                 smallest: Quantity | None = None, largest: Quantity | None = None, gap: Quantity | Mapping[str, Any] | None = None,
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
            sizes = {"diameter": self.diameter}
        elif isinstance(sizes, (list, tuple, np.ndarray)):
            sizes = {"list": sizes}
        return {"material": name_of("Filler: material", self.material), "fraction": self.fraction, "sizes": sizes,
                "from": self.smallest, "to": self.largest, "gap": self.gap, "shape": self.shape,
                "coating": _table_of("Filler: coating", self.coating, files), **self.keys}


class Packing(Table):
    """Where the particles of all fillers are.

    method: "random", "lubachevsky-stillinger", "random-sequential", "regular", "explicit", "laguerre"; the keys of each are those
    of a deck, such as seed, walls (False in random packings, unless the boundaries of the tests cut particles), columns,
    rows, lattice, film. particles: of an explicit packing, a file or an array of n rows x, y, diameter [m], in a cube
    x, y, z, diameter.
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
            rows = numbers("Packing: particles", particles, "m")
            names = {3: ["x_m", "y_m", "diameter_m"], 4: ["x_m", "y_m", "z_m", "diameter_m"]}
            if rows.ndim != 2 or rows.shape[1] not in names:
                raise InputError("Packing: particles: expected n rows x, y, diameter or x, y, z, diameter, got an array "
                                 f"of shape {rows.shape}")
            particles = files.table(dict(zip(names[rows.shape[1]], rows.T)), "particles of Packing")
        return {"method": self.method, "seed": self.seed, "walls": self.walls, "particles": particles,
                "film": self.film, **self.keys}


class Image(Table):
    """An image in place of particles.

    labels: an array of whole numbers, [y, x], in a cube [z, y, x], with the top row first, as pictures have it, and the
    lowest plane first; or a file; materials: the material of each value, or a list of those of 0, 1, ...; pixel: side of
    a pixel [m]; periodic: whether the image continues at its sides, True unless the boundaries of the tests cut it.

    A grey picture is divided by threshold, "otsu" or a grey value, and materials is {"dark": binder, "bright": glass}
    then; smooth: each pixel first takes the median of a square of so many pixels a side, such as 3; crop: the part of a
    picture, {"left": 0, "top": 20, "width": 400, "height": 400} in pixels, in a stack with "lowest" and "depth".

    Microstructure.labels() has the bottom row first: Image(box.labels()[0][..., ::-1, :], ...) has the same points, and
    with mixing = "points" the same moduli; by default the cells of a box know its exact particles, too.
    """

    def __init__(self, labels: PathLike | NDArray[Any], *,
                 materials: Mapping[int, Material | str] | Mapping[str, Material | str] | Sequence[Material | str],
                 pixel: Quantity | None = None, periodic: bool | None = None, threshold: float | str | None = None,
                 smooth: int | None = None, crop: Mapping[str, int] | None = None, **keys: Any) -> None:
        self.labels = labels
        if isinstance(materials, str) or not isinstance(materials, Iterable):
            raise InputError(f"Image: materials: expected the material of each value, as in {{0: rubber, 1: glass}}, got "
                             f"{materials!r}")
        by_value = materials if isinstance(materials, Mapping) else dict(enumerate(materials))
        self.materials: dict[Any, Material | str] = dict(by_value)
        self.pixel = pixel
        self.periodic = periodic
        self.threshold = threshold
        self.smooth = smooth
        self.crop = crop
        self.keys = keys

    def _labels(self) -> Any:
        """The key `labels`: a table of the two sides of a threshold, or one for each value."""
        named = {value: name_of("Image: materials", material) for value, material in self.materials.items()}
        if any(isinstance(value, str) for value in named):
            return named
        return [{"value": int(value), "material": name} for value, name in named.items()]

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        file = self.labels if isinstance(self.labels, (str, os.PathLike)) else files.image(
            self.labels, "labels of Image")
        return {"method": "image", "file": file, "pixel": self.pixel, "labels": self._labels(),
                "periodic": self.periodic, "threshold": self.threshold, "smooth": self.smooth, "crop": self.crop,
                **self.keys}

    def __repr__(self) -> str:
        shape = self.labels if isinstance(self.labels, (str, os.PathLike)) else np.shape(self.labels)
        return f"breccia.Image({shape}, pixel={self.pixel!r})"


class Stage(Table):
    """A box of matrix with particles.

    matrix: a material, or an earlier stage, whose result it is then; box: side [m], or particles: their number in its
    place; cells: per side, or several numbers for an extrapolation; fillers: a Filler or several; packing: a Packing,
    the method alone, or an Image. What is left out of box and cells is chosen for Tests(accuracy=...).
    """

    def __init__(self, name: str, *, matrix: Material | Stage | str, box: Quantity | None = None,
                 particles: int | None = None, cells: int | Sequence[int] | None = None, fillers: Filler | Iterable[Filler] | None = None,
                 packing: Packing | Image | str | None = None, **keys: Any) -> None:
        self.name = name
        self.matrix = matrix
        self.box = box
        self.particles = particles
        self.cells = cells
        self.fillers = several_of("Stage: fillers", Filler, fillers)
        self.packing = Packing(packing) if isinstance(packing, str) else packing
        self.keys = keys

    def _materials(self) -> Iterable[Material]:
        named: list[Any] = [self.matrix]
        for filler in self.fillers:
            named += [filler.material, getattr(filler.coating, "material", None)]
        if isinstance(self.packing, Image):
            named += self.packing.materials.values()
        return (material for material in named if isinstance(material, Material))

    def _table(self, files: _deck.Files) -> dict[str, Any]:
        fillers = [filler._table(files) for filler in self.fillers]
        return {"name": self.name, "matrix": name_of("Stage: matrix", self.matrix), "box": self.box,
                "particles": self.particles, "cells": self.cells, "filler": fillers[0] if len(fillers) == 1 else fillers or None,
                "packing": _table_of("Stage: packing", self.packing, files), **self.keys}


def _table_of(argument: str, part: Any, files: _deck.Files) -> dict[str, Any] | None:
    """The table of a part of a study, or of one that is left out nothing."""
    if part is not None and not isinstance(part, Table):
        raise InputError(f"{argument}: expected an object of Breccia, got {part!r}")
    return None if part is None else part._table(files)
