# %% [markdown]
# # Another binder, another temperature
#
# A study that was solved once answers for other binders in milliseconds. Results can be pickled, and still answer.

# %%
import pickle
import time

import numpy as np

import breccia

binder = breccia.Material("binder", density=1200.0, bulk="1 GPa",
                          shear=breccia.PronySeries([(1e-2, 50e6), (1.0, 10e6)], 1e6),
                          temperature_shift={"law": "wlf", "c1": 8.0, "c2": "100 K", "reference": "20 degC",
                                             "temperature": "20 degC"})
filler = breccia.Material("filler", density=2500.0, bulk="40 GPa", shear="25 GPa")
stage = breccia.Stage("box", matrix=binder, box="0.6 mm", cells=60, packing="lubachevsky-stillinger",
                      fillers=breccia.Filler(filler, fraction=0.4, diameter="0.1 mm", gap="15 um"))
result = breccia.solve(breccia.Study(stage, breccia.Tests(times=("1 ms", "10 s"), boundaries="displacement",
                                                         fields="none")))

# %%
kept = pickle.loads(pickle.dumps(result))
begin = time.perf_counter()
answers = {celsius: breccia.respond(kept, temperature=f"{celsius} degC") for celsius in (0, 20, 40)}
aged = breccia.respond(kept, binder=breccia.PronySeries([(1e-2, 45e6), (1.0, 10e6)], 2e6))
print(f"four answers in {1e3 * (time.perf_counter() - begin):.0f} ms")

# %%
times = np.array([1e-3, 1e-1, 10.0])
for celsius, answer in answers.items():
    print(f"{celsius:3d} degC", np.round(answer["box"].prony().at(times) / 1e6, 2), "MPa")
print("aged    ", np.round(aged["box"].prony().at(times) / 1e6, 2), "MPa")

# %%
# What the study does not cover is refused, with the times that it covers.
try:
    breccia.respond(result, breccia.PronySeries([(1.0, 200e6)], 1e6))
except breccia.InputError as error:
    print(error)
