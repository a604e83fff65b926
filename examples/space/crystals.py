#!/usr/bin/env python3
"""Cubic crystals in a cubic lattice of spheres, 20 %, with the axes of the box: each shear modulus against that of isotropic
spheres with the modulus of the crystal for this shear, C44 or C' = (C11 - C12) / 2, on the same grid. Both would be equal if
the strain in a sphere were uniform, as it is in a dilute one.

    examples/space/crystals.py [CELLS ...]      by default 8, 16, 32 and 48"""

import sys
from math import pi

from runs import header, measured, row

BINDER, BULK, FRACTION = 1e9, 10e9, 0.2
KEYS = {"stages.0.filler.sizes.diameter": f'"{(6.0 * FRACTION / pi) ** (1.0 / 3.0):.9g} mm"',
        "materials.matrix.bulk": f'"{3.0 * BINDER} Pa"', "materials.matrix.shear": f'"{BINDER} Pa"'}


def sphere(moduli):
    """A material of the spheres, as TOML."""
    return {"materials.sphere": f'{{ density = "1 g/cm^3", {moduli} }}'}


def isotropic(shear, load, cells, mixing):
    keys = KEYS | sphere(f'bulk = "{BULK} Pa", shear = "{shear} Pa"') | {"stages.0.cells": cells, "tests.mixing": f'"{mixing}"'}
    return measured(f"isotropic-{shear:g}-{mixing}-{cells}", "cubic-array.toml", keys).modulus(load)


header("C44 / C'", "mixing", "cells", "shear xy", "shear xx-yy")
for c44, prime in ((8e9, 2e9), (6e9, 3e9)):
    constants = f'C11 = "{BULK + 4 / 3 * prime} Pa", C12 = "{BULK - 2 / 3 * prime} Pa", C44 = "{c44} Pa"'
    crystal = sphere(f'stiffness = {{ symmetry = "cubic", {constants} }}')
    aligned = KEYS | crystal | {"stages.0.filler.orientations": '"aligned"'}
    for mixing in ("series", "points"):
        for cells in [int(number) for number in sys.argv[1:]] or [8, 16, 32, 48]:
            run = measured(f"crystals-{c44 / prime:g}-{mixing}-{cells}", "cubic-array.toml",
                           aligned | {"stages.0.cells": cells, "tests.mixing": f'"{mixing}"'})
            errors = [run.modulus(load) / isotropic(shear, load, cells, mixing) - 1.0
                      for shear, load in ((c44, "shear"), (prime, "shear-xx-yy"))]
            row(f"{c44 / prime:g}", mixing, cells, *(f"{error:+.2%}" for error in errors))
