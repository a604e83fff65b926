# %% [markdown]
# # Your own material
#
# A rubber with 40 % of glass beads, from nothing but its constituents, without a deck.

# %%
import numpy as np

import breccia

# %%
# Quantities are text with units, or numbers in SI units.
rubber = breccia.Material("rubber", density="1.1 g/cm^3", bulk="2 GPa",
                          shear=breccia.PronySeries([(1e-4, 40e6), (1e-2, 10e6), (1.0, 2e6)], equilibrium=1e6))
young, poisson = 70e9, 0.22
glass = breccia.Material("glass", density=2500.0, bulk=young / (3 * (1 - 2 * poisson)),
                         shear=young / (2 * (1 + poisson)))
beads = breccia.Filler(glass, fraction="40 %", sizes={"lognormal": [{"median": "50 um", "sigma": 0.2}]},
                       smallest="30 um", largest="80 um", gap="8 um")
stage = breccia.Stage("filled-rubber", matrix=rubber, box="0.5 mm", cells=100, fillers=beads,
                      packing=breccia.Packing("lubachevsky-stillinger", seed=1))
tests = breccia.Tests(times=("10 us", "10 s"), boundaries=["displacement", "traction"], fields="none")

# %%
# A study is checked when it is made; all mistakes come at once.
try:
    breccia.Study(breccia.Stage("oops", matrix=rubber, box="0.5 um/s", cells=1), tests)
except breccia.InputError as error:
    print("\n".join(error.mistakes))

# %%
result = breccia.solve(breccia.Study(stage, tests, title="Rubber with glass beads"))
for boundary in ("displacement", "traction"):
    series = result["filled-rubber"].prony(boundary=boundary)
    times = np.array([1e-5, 1e-3, 1e-1, 10.0])
    stiffening = series.at(times) / rubber.shear.at(times)
    print(f"{boundary:>12}: G / G of the rubber =", np.round(stiffening, 2))
for warning in result.warnings:
    print("warning:", warning)
