#!/usr/bin/env python3
"""Writes the discs of the regular cases: one of 20 mm in the middle of a box of 29 mm, and around it those of 2 mm in
the middle of m x m equal squares, without those nearer to it than 0.15 mm (three cells at 600 per side)."""
from math import hypot, pi

side, large, small, gap = 29.0, 20.0, 2.0, 0.15  # [mm]

for name, m in (("regular-57", 10), ("regular-74", 13)):
    pitch = side / m
    middles = [((i + 0.5) * pitch, (j + 0.5) * pitch) for j in range(m) for i in range(m)]
    discs = [(side / 2, side / 2, large)]
    reach = (large + small) / 2 + gap
    discs += [(x, y, small) for x, y in middles if hypot(x - side / 2, y - side / 2) >= reach]
    total = sum(pi * d**2 / 4 for _, _, d in discs) / side**2
    between = (len(discs) - 1) * pi * small**2 / 4 / (side**2 - pi * large**2 / 4)
    for suffix, rows in (("", discs), ("-large", discs[:1])):
        with open(f"{name}{suffix}.csv", "w") as file:
            file.write(f"# Written by lattice.py: {len(rows)} of the discs of {name}, which fill {total:.4f} of the box;\n")
            file.write(f"# the small ones fill {between:.4f} of the space beside the large one.\n")
            file.write("x_m,y_m,diameter_m\n")
            for x, y, d in rows:
                file.write(f"{x * 1e-3:.9g},{y * 1e-3:.9g},{d * 1e-3:.9g}\n")
