# %% [markdown]
# # From a measured composite to its interphase
#
# Nobody has measured the interphase between the beads of a filled rubber and the rubber itself. The composite was
# measured, and tells the interphase. The data are made up, so that the answer is known: 300 MPa, and relaxation times of
# the rubber that are twice as long as the deck says.

# %%
import breccia

study = breccia.read_study("../coated-particles.toml", {"stages.0.cells": 100, "tests.fields": "none"})
result = breccia.solve(study)

# %% [markdown]
# ## The interphase and the times of the rubber
#
# The run has sampled all moduli of the interphase from 10 MPa to 1 GPa, so that this takes a second. Half of the cells of
# the deck are used here; the error that this makes is stated.

# %%
found = breccia.calibrate(result, "../../data/made_up_coated_particles.csv", ["interphase.shear", "rubber.times"],
                          model_error=0.05)
found

# %%
for estimate in found.estimates.values():
    low, high = estimate.interval
    print(f"{estimate.name}: {estimate.value:.3g} {estimate.unit}, 95 % from {low:.3g} to {high:.3g}")

# %% [markdown]
# ## What the composite does with the materials that were found

# %%
answer = breccia.respond(result, materials=found.materials)
time, modulus = answer["composite"].curve(load="shear")
for t, g in list(zip(time, modulus))[::20]:
    print(f"{t:8.1e} s: {g / 1e6:6.1f} MPa")
