"""Checks the solver disc_moduli and prints the figures of README.md.

    check.py PROGRAM [CHECK...]: the functions in CHECKS of these names, or all of them
"""
import csv
import math
import os
import statistics
import sys
import tempfile

from disc_moduli import moduli, run

HERE = os.path.dirname(os.path.abspath(__file__))
FINE = (4, 0.5, 2)
SHEARS = ("xx-yy", "xy")
WALLED = ("displacement", "traction")
WALLED_PACKINGS = ("walls_one_g100", "walls_one_g030", "walls_four_g100", "walls_equal_55_040_g050",
                   "walls_equal_60_040_g100", "walls_ratio3_62_040_g030")


def table(path):
    with open(path) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def with_discs(discs, solve):
    """What solve(path) says of a packing of (x, y, diameter)."""
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
        for disc in discs:
            print(*map(repr, disc), sep=",", file=file)
        file.flush()
        return solve(file.name)


def discs_of(path):
    with open(path) as file:
        return [tuple(map(float, line.split(","))) for line in file if line[0].isdigit()]


def error(value, reference):
    return abs(value / reference - 1)


def discs_of_the_binder(program):
    """A packing of one material has its moduli: 1, 1 and K + 1/3."""
    cases = [("periodic", "packings/equal_60_040_g050")]
    cases += [(boundary, f"packings_walls/{name}") for name in ("walls_four_g100", "walls_ratio3_62_040_g030")
              for boundary in WALLED]
    for boundary, packing in cases:
        for bulk in (1e3, 1e6):
            found = run(program, boundary, f"{HERE}/{packing}.csv", (3, 0.5, 2), [bulk], (bulk, 1.0))
            exact = {"xx-yy": 1, "xy": 1, "bulk": bulk + 1 / 3}
            worst = max(error(found[bulk, load][0], exact[load]) for load in exact)
            print(f"discs of the binder, {packing}, {boundary}, K/g {bulk:g}: worst error {worst:.1e}")


def conforming_triangles(program):
    """One disc in the box, by elastic_square_array.csv."""
    for boundary in ("periodic", "displacement"):
        compare_with_triangles(
            program, boundary,
            [row for row in table(f"{HERE}/../elastic_square_array.csv") if row["boundary"] == boundary])


def compare_with_triangles(program, boundary, rows):
    errors = []
    for fraction, contrast in sorted({(float(row["fraction"]), float(row["contrast"])) for row in rows}):
        disc = (0.5, 0.5, 2 * math.sqrt(fraction / math.pi))
        found = with_discs([disc], lambda path: moduli(program, boundary, path, (3, 0.3, 3), (3, 3600), contrast))
        for row in rows:
            if (float(row["fraction"]), float(row["contrast"])) == (fraction, contrast):
                modulus = found[float(row["bulk_ratio"]), row["load"]][0]
                errors.append((error(modulus, float(row["modulus"])), row["relative_error"]))
    median = statistics.median(difference for difference, _ in errors)
    worst, stated = max(errors)
    print(f"{len(errors)} discs by triangles, {boundary}: difference {median:.1e} in the median, {worst:.1e} at worst, "
          f"where the table states an error of {stated}")


def lubrication(program):
    """Shear moduli of a square array over the leading terms for narrow gaps of radius a, gap h."""
    for gap in (0.03, 0.01, 0.003, 0.001, 0.0003, 0.0001):
        diameter = 1 / (1 + gap)
        found = with_discs([(0.5, 0.5, diameter)], lambda path: moduli(program, "periodic", path, FINE, [1e9], None))
        narrow = diameter / 2 / (1 - diameter)  # a / h
        leading = {"xx-yy": 3 * math.pi / 4 * narrow ** 1.5, "xy": math.pi / 2 * narrow ** 0.5}
        print(f"gap {100 * gap:g} % over leading terms:",
              ", ".join(f"{load} {found[1e9, load][0] / leading[load]:.4f}" for load in SHEARS))


def turned_arrays(program):
    """Turned by t, an array has cos(2t)^2 of one shear modulus and sin(2t)^2 of the other."""
    worst = 0.0
    for tag in ("g300", "g100", "g030", "g010"):
        straight, by_27, by_45 = (
            moduli(program, "periodic", f"{HERE}/packings/{name}_{tag}.csv", FINE, [1e3, 1e6], None)
            for name in ("square", "square27", "square45"))
        for bulk in (1e3, 1e6):
            diagonal, shear = (straight[bulk, load][0] for load in SHEARS)
            worst = max(worst, error(by_27[bulk, "xx-yy"][0], 0.36 * diagonal + 0.64 * shear),
                        error(by_27[bulk, "xy"][0], 0.64 * diagonal + 0.36 * shear),
                        error(by_45[bulk, "xx-yy"][0], shear), error(by_45[bulk, "xy"][0], diagonal))
    print(f"turned arrays: worst error {worst:.1e}")


def moved_packing(program):
    """A packing that is shifted and turned by 90 degrees."""
    path = f"{HERE}/packings/ratio3_67_040_g020.csv"
    found = moduli(program, "periodic", path, (3, 0.6, 2), [1e6], None)
    moved = with_discs([((0.37 - y) % 1, (x + 0.21) % 1, diameter) for x, y, diameter in discs_of(path)],
                       lambda name: moduli(program, "periodic", name, (3, 0.6, 2), [1e6], None))
    print(f"shifted and turned packing: worst error {max(error(moved[case][0], found[case][0]) for case in found):.1e}")


def meshes(program):
    """The quartic meshes of moduli.csv against finer ones."""
    for name in ("square_g100", "equal_50_040_g100", "equal_75_040_g050", "ratio3_67_040_g020", "ratio10_60_254_g100"):
        path = f"{HERE}/packings/{name}.csv"
        found, finer = (moduli(program, "periodic", path, mesh, [1e3, 1e6], None)
                        for mesh in (FINE, (4, 0.35, 4)))
        print(f"{name}: worst change {max(error(found[case][0], finer[case][0]) for case in finer):.1e}")


def lubrication_of_walls(program):
    """One disc of radius a, gaps h to the walls, given displacements, over the leading terms for narrow gaps.

    xx-yy: four walls move by 1/4 to or from the disc, each with the squeeze force 3 sqrt(2) pi g V (a/h)^(3/2).
    xy: the walls widen two corners by 1/8 and narrow the others, so 1/16 flows through each of the four gaps.
    """
    for gap in (0.03, 0.01, 0.003, 0.001, 0.0003, 0.0001):
        diameter = 1 / (1 + 2 * gap)
        found = with_discs([(0.5, 0.5, diameter)],
                           lambda path: moduli(program, "displacement", path, FINE, [1e13], None))
        a, h = diameter / 2, gap * diameter
        leading = {"xx-yy": 3 * math.sqrt(2) * math.pi / 4 * (a / h) ** 1.5,
                   "xy": 9 * math.pi / 128 * math.sqrt(2 * a) * h ** -2.5}
        print(f"walls, gap {100 * gap:g} % over leading terms:",
              ", ".join(f"{load} {found[1e13, load][0] / leading[load]:.4f}" for load in SHEARS))


def few_discs(program):
    """One small rigid disc of the fraction c in an incompressible binder: 1 + 2 c."""
    for fraction in (0.01, 0.001):
        for boundary in WALLED:
            found = with_discs([(0.5, 0.5, 2 * math.sqrt(fraction / math.pi))],
                               lambda path: moduli(program, boundary, path, (4, 0.3, 60), [1e9], None))
            print(f"fraction {fraction:g}, {boundary}, (modulus - 1) / fraction:",
                  ", ".join(f"{load} {(found[1e9, load][0] - 1) / fraction:.4f}" for load in SHEARS))


def order_of_boundaries(program):
    """Traction <= periodic <= displacement, for the same discs."""
    least = math.inf
    for name in WALLED_PACKINGS:
        traction, periodic, displacement = (
            moduli(program, boundary, f"{HERE}/packings_walls/{name}.csv", (3, 0.6, 2), [10, 1e3, 1e6], None)
            for boundary in ("traction", "periodic", "displacement"))
        for case in periodic:
            least = min(least, periodic[case][0] / traction[case][0] - 1, displacement[case][0] / periodic[case][0] - 1)
    print(f"traction <= periodic <= displacement: least excess {least:.1e}")


def turned_walled_packing(program):
    """Turned by 90 degrees, and mirrored."""
    path = f"{HERE}/packings_walls/walls_ratio3_62_040_g030.csv"
    for boundary in WALLED:
        for shear, mesh in ((None, (3, 0.6, 2)), (1000, (2, 0.6, 2))):
            found = moduli(program, boundary, path, mesh, [1e3, 1e6], shear)
            for move, moved in (("turned", [(1 - y, x, diameter) for x, y, diameter in discs_of(path)]),
                                ("mirrored", [(1 - x, y, diameter) for x, y, diameter in discs_of(path)])):
                again = with_discs(moved, lambda name: moduli(program, boundary, name, mesh, [1e3, 1e6], shear))
                print(f"{move} packing with walls, {boundary}, Gf/g {shear or 'inf'}: worst error",
                      f"{max(error(again[case][0], found[case][0]) for case in found):.1e}")


def stiff_discs(program):
    """Very stiff discs have the moduli of rigid ones, which have no elements."""
    path = f"{HERE}/packings_walls/walls_four_g100.csv"
    for boundary in WALLED:
        for shear in (1e6, 1e8):
            rigid, stiff = (moduli(program, boundary, path, FINE, [10, 1e3], discs) for discs in (None, shear))
            print(f"discs of Gf/g {shear:g} for rigid ones, {boundary}: worst change",
                  f"{max(error(stiff[case][0], rigid[case][0]) for case in rigid):.1e}")


def meshes_with_walls(program):
    """The quartic meshes of moduli_walls.csv against finer ones."""
    for name in WALLED_PACKINGS:
        for boundary in WALLED:
            path = f"{HERE}/packings_walls/{name}.csv"
            found, finer = (moduli(program, boundary, path, mesh, [10, 1e3, 1e6], None)
                            for mesh in (FINE, (4, 0.35, 4)))
            print(f"{name}, {boundary}: worst change",
                  f"{max(error(found[case][0], finer[case][0]) for case in finer):.1e}")


CHECKS = (discs_of_the_binder, conforming_triangles, lubrication, turned_arrays, moved_packing, meshes,
          lubrication_of_walls, few_discs, order_of_boundaries, turned_walled_packing, stiff_discs, meshes_with_walls)
for check in CHECKS:
    if len(sys.argv) == 2 or check.__name__ in sys.argv[2:]:
        check(sys.argv[1])
