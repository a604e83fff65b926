#!/usr/bin/env python3
"""Gives the grains of a run random shares of the films, evenly from 1 - WIDTH to 1 + WIDTH: writes the sites that
packing.sites reads to the standard output.

    film_shares.py GRAINS.CSV WIDTH SEED > sites.csv
"""
import random
import sys

file, width, seed = sys.argv[1], float(sys.argv[2]), int(sys.argv[3])
shares = random.Random(seed)
rows = (line.strip() for line in open(file) if not line.startswith("#"))
print(next(rows) + ",film_share")
for row in rows:
    print(f"{row},{shares.uniform(1 - width, 1 + width):.6g}")
