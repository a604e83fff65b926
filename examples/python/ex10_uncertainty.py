# %% [markdown]
# # What inputs that are not certain make of a result
#
# Half a composite of discs in a binder: the fraction is known to one per cent, the modulus of the discs to a tenth, and
# the relaxation times of the binder within a factor two. Which of them matters, and when?

# %%
import breccia

binder = breccia.Material("binder", density="1 g/cm^3", bulk="3 GPa",
                          shear=breccia.PronySeries([(1e-4, 500e6), (1e-3, 300e6), (1e-2, 90e6)], 1e6),
                          factors={"times": {"value": 1, "factor": 2}})
disc = breccia.Material("disc", density="2.5 g/cm^3", bulk="4 GPa", shear={"value": 3e9, "sd": 0.3e9})
stage = breccia.Stage("composite", matrix=binder, box="20 mm", cells=48,
                      fillers=breccia.Filler(disc, fraction={"value": 0.5, "sd": 0.01}, diameter="2 mm"),
                      packing=breccia.Packing("lubachevsky-stillinger", seed=1))
study = breccia.Study(stage, breccia.Tests(times=("10 us", "1 s"), fields="none", mixing="series"))

# %% [markdown]
# ## Bands and shares
#
# The fraction changes the box, so that ten boxes are solved; the moduli do not.

# %%
found = breccia.assess(study)
found

# %%
curve = found["G"]
for i in range(0, len(curve.at), 20):
    low, high = (ends[i] / 1e6 for ends in curve.inputs)
    shares = ", ".join(f"{name} {100 * share[i]:.0f} %" for name, share in curve.alone.items())
    print(f"{curve.at[i]:8.1e} s: {curve.median[i] / 1e6:6.1f} MPa, 95 % from {low:6.1f} to {high:6.1f}; {shares}")
