# %% [markdown]
# # A packing and its statistics
#
# Discs of two sizes: what was asked for, what came out, and how dense the neighbourhood of a disc is.

# %%
import numpy as np

import breccia

matrix = breccia.Material("matrix", density=1200.0, bulk="1 GPa", shear="1 MPa")
coarse = breccia.Material("coarse", density=2500.0, bulk="40 GPa", shear="25 GPa")
fine = breccia.Material("fine", density=2700.0, bulk="70 GPa", shear="26 GPa")
stage = breccia.Stage("box", matrix=matrix, box="1 mm", cells=100,
                      fillers=[breccia.Filler(coarse, fraction=0.45, diameter="80 um", gap="2 um"),
                               breccia.Filler(fine, fraction=0.15, diameter="25 um", gap="2 um")],
                      packing=breccia.Packing("lubachevsky-stillinger", walls=False, seed=7))

# %%
box = breccia.pack(breccia.Study(stage, breccia.Tests(times=(1e-3, 1.0))))["box"].microstructure
print(box)
area = np.pi / 4 * box.diameters**2 / box.side**2
for number, filler in enumerate(stage.fillers):
    of_filler = box.fillers == number
    print(f"{filler.material.name}: {of_filler.sum()} discs, {100 * area[of_filler].sum():.2f} %")
print(f"smallest gap {1e6 * box.gap:.2f} um, interface {box.interface_density / 1e3:.1f} mm per mm^2")
box

# %%
# How many pairs of coarse discs are so far apart, in the periodic box, over how many would be by chance.
centres = box.centres[box.fillers == 0]
apart = centres[:, None] - centres[None]
apart -= box.side * np.round(apart / box.side)
distances = np.hypot(*np.moveaxis(apart, -1, 0))[np.triu_indices(len(centres), 1)]
edges = np.linspace(80e-6, 240e-6, 9)
counts, _ = np.histogram(distances, edges)
by_chance = len(centres) * (len(centres) - 1) / 2 * np.pi * np.diff(edges**2) / box.side**2
for begin, end, ratio in zip(edges, edges[1:], counts / by_chance):
    print(f"{1e6 * begin:4.0f} to {1e6 * end:3.0f} um {ratio:5.2f} {'#' * round(10 * ratio)}")
assert box.gap >= 2e-6 * (1 - 1e-6)
