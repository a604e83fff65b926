# %% [markdown]
# # From a dynamic mechanical analysis to a finite element program
#
# Measured sweeps of the binder become a master curve, the curve a binder, and the binder a composite, with its E', E''
# and tan delta at 1 Hz against temperature, and with a card for Abaqus.

# %%
import breccia

# %% [markdown]
# ## The binder as it was measured
#
# Sweeps at eleven temperatures, in shear, as the instrument wrote them. They are shifted to 19 degC.

# %%
sweeps = breccia.read_sweeps("../../data/synthetic_dma.csv", kind="shear")
curve = breccia.master_curve(sweeps, reference_temperature="19 degC")
curve

# %%
law = curve.williams_landel_ferry()
print(f"c1 = {law.c1:.2f} +- {law.c1_error:.2f}, c2 = {law.c2:.1f} +- {law.c2_error:.1f} K")

# %% [markdown]
# ## The composite
#
# Half of it are crystals of 8 um. A shear and a bulk test together give Young's modulus.

# %%
binder = breccia.Material("binder", density="1.48 g/cm^3", bulk="3.6 GPa", shear=curve.series, temperature_shift=law)
crystal = breccia.Material("crystal", density="1.85 g/cm^3", bulk="13.4 GPa", shear="5.84 GPa")
composite = breccia.Stage("composite", matrix=binder, box="60 um", cells=60,
                          fillers=breccia.Filler(crystal, fraction="50 %", diameter="8 um", gap="1.6 um"),
                          packing=breccia.Packing("lubachevsky-stillinger", walls=False))
tests = breccia.Tests(times=("1 us", "100 s"), loads=["shear", "bulk"], boundaries="periodic", fields="none")
result = breccia.solve(breccia.Study(composite, tests, title="Composite of the measured binder"))
result

# %% [markdown]
# ## What an analysis of the composite would show

# %%
dma = breccia.isochrone(result, "1 Hz", temperatures=("-30 degC", "60 degC"), step="2 K")
dma

# %%
for kelvin, young in list(zip(dma.temperature, dma.young))[::10]:
    print(f"{kelvin - 273.15:5.0f} degC: E' = {young.real / 1e6:7.1f} MPa, E'' = {young.imag / 1e6:6.1f} MPa, "
          f"tan delta = {young.imag / young.real:.3f}")

# %% [markdown]
# ## A card for Abaqus
#
# Moduli in MPa and the density in t/mm^3, for the times of the study, with the shift law of the binder.
# In plane strain K(t) is a difference of two tests, which may rise a little; here the bulk modulus is taken as elastic.

# %%
card = breccia.export(result, "abaqus", tolerance=0.02, bulk="6.4 GPa", units="mm-t-s")
print(card)
