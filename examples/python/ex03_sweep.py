# %% [markdown]
# # A sweep on all cores
#
# How the modulus grows with the fraction of filler, and how much a packing differs from the next.
# One process solves one study at a time, so a sweep takes several processes.

# %%
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np

import breccia

binder = breccia.Material("binder", density=1200.0, bulk="1 GPa", shear=breccia.PronySeries([(1.0, 9e6)], 1e6))
filler = breccia.Material("filler", density=2500.0, bulk="40 GPa", shear="25 GPa")


# %%
def study(fraction, seed):
    """One packing."""
    discs = breccia.Filler(filler, fraction=fraction, diameter="0.1 mm", gap="23 um")
    stage = breccia.Stage("box", matrix=binder, box="0.6 mm", cells=40, fillers=discs,
                          packing=breccia.Packing("lubachevsky-stillinger", seed=seed))
    return breccia.Study(stage, breccia.Tests(times=(0.1, 10.0), points_per_decade=5, fields="none"))


def bounds(result, time=10.0):
    """Upper and lower bound of G(t) [Pa]."""
    return [result["box"].prony(boundary=boundary).at(time) for boundary in ("displacement", "traction")]


# %%
# Studies and results are pickled on their way to a process and back. Processes are spawned, not forked.
if __name__ == "__main__":
    fractions, seeds = (0.1, 0.25, 0.4), (1, 2, 3)
    studies = [study(fraction, seed) for fraction in fractions for seed in seeds]
    with ProcessPoolExecutor(max_workers=2, mp_context=get_context("spawn")) as processes:
        results = list(processes.map(breccia.solve, studies))
    moduli = np.reshape([bounds(result) for result in results], (len(fractions), len(seeds), 2)) / 1e6
    for fraction, packings in zip(fractions, moduli):
        (upper, lower), (spread, _) = packings.mean(axis=0), packings.std(axis=0, ddof=1)
        print(f"{100 * fraction:3.0f} %: G(10 s) between {lower:.2f} and {upper:.2f} MPa; "
              f"packings differ by {spread:.2f}")
        assert lower < upper
