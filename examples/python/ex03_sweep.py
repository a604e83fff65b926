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


def modulus(result, time=10.0):
    """G(t) [Pa], the mean of both shears of a periodic box."""
    return result["box"].prony().at(time)


# %%
# Studies and results are pickled on their way to a process and back. Processes are spawned, not forked.
if __name__ == "__main__":
    fractions, seeds = (0.1, 0.25, 0.4), (1, 2, 3)
    studies = [study(fraction, seed) for fraction in fractions for seed in seeds]
    with ProcessPoolExecutor(max_workers=2, mp_context=get_context("spawn")) as processes:
        results = list(processes.map(breccia.solve, studies))
    moduli = np.reshape([modulus(result) for result in results], (len(fractions), len(seeds))) / 1e6
    for fraction, packings in zip(fractions, moduli):
        print(f"{100 * fraction:3.0f} %: G(10 s) = {packings.mean():.2f} MPa; "
              f"packings differ by {packings.std(ddof=1):.2f}")
    assert (np.diff(moduli.mean(axis=1)) > 0).all()
