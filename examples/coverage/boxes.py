"""Random boxes of many kinds, for `coverage.py`: `box_of(dimensions, kind, seed)` is a deck as text, with the
word CELLS in place of its cells."""

import random
from math import pi

KINDS = {
    2: ["discs", "sizes", "ellipses", "polygons", "grains", "coated", "soft", "walls"],
    3: ["spheres", "sizes", "contacts", "soft"],
}


def between(draw, low, high):
    """A number from `low` to `high`, its logarithm uniform."""
    return low * (high / low) ** draw.random()


def binder_of(draw):
    """A binder whose modulus falls by 10 to 1e5 over eight decades of time, evenly over its terms, and its bulk modulus."""
    glassy = 1e9
    rubbery = glassy / between(draw, 10.0, 1e5)
    terms = [f'{{ time = "{10.0 ** k} s", modulus = "{value:.6g} Pa" }}'
             for k, value in zip(range(-6, 2), falls(glassy, rubbery, 8))]
    bulk = glassy * between(draw, 1.0, 10.0)
    return glassy, f'bulk = "{bulk:.6g} Pa"\nshear = {{ equilibrium = "{rubbery:.6g} Pa", terms = [{", ".join(terms)}] }}'


def falls(first, last, count):
    """The parts of the fall from one modulus to another whose remainders are in geometric progression."""
    remainders = [first * (last / first) ** (k / count) for k in range(count + 1)]
    return [upper - lower for upper, lower in zip(remainders, remainders[1:])]


def filler_of(draw, glassy, is_soft):
    """Elastic moduli of a filler, stiffer than the glassy binder or, if it is soft, softer than the rubbery one."""
    shear = 1e3 * between(draw, 0.1, 10.0) if is_soft else glassy * between(draw, 2.0, 50.0)
    return f'shear = "{shear:.6g} Pa"\nbulk = "{shear * between(draw, 1.0, 4.0):.6g} Pa"'


def volume_of(dim, diameter):
    return pi / 4.0 * diameter**2 if dim == 2 else pi / 6.0 * diameter**3


def box_of(dim, kind, seed, wanted=None):
    """A box of this kind whose smallest particle has a diameter of 1 mm, of so many particles or, without this number, of
    a few: its side [mm], and its deck."""
    draw = random.Random(f"{dim} {kind} {seed}")
    glassy, binder = binder_of(draw)
    particles = draw.randint(12, 30) if dim == 2 else draw.randint(8, 16)
    particles = wanted or particles
    fraction = draw.uniform(0.2, 0.65) if dim == 2 else draw.uniform(0.15, 0.5)
    gap = between(draw, 0.005, 0.05)
    method, more, sizes = "lubachevsky-stillinger", "", 'diameter = "1 mm"'
    walls = "true" if kind == "walls" else "false"
    mean_volume = volume_of(dim, 1.0)
    if kind in ("sizes", "walls"):
        sizes = 'lognormal = [{ median = "1.5 mm", sigma = 0.4 }]'
        more = ', from = "1 mm", to = "3 mm"'
        mean_volume = volume_of(dim, 1.5)
    if kind == "apart":
        fraction, gap = draw.uniform(0.2, 0.5), between(draw, 0.08, 0.2)
    if kind == "contacts":
        fraction, gap = draw.uniform(0.46, 0.54), 0.01
    if kind in ("ellipses", "polygons"):
        method, fraction = "random-sequential", draw.uniform(0.2, 0.5)
        shape = f"aspect = {draw.uniform(1.2, 2.0):.3g}" if kind == "ellipses" else 'polygon = "../../data/made_up_grain.csv"'
        more = f", shape = {{ {shape} }}"
    if kind == "coated":
        fraction = draw.uniform(0.2, 0.45)
        more = f', coating = {{ material = "interphase", thickness = "{between(draw, 0.03, 0.1):.3g} mm" }}'
    if kind == "soft":
        fraction = draw.uniform(0.1, 0.45)
    if kind == "grains":
        method, walls, fraction = "laguerre", None, draw.uniform(0.85, 0.95)
    side = (particles * mean_volume / fraction) ** (1.0 / dim)
    gap_text = "" if kind == "grains" else f', gap = "{gap:.3g} mm"'
    packing = f'method = "{method}", seed = {seed}' + (f", walls = {walls}" if walls else "")
    boundaries = '["displacement", "traction"]' if kind == "walls" else '["periodic"]'
    loads = ["shear", "shear-xx-yy", "bulk"]
    return side, f"""title = "{kind} {seed}"
dimensions = {dim}
[materials.binder]
density = "1 g/cm^3"
{binder}
[materials.filler]
density = "2 g/cm^3"
{filler_of(draw, glassy, kind == "soft")}
[materials.interphase]
density = "1 g/cm^3"
shear = "{between(draw, 1e7, 1e10):.6g} Pa"
bulk = "2e10 Pa"
[[stages]]
name = "box"
matrix = "binder"
box = "{side:.6g} mm"
cells = CELLS
filler = {{ material = "filler", fraction = {fraction:.4g}, sizes = {{ {sizes} }}{more}{gap_text} }}
packing = {{ {packing} }}
[tests]
times = ["1 us", "100 s"]
loads = {str(loads).replace("'", '"')}
boundaries = {boundaries}
points_per_decade = 5
fields = "none"
"""
