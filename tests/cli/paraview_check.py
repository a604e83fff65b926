"""Opens the fields of a run in ParaView, and compares their means with the curves.

    pvpython --force-offscreen-rendering tests/cli/paraview_check.py RESULTS

For every file of fields that study.json names, the stress that ParaView integrates over the box, over its area, must be
the modulus of curves.csv at the same time for a strain of one; under a traction boundary the strain must be the
compliance of compliance.csv for a stress of one. Fields are single precision: within 1e-6 for quasi-static tests at a
time of the curve. Between two of them the nearest is taken, and dynamic fields ring: within 3 %.
"""

import csv
import json
import pathlib
import sys

from paraview import servermanager, simple

XX, YY, XY = 0, 1, 3


def conjugate(load, tensor):
    """Of a mean stress or strain, what the unit strain of a load does work on."""
    if load == "bulk":
        return 0.5 * (tensor[XX] + tensor[YY])
    return tensor[XY] if load == "shear" else 0.5 * (tensor[XX] - tensor[YY])


def mean(file, name):
    """Mean of a tensor over the box, as ParaView integrates it."""
    reader = simple.VTKHDFReader(FileName=str(file))
    integrals = servermanager.Fetch(simple.IntegrateVariables(Input=reader)).GetCellData()
    area = integrals.GetArray("Area").GetValue(0)
    return [integrals.GetArray(name).GetComponent(0, k) / area for k in range(6)]


def curve_point(results, table, column, stage, test, time):
    """Time and value of a table at the time nearest to one."""
    with open(results / table) as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    keys = {"stage": stage, "cells": str(test["cells"]), **{key: test[key] for key in ("load", "boundary", "method")}}
    mine = [row for row in rows if all(row[key] == value for key, value in keys.items())]
    nearest = min(mine, key=lambda row: abs(float(row["time_s"]) - time))
    return float(nearest["time_s"]), float(nearest[column])


def main(results):
    checked = wrong = 0
    for stage in json.loads((results / "study.json").read_text())["stages"]:
        for test in stage["tests"]:
            for field in test.get("fields", []):
                file = results / stage["name"] / field["file"]
                if test["boundary"] == "traction":
                    # A stress of one gives a shear angle or dilatation, twice the tensor's component.
                    found = 2.0 * conjugate(test["load"], mean(file, "strain"))
                    table, column = "compliance.csv", "compliance_1_per_Pa"
                else:
                    found = conjugate(test["load"], mean(file, "stress_Pa"))
                    table, column = "curves.csv", "modulus_Pa"
                time, expected = curve_point(results, table, column, stage["name"], test, field["time_s"])
                deviation = abs(found / expected - 1.0)
                is_exact = test["method"] == "quasistatic" and abs(time / field["time_s"] - 1.0) < 1e-9
                is_wrong = not deviation < (1e-6 if is_exact else 0.03)
                print(f"{file}: {found:.9g}, {table} {expected:.9g}, differ by {deviation:.1e}"
                      f"{' WRONG' if is_wrong else ''}")
                checked += 1
                wrong += is_wrong
    print(f"{checked} files of fields, {wrong} wrong")
    return 1 if wrong or not checked else 0


sys.exit(main(pathlib.Path(sys.argv[1])))
