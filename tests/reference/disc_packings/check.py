"""Checks the solver disc_moduli and prints the figures of README.md."""
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


def error(value, reference):
    return abs(value / reference - 1)


def discs_of_the_binder(program):
    """A packing of one material has its moduli: 1, 1 and K + 1/3."""
    path = f"{HERE}/packings/equal_60_040_g050.csv"
    for bulk in (1e3, 1e6):
        found = run(program, path, (3, 0.5, 2), [bulk], (bulk, 1.0))
        exact = {"xx-yy": 1, "xy": 1, "bulk": bulk + 1 / 3}
        worst = max(error(found[bulk, load][0], exact[load]) for load in exact)
        print(f"discs of the binder, K/g {bulk:g}: worst error {worst:.1e}")


def conforming_triangles(program):
    """The periodic arrays of elastic_square_array.csv."""
    rows = [row for row in table(f"{HERE}/../elastic_square_array.csv") if row["boundary"] == "periodic"]
    errors = []
    for fraction, contrast in sorted({(float(row["fraction"]), float(row["contrast"])) for row in rows}):
        disc = (0.5, 0.5, 2 * math.sqrt(fraction / math.pi))
        found = with_discs([disc], lambda path: moduli(program, path, (3, 0.3, 3), (3, 3600), contrast))
        for row in rows:
            if (float(row["fraction"]), float(row["contrast"])) == (fraction, contrast):
                modulus = found[float(row["bulk_ratio"]), row["load"]][0]
                errors.append((error(modulus, float(row["modulus"])), row["relative_error"]))
    median = statistics.median(difference for difference, _ in errors)
    worst, stated = max(errors)
    print(f"{len(errors)} square arrays by triangles: difference {median:.1e} in the median, {worst:.1e} at worst, "
          f"where the table states an error of {stated}")


def lubrication(program):
    """Shear moduli of a square array over the leading terms for narrow gaps of radius a, gap h."""
    for gap in (0.03, 0.01, 0.003, 0.001, 0.0003, 0.0001):
        diameter = 1 / (1 + gap)
        found = with_discs([(0.5, 0.5, diameter)], lambda path: moduli(program, path, FINE, [1e9], None))
        narrow = diameter / 2 / (1 - diameter)  # a / h
        leading = {"xx-yy": 3 * math.pi / 4 * narrow ** 1.5, "xy": math.pi / 2 * narrow ** 0.5}
        print(f"gap {100 * gap:g} % over leading terms:",
              ", ".join(f"{load} {found[1e9, load][0] / leading[load]:.4f}" for load in SHEARS))


def turned_arrays(program):
    """Turned by t, an array has cos(2t)^2 of one shear modulus and sin(2t)^2 of the other."""
    worst = 0.0
    for tag in ("g300", "g100", "g030", "g010"):
        straight, by_27, by_45 = (moduli(program, f"{HERE}/packings/{name}_{tag}.csv", FINE, [1e3, 1e6], None)
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
    with open(path) as file:
        discs = [tuple(map(float, line.split(","))) for line in file if line[0].isdigit()]
    found = moduli(program, path, (3, 0.6, 2), [1e6], None)
    moved = with_discs([((0.37 - y) % 1, (x + 0.21) % 1, diameter) for x, y, diameter in discs],
                       lambda name: moduli(program, name, (3, 0.6, 2), [1e6], None))
    print(f"shifted and turned packing: worst error {max(error(moved[case][0], found[case][0]) for case in found):.1e}")


def meshes(program):
    """The quartic meshes of moduli.csv against finer ones."""
    for name in ("square_g100", "equal_50_040_g100", "equal_75_040_g050", "ratio3_67_040_g020", "ratio10_60_254_g100"):
        path = f"{HERE}/packings/{name}.csv"
        found, finer = (moduli(program, path, mesh, [1e3, 1e6], None) for mesh in (FINE, (4, 0.35, 4)))
        print(f"{name}: worst change {max(error(found[case][0], finer[case][0]) for case in finer):.1e}")


for check in (discs_of_the_binder, conforming_triangles, lubrication, turned_arrays, moved_packing, meshes):
    check(sys.argv[1])
