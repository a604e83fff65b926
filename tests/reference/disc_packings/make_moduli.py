"""Writes moduli.csv: all packings with rigid discs, those of up to 60 discs with deformable discs, too."""
import glob
import os
import sys

from disc_moduli import discs_in, moduli

COARSE = (3, 0.6, 2)
FINE = (4, 0.5, 2)
FINE_DEFORMABLE = (4, 0.6, 2)
BINDER_BULK = (1e3, 1e6)
MORE_CONTRASTS = ("square_g030", "equal_60_040_g050", "ratio3_67_040_g020", "ratio2_62_060_spread")


def main(program, *names):
    print("""\
# Apparent moduli of the periodic packings in packings/, plane strain, over the shear modulus g of the binder.
# K_over_g: three-dimensional bulk modulus of the binder. Gf_over_g: shear modulus of the discs, inf = rigid; the others
# have K/G = 13.4/5.84. Loads and moduli: README.md. relative_error is the change from a cubic mesh to the quartic one
# whose value is given. Made by make_moduli.py.
packing,discs,K_over_g,Gf_over_g,load,modulus,relative_error,unknowns""")
    packings = [f"packings/{name}.csv" for name in names] or glob.glob("packings/*.csv")
    packings = sorted(packings, key=lambda packing: (discs_in(packing), packing))
    cases = [(packing, None) for packing in packings]
    cases += [(packing, 1000) for packing in packings if discs_in(packing) <= 60]
    cases += [(packing, shear) for name in MORE_CONTRASTS for shear in (100, 10000)
              for packing in packings if packing == f"packings/{name}.csv"]
    for packing, shear in cases:
        coarse = moduli(program, "periodic", packing, COARSE, BINDER_BULK, shear)
        fine = moduli(program, "periodic", packing, FINE if shear is None else FINE_DEFORMABLE, BINDER_BULK, shear)
        for (bulk, load), (modulus, unknowns) in fine.items():
            error = abs(coarse[bulk, load][0] / modulus - 1)
            print(f"{os.path.basename(packing)},{discs_in(packing)},{bulk:g},{shear or 'inf'},{load},{modulus:.9g},"
                  f"{error:.1e},{unknowns}", flush=True)


main(*sys.argv[1:])
