# %% [markdown]
# # Spheres in a cube
#
# A cubic lattice in three dimensions: both shear moduli, the bulk modulus, and the index of anisotropy over time.

# %%
import numpy as np

import breccia

matrix = breccia.Material("matrix", density=1100.0, bulk="500 MPa", shear=breccia.PronySeries([(1.0, 99e6)], 1e6))
glass = breccia.Material("glass", density=2500.0, bulk="40 GPa", shear="28 GPa")
stage = breccia.Stage("lattice", matrix=matrix, box="100 um", cells=10, fillers=breccia.Filler(glass, diameter="80 um"),
                      packing=breccia.Packing("regular", lattice="sc"))
tests = breccia.Tests(times=("10 ms", "100 s"), loads=["shear", "shear-xx-yy", "bulk"], boundaries="periodic",
                      fields="none", points_per_decade=5, quasistatic={"tolerance": 1e-3})

# %%
result = breccia.solve(breccia.Study(stage, tests, dimensions=3))
lattice = result["lattice"]
print(lattice.microstructure)
times = np.array([0.01, 1.0, 100.0])
along, across = (lattice.prony(load).at(times) for load in ("shear", "shear-xx-yy"))
bulk = lattice.prony("bulk").at(times)
print("C44             [MPa]", np.round(along / 1e6, 1))
print("(C11 - C12) / 2 [MPa]", np.round(across / 1e6, 1))
print("K               [MPa]", np.round(bulk / 1e6, 0))
print("C44 / mu1            ", np.round(along / across, 3))

# A simple cubic lattice is softer under C44, the more so the softer its matrix is.
assert (across > along).all()
