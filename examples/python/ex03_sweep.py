# %% [markdown]
# # A sweep is a loop
#
# How the modulus grows with the fraction of filler, and how much a packing differs from the next.

# %%
import numpy as np

import breccia

binder = breccia.Material("binder", density=1200.0, bulk="1 GPa", shear=breccia.PronySeries([(1.0, 9e6)], 1e6))
filler = breccia.Material("filler", density=2500.0, bulk="40 GPa", shear="25 GPa")


# %%
def modulus(fraction, seed, time=10.0):
    """Upper and lower bound of G(t) [Pa] of one packing."""
    discs = breccia.Filler(filler, fraction=fraction, diameter="0.1 mm", gap="23 um")
    stage = breccia.Stage("box", matrix=binder, box="0.6 mm", cells=40, fillers=discs,
                          packing=breccia.Packing("lubachevsky-stillinger", seed=seed))
    tests = breccia.Tests(times=(0.1, 10.0), points_per_decade=5, fields="none")
    box = breccia.solve(breccia.Study(stage, tests))["box"]
    return [box.prony(boundary=boundary).at(time) for boundary in ("displacement", "traction")]


# %%
for fraction in (0.1, 0.25, 0.4):
    packings = np.array([modulus(fraction, seed) for seed in (1, 2, 3)]) / 1e6
    (upper, lower), (spread, _) = packings.mean(axis=0), packings.std(axis=0, ddof=1)
    print(f"{100 * fraction:3.0f} %: G(10 s) between {lower:.2f} and {upper:.2f} MPa; packings differ by {spread:.2f}")
    assert lower < upper
