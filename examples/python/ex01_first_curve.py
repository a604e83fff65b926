# %% [markdown]
# # A first curve
#
# Sixty-four discs in a soft binder, the deck of the README: the relaxation modulus of a periodic box.

# %%
import breccia

# %%
# A value of the deck is replaced by the path of its key.
study = breccia.read_study("../starter.toml", {"stages.0.cells": [40, 80]})
result = breccia.solve(study)
result

# %%
stage = result.stages[-1]
time, modulus = stage.curve()  # NumPy arrays, s and Pa: the mean of both shears of the box
time, xy = stage.curve(load="shear")
time, xx_yy = stage.curve(load="shear-xx-yy")
print(f"{'t [s]':>8} {'G [kPa]':>8} {'xy [kPa]':>9} {'xx-yy [kPa]':>12}")
for number in range(0, len(time), 10):
    print(f"{time[number]:8.4f} {modulus[number] / 1e3:8.4g} {xy[number] / 1e3:9.4g} {xx_yy[number] / 1e3:12.4g}")

# %%
# The same as Prony series, for any time and any frequency.
series = stage.prony()
storage, loss = series.complex_modulus(100.0).real, series.complex_modulus(100.0).imag
print(f"{len(series.terms)} terms; at 100 rad/s G' = {storage / 1e3:.4g} kPa, G'' = {loss / 1e3:.4g} kPa")

assert abs(modulus - (xy + xx_yy) / 2).max() < 1e-9 * modulus.max()
