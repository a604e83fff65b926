# %% [markdown]
# # A binder from measured sweeps
#
# Storage and loss moduli at eleven temperatures become one master curve, a Prony series and a shift law.
# The data are made up (with a scatter of 1 %), so the truth is known: c1 = 6.5, c2 = 120 K.

# %%
import numpy as np

import breccia


# %%
# Columns are found by their names, and come in SI units.
table = breccia.read_measured("../../data/synthetic_dma.csv", kind="shear")
sweeps = []
for temperature in np.unique(table["temperature"]):
    rows = table["temperature"] == temperature
    sweeps.append((temperature, *(table[key][rows] for key in ("angular_frequency", "storage_modulus", "loss_modulus"))))

# %%
curve = breccia.master_curve(sweeps, reference_temperature=292.15)
law = curve.williams_landel_ferry()
print(curve)
print(curve.fit)
print(f"c1 = {law.c1:.2f} +- {law.c1_error:.2f}, c2 = {law.c2:.1f} +- {law.c2_error:.1f} K")
curve.series

# %%
# The binder at another temperature, for a study.
warm = curve.series.shifted(law.shift_factor(313.15))
binder = breccia.Material("binder", density="1.48 g/cm^3", bulk="3.6 GPa", shear=warm)
print("at 40 degC G(1 s) is", f"{warm.at(1.0) / curve.series.at(1.0):.2f}", "of that at 19 degC")

assert abs(law.c1 - 6.5) < 3 * law.c1_error
