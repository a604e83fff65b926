# %% [markdown]
# # A first curve
#
# Four discs in a soft binder: the deck of the README, its upper and lower bound of the relaxation modulus.

# %%
import breccia

# %%
# A value of the deck is replaced by the path of its key.
study = breccia.read_study("../starter.toml", {"stages.0.cells": 60})
result = breccia.solve(study)
result

# %%
stage = result.stages[-1]
time, upper = stage.curve(boundary="displacement")  # NumPy arrays, s and Pa
time, lower = stage.curve(boundary="traction")
print(f"{'t [s]':>8} {'upper [kPa]':>12} {'lower [kPa]':>12}")
for number in range(0, len(time), 10):
    print(f"{time[number]:8.4f} {upper[number] / 1e3:12.4g} {lower[number] / 1e3:12.4g}")

# %%
# The same as Prony series, for any time and any frequency.
series = stage.prony(boundary="displacement")
storage, loss = series.complex_modulus(100.0).real, series.complex_modulus(100.0).imag
print(f"{len(series.terms)} terms; at 100 rad/s G' = {storage / 1e3:.4g} kPa, G'' = {loss / 1e3:.4g} kPa")

assert (upper >= lower).all()
