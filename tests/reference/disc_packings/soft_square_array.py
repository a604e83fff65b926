"""Writes soft_square_array.csv: one disc, softer than the matrix, in a periodic box."""
import math
import sys
import tempfile

from disc_moduli import moduli

COARSE, FINE = (4, 0.6, 2), (5, 0.3, 4)
BULK_RATIOS = (3, 3600)


def main(program):
    print("""\
# Effective plane-strain moduli of one soft disc in a square cell, over the matrix shear modulus; columns as in
# elastic_square_array.csv. load bulk: K + G/3. bulk_ratio: K/G of the matrix; the filler has K/G = 13.4/5.84. Made by
# disc_packings/soft_square_array.py: quintic quadrilaterals that follow the circle; relative_error is the change from
# quartic ones that are twice as large.
fraction,contrast,boundary,load,bulk_ratio,modulus,relative_error""")
    for fraction in (0.2, 0.5):
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as packing:
            print(f"x,y,diameter\n0.5,0.5,{2 * math.sqrt(fraction / math.pi)!r}", file=packing, flush=True)
            for contrast in (0.5, 0.1, 0.01, 1e-4):
                coarse, fine = (moduli(program, "periodic", packing.name, mesh, BULK_RATIOS, contrast)
                                for mesh in (COARSE, FINE))
                for bulk_ratio in BULK_RATIOS:
                    for load in ("xy", "xx-yy", "bulk"):
                        modulus = fine[bulk_ratio, load][0]
                        error = abs(coarse[bulk_ratio, load][0] / modulus - 1)
                        print(f"{fraction},{contrast:g},periodic,{load},{bulk_ratio},{modulus:.9g},{error:.1e}")


main(sys.argv[1])
