#!/usr/bin/env python3
"""Creep compliance of the binder in data/pbx9501_binder_prony.csv by partial fractions of 1 / (s G~(s)), with 60 digits.

Prints the numbers that tests/viscoelasticity/interconversion_test.cpp expects. Needs python3-mpmath.
"""
from pathlib import Path

import mpmath as mp

mp.mp.dps = 60
table = Path(__file__).parents[2] / "data" / "pbx9501_binder_prony.csv"
rows = [line.split(",") for line in table.read_text().splitlines() if line and not line.startswith("#")][1:]
terms = sorted((1 / mp.mpf(time), mp.mpf(modulus)) for time, modulus in rows)


def zero_between(low, high):
    """Zero of sum_i G_i r / (p_i - r), which rises between two neighbouring rates p."""
    margin = (high - low) * mp.mpf(10) ** -40
    low, high = low + margin, high - margin
    for _ in range(260):
        middle = (low + high) / 2
        if sum(modulus * middle / (rate - middle) for rate, modulus in terms) > 0:
            high = middle
        else:
            low = middle
    return (low + high) / 2


rates = [zero_between(terms[i][0], terms[i + 1][0]) for i in range(len(terms) - 1)]
strengths = [1 / (r * sum(modulus * rate / (rate - r) ** 2 for rate, modulus in terms)) for r in rates]
instantaneous = 1 / sum(modulus for _, modulus in terms)
fluidity = 1 / sum(modulus / rate for rate, modulus in terms)

for time in ("1e-12", "1e-9", "1e-6", "1e-3", "1", "1e3", "1e6", "1e8"):
    t = mp.mpf(time)
    creep = sum(j * (1 - mp.exp(-r * t)) for j, r in zip(strengths, rates))
    print(time, mp.nstr(instantaneous + fluidity * t + creep, 17))
