"""Makes packings/*.csv and packings_walls/*.csv: random packings, by random_packing with fixed seeds, and arrays."""
import math
import subprocess
import sys

# name: large discs, small discs, size ratio, area fraction, gap, spread of the gap, seed
RANDOM = {
    "equal_60_040_g050": (0, 40, 1, 0.60, 0.005, 0, 1),
    "ratio3_67_040_g020": (4, 36, 3, 0.67, 0.002, 0, 3),
    "ratio10_65_203_g020": (3, 200, 10, 0.65, 0.002, 0, 5),
    "equal_57_040_g040": (0, 40, 1, 0.57, 0.004, 0, 6),
    "ratio2.3_66_040_g030": (8, 32, 2.3, 0.66, 0.003, 0, 7),
    "equal_50_040_g100": (0, 40, 1, 0.50, 0.010, 0, 8),
    "equal_75_040_g050": (0, 40, 1, 0.75, 0.005, 0, 9),
    "equal_60_100_g050": (0, 100, 1, 0.60, 0.005, 0, 10),
    "ratio3_70_100_g030": (10, 90, 3, 0.70, 0.003, 0, 11),
    "equal_60_400_g050": (0, 400, 1, 0.60, 0.005, 0, 12),
    "ratio10_72_154_g050": (4, 150, 10, 0.72, 0.005, 0, 14),
    "ratio2_62_060_spread": (20, 40, 2, 0.62, 0.002, 19, 21),
    "equal_65_050_spread": (0, 50, 1, 0.65, 0.003, 9, 22),
    "ratio3_60_100_spread": (10, 90, 3, 0.60, 0.002, 30, 23),
    "equal_70_060_g020": (0, 60, 1, 0.70, 0.002, 0, 24),
    "ratio4_68_070_g040": (6, 64, 4, 0.68, 0.004, 0, 25),
    "ratio10_60_254_g100": (4, 250, 10, 0.60, 0.010, 0, 26),
    "ratio1.4_73_060_g100": (30, 30, 1.4, 0.73, 0.010, 0, 27),
    "ratio1.4_78_060_g030": (30, 30, 1.4, 0.78, 0.003, 0, 28),
}

# The same in a box with walls
RANDOM_WALLED = {
    "walls_equal_55_040_g050": (0, 40, 1, 0.55, 0.005, 0, 41),
    "walls_equal_60_040_g100": (0, 40, 1, 0.60, 0.010, 0, 42),
    "walls_ratio3_62_040_g030": (4, 36, 3, 0.62, 0.003, 0, 43),
}

# name: discs along a side of the box, and their gaps to each other and to the walls
ARRAYS_WALLED = {"walls_one_g100": (1, 0.01), "walls_one_g030": (1, 0.003), "walls_four_g100": (2, 0.01)}

# name: a vector of the lattice; the box has as many discs as cells of the lattice
ARRAYS = {"square": (1.0, 0.0), "square27": (0.4, 0.2), "square45": (0.5, 0.5)}
GAPS = {"g300": 0.03, "g100": 0.01, "g030": 0.003, "g010": 0.001}


def lattice(vector):
    """The points of the square lattice in the box."""
    x, y = vector
    points = {(round((i * x - j * y) % 1.0, 12) % 1.0, round((i * y + j * x) % 1.0, 12) % 1.0)
              for i in range(-5, 6) for j in range(-5, 6)}
    return sorted(points)


def make_random(program, folder, box, requests):
    for name, request in requests.items():
        with open(f"{folder}/{name}.csv", "w") as file:
            subprocess.run([program, box, *map(str, request)], stdout=file, check=True)


def make_periodic_arrays():
    for name, vector in ARRAYS.items():
        for tag, gap in GAPS.items():
            pitch = math.hypot(*vector)
            with open(f"packings/{name}_{tag}.csv", "w") as file:
                print(f"# Periodic box of side 1, made by make_packings.py: square array of pitch {pitch!r},\n"
                      f"# gap {gap:g} of the diameter.\nx,y,diameter", file=file)
                for x, y in lattice(vector):
                    print(f"{x!r},{y!r},{pitch / (1 + gap)!r}", file=file)


def make_walled_arrays():
    for name, (side, gap) in ARRAYS_WALLED.items():
        diameter = 1 / (side + (side + 1) * gap)
        places = [(i + 0.5 + (i + 1) * gap) * diameter for i in range(side)]
        with open(f"packings_walls/{name}.csv", "w") as file:
            print(f"# Box with walls of side 1, made by make_packings.py: {side * side} equal discs,\n"
                  f"# gaps to each other and to the walls {gap:g} of the diameter.\nx,y,diameter", file=file)
            for x in places:
                for y in places:
                    print(f"{x!r},{y!r},{diameter!r}", file=file)


def main(program):
    make_random(program, "packings", "periodic", RANDOM)
    make_periodic_arrays()
    make_random(program, "packings_walls", "walled", RANDOM_WALLED)
    make_walled_arrays()


main(sys.argv[1])
