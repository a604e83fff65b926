# %% [markdown]
# # A lesson: what a filler makes of a polymer
#
# For an hour with students. Each number is computed here, in half a minute; the questions at the end need
# nothing but other values in these cells. All boxes are plane: discs stand for cylinders, and spheres stiffen more.

# %%
import matplotlib.pyplot as plt
import numpy as np

import breccia

# %% [markdown]
# ## 1. The binder
#
# A polymer that is stiff in a microsecond and soft in a second: its relaxation modulus is a sum of exponentials, a
# Prony series.

# %%
binder = breccia.Material("binder", density="1.1 g/cm^3", bulk="3 GPa",
                          shear=breccia.PronySeries([(1e-5, 6e8), (1e-4, 2.5e8), (1e-3, 8e7), (1e-2, 2e7), (1e-1, 5e6)],
                                                    equilibrium=1e6))
glass = breccia.Material("glass", density="2.5 g/cm^3", bulk="40 GPa", shear="30 GPa")
binder.shear

# %% [markdown]
# ## 2. A box of the composite
#
# Discs of two sizes, placed at random in a box whose opposite sides belong together.

# %%
def box(fraction, **more):
    """A box with this share of glass."""
    coarse = breccia.Filler(glass, fraction=0.7 * fraction, diameter="200 um")
    fine = breccia.Filler(glass, fraction=0.3 * fraction, diameter="80 um")
    return breccia.Stage("box", matrix=binder, particles=40, cells=[40, 80], fillers=[coarse, fine],
                         packing=breccia.Packing("random", seed=3), **more)


tests = breccia.Tests(times=("1 us", "1 s"), loads=["isotropic", "bulk"], points_per_decade=5)
result = breccia.solve(breccia.Study(box(0.4), tests))
result["box"].microstructure

# %% [markdown]
# ## 3. Its relaxation modulus
#
# The composite relaxes at the times of its binder, at a higher modulus. The line "this box" says how far to trust it.

# %%
axes = result.plot(label="40 % of glass")
axes.set_title("Relaxation modulus")
print(result["box"].accuracy)

# %% [markdown]
# ## 4. How much stiffer?
#
# Einstein's argument counts each particle alone: in the plane $G/G_b = 1 + 2 \phi$ for rigid discs in an
# incompressible binder. Hashin's lower bound is $(1 + \phi) / (1 - \phi)$. Neighbours make the rest.

# %%
fractions = np.array([0.1, 0.2, 0.3, 0.4, 0.5])
stiffening = []
for fraction in fractions:
    stage = breccia.solve(breccia.Study(box(fraction), tests))["box"]
    stiffening.append(stage.prony().at("1 s") / binder.shear.at("1 s"))

figure, axes = plt.subplots()
fine = np.linspace(0.0, 0.5, 51)
axes.plot(100 * fine, 1 + 2 * fine, ":", label="each disc alone, 1 + 2 φ")
axes.plot(100 * fine, (1 + fine) / (1 - fine), "--", label="Hashin's lower bound")
axes.plot(100 * fractions, stiffening, "o-", label="computed")
axes.set(xlabel="glass [%]", ylabel="G / G of the binder at 1 s", title="Stiffening")
axes.legend()

# %% [markdown]
# ## 5. In frequency
#
# A forced vibration asks for the complex modulus. As long as the glass is far stiffer than the binder, the composite loses the same
# share of its energy in a cycle as the binder does: tan delta hardly changes where the modulus is several times higher.

# %%
omega = np.logspace(0, 6, 200)
figure, axes = plt.subplots()
for name, series in (("binder", binder.shear), ("composite", result["box"].prony())):
    modulus = series.complex_modulus(omega)
    axes.semilogx(omega / (2 * np.pi), modulus.imag / modulus.real, label=name)
axes.set(xlabel="frequency [Hz]", ylabel="tan δ", title="Loss tangent")
axes.legend()

# %% [markdown]
# ## 6. Young's modulus and Poisson's ratio
#
# Soft in shear but not in compression: Poisson's ratio rises to one half while the binder relaxes.

# %%
moduli = result["box"].engineering()
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4))
left.loglog(moduli.time, moduli.young)
left.set(xlabel="time [s]", ylabel="E [Pa]", title="Young's modulus")
right.semilogx(moduli.time, moduli.poisson)
right.set(xlabel="time [s]", ylabel="ν [-]", title="Poisson's ratio")
figure.tight_layout()

# %% [markdown]
# ## 7. Where the stress is
#
# The shear stress in the box at the end of the test, over its mean: chains of discs carry it.

# %%
fields = result["box"].fields()[-1]
stress = fields["stress"][..., -1]
figure, axes = plt.subplots()
picture = axes.imshow(stress / stress.mean(), origin="lower", cmap="RdBu_r", vmin=-4, vmax=6)
axes.set(title="Shear stress over its mean", xticks=[], yticks=[])
figure.colorbar(picture)

# %% [markdown]
# ## 8. A composite with a direction
#
# Ellipses that all lie along x: the stiffness is no longer isotropic, and `loads="stiffness"` finds all of it.

# %%
fibres = breccia.Filler(glass, fraction=0.3, diameter="100 um", shape={"aspect": 4.0, "angle": "0 deg"})
oriented = breccia.Stage("fibres", matrix=binder, particles=25, cells=80, fillers=fibres, packing=breccia.Packing("random", seed=5))
stage = breccia.solve(breccia.Study(oriented, breccia.Tests(times=("1 us", "1 s"), loads="stiffness",
                                                            points_per_decade=5)))["fibres"]
[found] = stage.stiffness
figure, axes = plt.subplots()
for name, i, j in (("C11", 0, 0), ("C22", 1, 1), ("C12", 0, 1), ("C66", 2, 2)):
    axes.loglog(found["time"], found["stiffness"][:, i, j], label=name)
axes.set(xlabel="time [s]", ylabel="C [Pa]", title="Stiffness of oriented fibres")
axes.legend()
print(f"universal index of anisotropy {found['anisotropy'][0]:.2g} at 1 us, {found['anisotropy'][-1]:.2g} at 1 s")
stage.microstructure

# %% [markdown]
# ## Questions
#
# 1. At which fraction is the composite twice as stiff as the law of single discs says? Why there?
# 2. Halve the modulus of the glass, then make it a thousandth. When does the filler matter, and when only its volume?
# 3. Another seed packs the discs anew. How far apart are five seeds, and does the line on trust hold?
# 4. Turn the fibres by 45°. Which constants change, and which combination of them does not?
# 5. Repeat section 4 in space (`dimensions=3`, spheres, two cells in place of four for each radius). Einstein's number
#    is then 2.5.

# %%
assert stiffening == sorted(stiffening) and stiffening[0] > 1.2
assert found["stiffness"][0, 0, 0] > found["stiffness"][0, 1, 1]
