# %% [markdown]
# # What a dynamic mechanical analysis would show
#
# Measured sweeps of the binder become a master curve, the curve a study, and the study E', E'' and tan delta of the
# composite at 1 Hz against temperature.

# %%
import numpy as np

import breccia


# %%
table = breccia.read_measured("../../data/synthetic_dma.csv", kind="shear")
kelvins = np.unique(table["temperature"])
sweeps = [(kelvin, *(table[key][table["temperature"] == kelvin]
                     for key in ("angular_frequency", "storage_modulus", "loss_modulus"))) for kelvin in kelvins]
curve = breccia.master_curve(sweeps, reference_temperature=292.15)
law = curve.williams_landel_ferry()

# %%
binder = breccia.Material("binder", density="1.48 g/cm^3", bulk="3.6 GPa", shear=curve.series,
                          temperature_shift={"law": "wlf", "c1": law.c1, "c2": f"{law.c2} K", "reference": "292.15 K",
                                             "temperature": "292.15 K"})
crystal = breccia.Material("crystal", density="1.85 g/cm^3", bulk="13.4 GPa", shear="5.84 GPa")
stage = breccia.Stage("composite", matrix=binder, box="60 um", cells=60,
                      fillers=breccia.Filler(crystal, fraction="50 %", diameter="8 um", gap="1.6 um"),
                      packing=breccia.Packing("lubachevsky-stillinger", walls=False))
tests = breccia.Tests(times=("1 us", "100 s"), loads=["shear", "bulk"], boundaries="periodic", fields="none")
result = breccia.solve(breccia.Study(stage, tests, title="Composite of the measured binder"))
result


# %%
def young(answer, omega):
    """Complex Young's modulus [Pa] from the shear test and the bulk test, which gives K + G / 3 in plane strain."""
    shear = answer["composite"].prony("shear").complex_modulus(omega)
    bulk = answer["composite"].prony("bulk").complex_modulus(omega) - shear / 3
    return 9 * bulk * shear / (3 * bulk + shear)


omega = 2 * np.pi * 1.0  # 1 Hz
print(f"{'degC':>5} {'E [MPa]':>10} {'E loss':>10} {'tan delta':>10}   binder")
for celsius in range(-40, 61, 10):
    answer = breccia.respond(result, temperature=f"{celsius} degC")
    modulus = young(answer, omega)
    shifted = curve.series.shifted(law.shift_factor(celsius + 273.15)).complex_modulus(omega)
    print(f"{celsius:5d} {modulus.real / 1e6:10.2f} {modulus.imag / 1e6:10.3f} {modulus.imag / modulus.real:10.3f}"
          f"   {shifted.imag / shifted.real:.3f}")
