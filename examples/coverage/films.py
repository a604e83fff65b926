#!/usr/bin/env python3
"""How far the model of grains and thin films is from resolved films, for its error (theory, Eq. 66b): random boxes of
grains whose films are thin, of finer elements, and resolved by layers (in space
thin, with four elements an edge).

    examples/coverage/films.py [DIMENSIONS [FIRST LAST]]    the boxes from FIRST to LAST, by default 1 to 60 of the plane

A box has 20 to 40 grains (in space 4 to 6) of one size or of sizes up to 10:1 (in space 3:1), between which 0.3 to 20 %
(in space 2 to 12 %) is binder; that relaxes by 10 to 1e5 and has a bulk modulus of 1 to 10 times its glassy shear modulus,
and the grains are 2 to 50 times stiffer. Printed are the largest distances at whole decades of the mean shear modulus and
of the bulk modulus from those of the finest, and the errors that the runs print. The program is `breccia` of the path,
or BRECCIA of the environment; results are in `results/films`, or the directory RESULTS of the environment, and what is
there is not run again."""

import json
import os
import random
import sys
from pathlib import Path

from boxes import between, binder_of, filler_of, volume_of
from runs import rows_of, run

RESULTS = Path(os.environ.get("RESULTS", "results/films"))
GRAINS = {2: (20, 40), 3: (4, 6)}
BINDER = {2: (0.003, 0.2), 3: (0.02, 0.12)}
LARGEST_RATIO = {2: 10.0, 3: 3.0}
MESHES = {2: {"default": "face_share = 0.3", "finer": "face_share = 0.15", "finest": "face_share = 0.15, layers = 4"},
          3: {"coarser": "divisions = 1", "default": "divisions = 2", "finer": "divisions = 3", "finest": "divisions = 4"}}


def deck_of(dim, seed):
    """The deck of a box, with the word ELEMENTS in place of its elements."""
    draw = random.Random(f"films {dim} {seed}")
    count = draw.randint(*GRAINS[dim])
    ratio = 1.0 if seed % 2 else between(draw, 1.5, LARGEST_RATIO[dim])
    diameters = [ratio ** (i / max(count - 1, 1)) for i in range(count)]
    volume = sum(volume_of(dim, d) for d in diameters)
    side = volume ** (1.0 / dim)
    binder = between(draw, *BINDER[dim])
    glassy, of_binder = binder_of(draw)
    sizes = ", ".join(f'"{d:.6g} um"' for d in diameters)
    return f"""title = "films {dim} {seed}: {count} grains, sizes {ratio:.3g}:1, binder {binder:.4g}"
dimensions = {dim}
[materials.binder]
density = "1 g/cm^3"
{of_binder}
[materials.grains]
density = "2 g/cm^3"
{filler_of(draw, glassy, False)}
[[stages]]
name = "A"
matrix = "binder"
box = "{side:.8g} um"
filler = {{ material = "grains", fraction = {1.0 - binder:.6g}, sizes = {{ list = [{sizes}] }} }}
packing = {{ method = "laguerre", seed = {seed} }}
[tests]
model = "films"
films = {{ ELEMENTS }}
loads = ["isotropic", "bulk"]
times = ["1 us", "100 s"]
points_per_decade = 1
"""


def moduli_of(directory):
    return {(row["load"], row["time_s"]): (float(row["modulus_Pa"]), float(row["error"] or "nan"))
            for row in rows_of(directory / "errors.csv") if row["load"] in ("isotropic", "bulk")}


def main():
    dim = int(sys.argv[1]) if len(sys.argv) > 1 else 2
    first, last = (int(sys.argv[2]), int(sys.argv[3])) if len(sys.argv) > 3 else (1, {2: 60, 3: 12}[dim])
    truth = "finest"
    print("seed,sizes,binder,film_over_size,mesh,load,least,largest,largest_error")
    for seed in range(first, last + 1):
        deck = deck_of(dim, seed)
        title = deck.split('"')[1]
        runs = {mesh: run(RESULTS, f"{dim}-{seed}-{mesh}", deck.replace("ELEMENTS", elements))
                for mesh, elements in MESHES[dim].items()}
        if runs[truth] is None:
            continue
        true = moduli_of(runs[truth])
        made = json.loads((runs[truth] / "study.json").read_text())["stages"][0]["microstructure"]
        film = made["film_m"] / ((made["smallest_diameter_m"] + made["largest_diameter_m"]) / 2)
        for mesh, directory in runs.items():
            if mesh == truth or directory is None:
                continue
            found = moduli_of(directory)
            for load in ("isotropic", "bulk"):
                off = [modulus / true[key][0] - 1.0 for key, (modulus, _) in found.items() if key[0] == load]
                errors = [error for key, (_, error) in found.items() if key[0] == load]
                print(f"{seed},{title.split('sizes ')[1].split(',')[0]},{title.split('binder ')[1]},{film:.4g},{mesh},{load},"
                      f"{min(off):+.2%},{max(off):+.2%},{max(errors):.2%}", flush=True)


main()
