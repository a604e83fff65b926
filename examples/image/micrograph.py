#!/usr/bin/env python3
"""Draws a picture like a micrograph: bright crystals of several sizes at random places in a dark binder, blurred, with
noise and with more light in the middle. It is the same picture in every run.

  examples/image/micrograph.py OUT.png [LABELS.png]

LABELS.png has the crystals as they were drawn, without defects: 255, and 0 for the binder.
"""

import math
import random
import sys

import grey_png

SIDE = 400  # pixels
GAP = 3  # pixels that crystals keep apart at least
BINDER, CRYSTAL, NOISE = 70, 165, 14  # grey levels


def crystal(size, chance):
    """Edges of a convex polygon around the origin: the directions of their normals and their distances."""
    edges = chance.randint(5, 8)
    turn = chance.uniform(0.0, math.tau)
    normals = [turn + math.tau * (edge + chance.uniform(-0.25, 0.25)) / edges for edge in range(edges)]
    return [(math.cos(angle), math.sin(angle), 0.5 * size * chance.uniform(0.75, 1.0)) for angle in normals]


def pixels_of(edges, x, y, grown):
    """The pixels of a crystal that is grown by some pixels."""
    reach = int(1.4 * max(distance for _, _, distance in edges)) + grown
    for row in range(max(int(y) - reach, 0), min(int(y) + reach + 1, SIDE)):
        for column in range(max(int(x) - reach, 0), min(int(x) + reach + 1, SIDE)):
            if all((column - x) * nx + (row - y) * ny <= distance + grown for nx, ny, distance in edges):
                yield row, column


def draw_crystals(chance):
    """Crystals from large to small, each at the first free place of many tries."""
    taken = [[False] * SIDE for _ in range(SIDE)]
    for size in [90] * 8 + [60] * 25 + [40] * 60 + [26] * 150 + [16] * 300:
        edges = crystal(size, chance)
        for _ in range(60):
            x, y = chance.uniform(0, SIDE), chance.uniform(0, SIDE)
            if taken[int(y)][int(x)]:
                continue
            if any(taken[row][column] for row, column in pixels_of(edges, x, y, GAP)):
                continue
            for row, column in pixels_of(edges, x, y, 0):
                taken[row][column] = True
            break
    return taken


def blurred(rows):
    """Each pixel as the mean of itself and its neighbours, those nearby counting more."""
    at = lambda row, column: rows[min(max(row, 0), SIDE - 1)][min(max(column, 0), SIDE - 1)]
    weights = [(dr, dc, (2 - abs(dr)) * (2 - abs(dc)) / 16.0) for dr in (-1, 0, 1) for dc in (-1, 0, 1)]
    return [
        [sum(weight * at(row + dr, column + dc) for dr, dc, weight in weights) for column in range(SIDE)]
        for row in range(SIDE)
    ]


def main():
    chance = random.Random(9501)
    taken = draw_crystals(chance)
    grey = blurred([[CRYSTAL if is_crystal else BINDER for is_crystal in row] for row in taken])
    middle = 0.5 * SIDE
    for row in range(SIDE):
        for column in range(SIDE):
            light = 1.05 - 0.15 * math.hypot(row - middle, column - middle) / middle
            level = round(light * grey[row][column] + chance.gauss(0.0, NOISE))
            grey[row][column] = min(max(level, 0), 255)
    grey_png.write(sys.argv[1], grey)
    if len(sys.argv) > 2:
        grey_png.write(sys.argv[2], [[255 if is_crystal else 0 for is_crystal in row] for row in taken])
    share = sum(map(sum, taken)) / SIDE**2
    print(f"{sys.argv[1]}: {SIDE} x {SIDE} pixels, {100.0 * share:.1f} % crystals")


if __name__ == "__main__":
    main()
