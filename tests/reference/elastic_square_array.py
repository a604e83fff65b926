"""Writes elastic_square_array.csv: one disc in a periodic or displacement-driven cell, matrix shear modulus 1."""
from conforming import Composite
import numpy as np

CONTRASTS = (10, 1e2, 1e3, 1e4, 1e5)
print("""# Effective plane-strain moduli of one disc in a square cell, over the matrix shear modulus.
# load bulk: K + G/3. bulk_ratio: K/G of the matrix; the filler has K/G = 13.4/5.84. Made by elastic_square_array.py:
# quartic triangles with second-order geometry; relative_error is the change from mesh size 0.15 to 0.1 of the pitch.
fraction,contrast,boundary,load,bulk_ratio,modulus,relative_error""")
for fraction in (0.35, 0.5, 0.65):
    radius = np.sqrt(fraction / np.pi)
    coarse, fine = (Composite(1.0, radius, 1, size) for size in (0.15, 0.1))
    for boundary in ("periodic", "displacement") if fraction == 0.35 else ("periodic",):
        for ratio in (3.0, 3600.0):
            for contrast in CONTRASTS:
                K, G = (ratio, contrast * 13.4 / 5.84), (1.0, contrast)
                for load in ("xy", "xx-yy", "bulk"):
                    low, high = (c.modulus(load, boundary, K, G)[0] for c in (coarse, fine))
                    print(f"{fraction},{contrast:g},{boundary},{load},{ratio:g},{high:.9g},{abs(low / high - 1):.1e}",
                          flush=True)
