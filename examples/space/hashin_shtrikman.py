#!/usr/bin/env python3
"""Twenty random composites of spheres in a relaxing matrix against the bounds of Hashin and Shtrikman, as a table.

    examples/space/hashin_shtrikman.py [COMPOSITES [CELLS]]      by default 20 and 24; some minutes

At a real Laplace variable s the moduli s M~(s) of a viscoelastic composite are those of an elastic one (correspondence
principle). In a periodic box the bounds hold for K and for the shear modulus averaged over all directions, whatever the
spheres' places: the average of the variational principle over the rotations of the load sees the fractions alone. The mean
over directions takes five shears; that of z and x is tested in a box with its axes changed, x for y for z."""

import sys
from math import pi
from random import Random

from runs import RESULTS, header, measured, read, row

PLACES = ("x_m", "y_m", "z_m")


def carson(terms, s):
    """s M~(s) of a Prony series."""
    return sum(m if tau == float("inf") else m * s * tau / (1.0 + s * tau) for tau, m in terms)


def random_series(unrelaxed, random):
    """A Prony series of one to four terms between 1 us and 1 s and an equilibrium modulus, by tau and modulus."""
    terms = [(10.0 ** random.uniform(-6, 0), unrelaxed * 10.0 ** random.uniform(-2, 0)) for _ in range(random.randint(1, 4))]
    return [(float("inf"), unrelaxed * 10.0 ** random.uniform(-3, -1)), *terms]


def as_toml(series):
    equilibrium, *terms = series
    listed = ", ".join(f'{{ time = "{tau:.9g} s", modulus = "{m:.9g} Pa" }}' for tau, m in terms)
    return f'{{ equilibrium = "{equilibrium[1]:.9g} Pa", terms = [{listed}] }}'


class Composite:
    def __init__(self, seed, cells):
        random = Random(seed)
        self.name, self.cells = f"hashin-{seed}-{cells}", cells
        unrelaxed, contrast = 10.0 ** random.uniform(5, 8), 10.0 ** random.uniform(-1, 3)
        self.shear = random_series(unrelaxed, random)
        bulk = unrelaxed * 10.0 ** random.uniform(0, 2)
        self.bulk = random_series(bulk, random) if random.random() < 0.5 else [(float("inf"), bulk)]
        self.sphere = 3.0 * contrast * unrelaxed, contrast * unrelaxed
        self.number, self.fraction = random.randint(2, 8), random.uniform(0.1, 0.4)

    def keys(self):
        diameter = (6.0 * self.fraction / (pi * self.number)) ** (1.0 / 3.0)
        bulk = as_toml(self.bulk) if len(self.bulk) > 1 else f'"{self.bulk[0][1]:.9g} Pa"'
        return {
            "stages.0.cells": self.cells,
            "stages.0.filler.fraction": f"{self.fraction:.9g}",
            "stages.0.filler.sizes.diameter": f'"{diameter:.9g} mm"',
            "stages.0.filler.gap": '"10 um"',
            "materials.matrix.shear": as_toml(self.shear),
            "materials.matrix.bulk": bulk,
            "materials.sphere.bulk": f'"{self.sphere[0]:.9g} Pa"',
            "materials.sphere.shear": f'"{self.sphere[1]:.9g} Pa"',
        }

    def turned(self):
        """The same with z in the place of x, x in that of y and y in that of z: its shear xx - yy is zz - xx of this."""
        file = RESULTS.resolve() / f"{self.name}-turned.csv"
        lines = ["x_m,y_m,z_m,diameter_m"]
        for sphere in read(RESULTS / self.name / "spheres" / "microstructure.csv"):
            x, y, z = (sphere[axis] for axis in PLACES)
            lines.append(f"{z},{x},{y},{sphere['diameter_m']}")
        file.write_text("\n".join(lines) + "\n")
        keys = self.keys()
        for name in ("fraction", "sizes.diameter", "gap"):
            del keys[f"stages.0.filler.{name}"]
        return {
            **keys,
            "stages.0.filler": '{ material = "sphere" }',
            "stages.0.packing": f'{{ method = "explicit", particles = "{file}", walls = false }}',
            "tests.loads": '["shear-xx-yy"]',
        }


def bounds(fractions, bulks, shears):
    """The bounds of Hashin and Shtrikman for K and G of two phases: lower and upper of each."""
    found = []
    for g in (min(shears), max(shears)):
        k = min(bulks) if g == min(shears) else max(bulks)
        extra = g / 6.0 * (9.0 * k + 8.0 * g) / (k + 2.0 * g)
        found.append((1.0 / sum(f / (b + 4.0 / 3.0 * g) for f, b in zip(fractions, bulks)) - 4.0 / 3.0 * g,
                      1.0 / sum(f / (s + extra) for f, s in zip(fractions, shears)) - extra))
    return list(zip(*found))


def over(value, of_modulus):
    """A modulus over its lower and over its upper bound."""
    return ", ".join(f"{value / bound:.4f}" for bound in of_modulus)


count, cells = (int(number) for number in (sys.argv[1:] + ["20", "24"][len(sys.argv) - 1:]))
header("seed", "spheres", "fraction", "s [1/s]", "G sphere / matrix", "K over its bounds", "G over its bounds")
for seed in range(1, count + 1):
    composite = Composite(seed, cells)
    run = measured(composite.name, "hashin-shtrikman.toml", composite.keys())
    turned = measured(f"{composite.name}-turned", "hashin-shtrikman.toml", composite.turned())
    for s in (1e-1, 1e3, 1e7):
        def modulus(load, of=run):
            return carson(of.terms["periodic", load], s)

        shear = (modulus("shear") + modulus("shear-yz") + modulus("shear-zx") + 2.0 / 3.0 * (
            modulus("shear-xx-yy") + modulus("shear-yy-zz") + modulus("shear-xx-yy", turned))) / 5.0
        matrix = carson(composite.bulk, s), carson(composite.shear, s)
        fractions = 1.0 - composite.fraction, composite.fraction
        of_bulk, of_shear = bounds(fractions, *zip(matrix, composite.sphere))
        row(seed, composite.number, f"{composite.fraction:.3f}", f"{s:g}", f"{composite.sphere[1] / matrix[1]:.3g}",
            over(modulus("bulk"), of_bulk), over(shear, of_shear))
