"""Writes moduli_walls.csv: the packings with walls, under both boundaries, with rigid and with deformable discs."""
import glob
import os
import sys

from disc_moduli import discs_in, moduli

COARSE = (3, 0.6, 2)
FINE = {None: (4, 0.5, 2), 1000: (4, 0.6, 2)}  # by the shear modulus of the discs
BINDER_BULK = (10, 1e3, 1e6)


def main(program, *names):
    print("""\
# Apparent moduli of the packings with walls in packings_walls/, plane strain, over the shear modulus g of the binder.
# boundary: displacement (u = E x on the walls) or traction (S n on the walls). K_over_g: three-dimensional bulk modulus
# of the binder. Gf_over_g: shear modulus of the discs, inf = rigid; the others have K/G = 13.4/5.84. Loads and moduli:
# README.md. relative_error is the change from a cubic mesh to the quartic one whose value is given. Made by
# make_moduli_walls.py.
packing,discs,boundary,K_over_g,Gf_over_g,load,modulus,relative_error,unknowns""")
    packings = [f"packings_walls/{name}.csv" for name in names] or glob.glob("packings_walls/*.csv")
    packings = sorted(packings, key=lambda packing: (discs_in(packing), packing))
    cases = [(packing, boundary, shear) for shear in FINE for packing in packings
             for boundary in ("displacement", "traction")]
    for packing, boundary, shear in cases:
        coarse, fine = (moduli(program, boundary, packing, mesh, BINDER_BULK, shear) for mesh in (COARSE, FINE[shear]))
        for (bulk, load), (modulus, unknowns) in fine.items():
            error = abs(coarse[bulk, load][0] / modulus - 1)
            print(f"{os.path.basename(packing)},{discs_in(packing)},{boundary},{bulk:g},{shear or 'inf'},{load},"
                  f"{modulus:.9g},{error:.1e},{unknowns}", flush=True)


main(*sys.argv[1:])
