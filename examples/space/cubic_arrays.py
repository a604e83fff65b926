#!/usr/bin/env python3
"""Errors of K, (C11 - C12)/2 and C44 of cubic lattices of spheres, row by row of the references, as a table.

    examples/space/cubic_arrays.py rigid|elastic [CELLS ...]      by default 16, 32 and 64

The last column is the limit of ever finer grids, from the two finest ones: the errors are of the first order in the side of
a cell. All rows with 64 cells take a quarter of an hour."""

import sys
from math import pi

from runs import REFERENCE, header, measured, read, row

LOADS = ("bulk", "shear-xx-yy", "shear")
SPHERES_IN_CUBE = {"sc": 1, "bcc": 2, "fcc": 4}


class Array:
    """A row of a reference: a lattice, its materials, and K, (C11 - C12)/2 and C44 [Pa]."""

    def __init__(self, name, lattice, fraction, matrix, sphere, moduli):
        self.name, self.lattice, self.fraction = name, lattice, float(fraction)
        self.matrix, self.sphere, self.moduli = matrix, sphere, moduli

    def keys(self, cells):
        diameter = (6.0 * self.fraction / (pi * SPHERES_IN_CUBE[self.lattice])) ** (1.0 / 3.0)
        return {
            "stages.0.cells": cells,
            "stages.0.packing.lattice": f'"{self.lattice}"',
            "stages.0.filler.sizes.diameter": f'"{diameter:.9g} mm"',
            "materials.matrix.bulk": f'"{self.matrix[0]:.9g} Pa"',
            "materials.matrix.shear": f'"{self.matrix[1]:.9g} Pa"',
            "materials.sphere.bulk": f'"{self.sphere[0]:.9g} Pa"',
            "materials.sphere.shear": f'"{self.sphere[1]:.9g} Pa"',
        }

    def errors(self, cells):
        """In per cent."""
        run = measured(f"{self.name}-{cells}", "cubic-array.toml", self.keys(cells))
        return [100.0 * (run.modulus(load) / exact - 1.0) for load, exact in zip(LOADS, self.moduli)]


def rigid_arrays():
    matrix_shear, contrast = 1e6, 1e6
    for line in read(REFERENCE / "rigid_cubic_arrays.csv"):
        ratio = float(line["matrix_K_over_G"])
        matrix = ratio * matrix_shear, matrix_shear
        moduli = (float(line["K_over_matrix_K"]) * matrix[0], float(line["mu1_over_matrix_G"]) * matrix_shear,
                  float(line["C44_over_matrix_G"]) * matrix_shear)
        name = f"rigid-{line['array']}-{line['fraction']}-{ratio:.3g}"
        yield Array(name, line["array"], line["fraction"], matrix, [contrast * one for one in matrix], moduli)


def elastic_arrays():
    for line in read(REFERENCE / "elastic_cubic_arrays.csv"):
        is_table_1 = line["case"] == "Table 1"
        shear = float(line["matrix_shear_Pa"])
        matrix = (1e6 if is_table_1 else 62.5e9), shear
        sphere = (50e6, 18.8e6) if is_table_1 else (222.222e9, 166.6667e9)
        moduli = [float(line[name]) for name in ("K_Pa", "mu1_Pa", "C44_Pa")]
        name = f"elastic-{line['array']}-{line['fraction']}-{shear:.3g}"
        yield Array(name, line["array"], line["fraction"], matrix, sphere, moduli)


def written(errors):
    return ", ".join(f"{error:+.2f}" for error in errors)


kind, *numbers = sys.argv[1:]
arrays = {"rigid": rigid_arrays, "elastic": elastic_arrays}[kind]
cells = [int(number) for number in numbers] or [16, 32, 64]
header("lattice", "fraction", "matrix K/G", *(f"{n} cells" for n in cells), *(["limit"] if len(cells) > 1 else []))
for array in arrays():
    errors = {n: array.errors(n) for n in cells}
    limit = []
    if len(cells) > 1:
        coarse, fine = cells[-2:]
        of_first_order = [(fine * e - coarse * c) / (fine - coarse) for c, e in zip(errors[coarse], errors[fine])]
        limit = [written(of_first_order)]
    ratio = array.matrix[0] / array.matrix[1]
    row(array.lattice, f"{array.fraction:g}", f"{ratio:.3g}", *(written(errors[n]) for n in cells), *limit)
