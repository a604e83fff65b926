"""Runs the program disc_moduli."""
import os
import subprocess

BULK_OVER_SHEAR = 13.4 / 5.84  # of deformable discs


def discs_in(packing):
    with open(packing) as file:
        return sum(1 for line in file if line[0].isdigit())


def run(program, boundary, packing, mesh, binder_bulk, discs):
    """Moduli and numbers of unknowns by (binder_bulk, load).

    `boundary` is periodic, displacement or traction, `mesh` is (order, length, layers), `discs` is (bulk, shear), or ()
    if they are rigid.
    """
    words = [program, boundary, packing, *map(str, mesh), ",".join(f"{bulk:g}" for bulk in binder_bulk),
             *map(repr, discs)]
    lines = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True,
                           env={**os.environ, "OPENBLAS_NUM_THREADS": "1"}).stdout.splitlines()
    area_error = float(lines[0].split()[-1])
    if abs(area_error) > 1e-4:
        raise RuntimeError(f"{packing}: the areas of the elements miss that of the binder by {area_error}")
    rows = (line.split(",") for line in lines[2:])
    return {(float(bulk), load): (float(modulus), int(unknowns)) for bulk, load, modulus, unknowns in rows}


def moduli(program, boundary, packing, mesh, binder_bulk, disc_shear):
    """The same for discs of this shear modulus and the usual ratio of the bulk modulus to it; None: rigid discs."""
    discs = () if disc_shear is None else (BULK_OVER_SHEAR * disc_shear, disc_shear)
    return run(program, boundary, packing, mesh, binder_bulk, discs)
