#!/usr/bin/env python3
"""Writes data/synthetic_dma.csv: what a dynamic mechanical analyser would measure on the binder of PBX-9501."""
import math
import random
from pathlib import Path

data = Path(__file__).parents[2] / "data"
table = (data / "pbx9501_binder_prony.csv").read_text().splitlines()
rows = [line.split(",") for line in table if line and not line.startswith("#")][1:]
terms = [(float(time), float(modulus)) for time, modulus in rows]

noise = random.Random(1)
lines = [
    "# Synthetic: storage and loss modulus of the binder in pbx9501_binder_prony.csv, at 19 degC and, by",
    "# log10 a_T = -6.5 (T - 19 degC) / (120 K + T - 19 degC), at ten other temperatures, each value times 1 + a normal",
    "# deviate of 1 %. No measurement. Written by tests/reference/synthetic_dma.py.",
    "temperature_degC,frequency_Hz,storage_modulus_MPa,loss_modulus_MPa",
]
for difference in range(-60, 50, 10):
    shift = 10 ** (-6.5 * difference / (120 + difference))
    for k in range(16):
        frequency = 0.02 * 10 ** (0.2 * k)
        modulus = 0j
        for time, strength in terms:
            x = 1j * 2 * math.pi * frequency * shift * time
            modulus += strength * x / (1 + x)
        storage, loss = (1e-6 * part * (1 + noise.gauss(0, 0.01)) for part in (modulus.real, modulus.imag))
        lines.append(f"{19 + difference},{frequency:.4g},{storage:.5g},{loss:.5g}")
(data / "synthetic_dma.csv").write_text("\n".join(lines) + "\n")
