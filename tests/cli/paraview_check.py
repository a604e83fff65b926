"""Opens the fields and the labels of a run in ParaView, and compares their means with the curves.

    pvpython --force-offscreen-rendering tests/cli/paraview_check.py RESULTS

For every file of fields that study.json names, the stress that ParaView integrates over the box, over its area or
volume, must be the modulus of curves.csv at the same time for a strain of one; under a traction boundary the strain
must be the compliance of compliance.csv for a stress of one. Fields are single precision: within 1e-6 for quasi-static
tests at a time of the curve. Between two of them the nearest is taken, and dynamic fields ring: within 3 %.
The points of labels.vti that are in the filler must be the share that study.json gives, where no cell is mixed.
"""

import csv
import json
import pathlib
import sys

from paraview import servermanager, simple

XX, YY, ZZ, XY, YZ, XZ = range(6)


def conjugate(load, tensor, dimensions):
    """Of a mean stress or strain, what the unit strain of a load does work on."""
    if load == "bulk":
        return sum(tensor[:dimensions]) / dimensions
    if load in ("shear", "shear-yz", "shear-zx"):
        return tensor[{"shear": XY, "shear-yz": YZ, "shear-zx": XZ}[load]]
    first, second = {"shear-xx-yy": (XX, YY), "shear-yy-zz": (YY, ZZ)}[load]
    return 0.5 * (tensor[first] - tensor[second])


def integrals(reader):
    """What ParaView integrates over the cells, and the area or volume of all of them."""
    of_cells = servermanager.Fetch(simple.IntegrateVariables(Input=reader)).GetCellData()
    size = of_cells.GetArray("Volume") or of_cells.GetArray("Area")
    return of_cells, size.GetValue(0)


def mean(file, name):
    """Mean of a tensor over the box, as ParaView integrates it."""
    of_cells, size = integrals(simple.VTKHDFReader(FileName=str(file)))
    return [of_cells.GetArray(name).GetComponent(0, k) / size for k in range(6)]


def curve_point(results, table, column, stage, test, time):
    """Time and value of a table at the time nearest to one."""
    with open(results / table) as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    keys = {"stage": stage, "cells": str(test["cells"]), **{key: test[key] for key in ("load", "boundary", "method")}}
    mine = [row for row in rows if all(row[key] == value for key, value in keys.items())]
    nearest = min(mine, key=lambda row: abs(float(row["time_s"]) - time))
    return float(nearest["time_s"]), float(nearest[column])


def is_field_wrong(results, stage, test, field):
    """Prints how far a file of fields is from the tables."""
    file = results / stage["name"] / field["file"]
    if test["boundary"] == "traction":
        # A stress of one gives a shear angle or dilatation: twice the tensor's component, or so many times its mean.
        times = stage["dimensions"] if test["load"] == "bulk" else 2
        found = times * conjugate(test["load"], mean(file, "strain"), stage["dimensions"])
        table, column = "compliance.csv", "compliance_1_per_Pa"
    else:
        found = conjugate(test["load"], mean(file, "stress_Pa"), stage["dimensions"])
        table, column = "curves.csv", "modulus_Pa"
    time, expected = curve_point(results, table, column, stage["name"], test, field["time_s"])
    deviation = abs(found / expected - 1.0)
    is_exact = test["method"] == "quasistatic" and abs(time / field["time_s"] - 1.0) < 1e-9
    is_wrong = not deviation < (1e-6 if is_exact else 0.03)
    print(f"{file}: {found:.9g}, {table} {expected:.9g}, differ by {deviation:.1e}{' WRONG' if is_wrong else ''}")
    return is_wrong


def are_labels_wrong(results, stage, box):
    """Prints how far the share of the points of a filler, and the size of the box, are from study.json."""
    file = results / stage["name"] / "labels.vti"
    of_cells, size = integrals(simple.XMLImageDataReader(FileName=[str(file)]))
    share = of_cells.GetArray("phase").GetValue(0) / size
    expected = stage["filler_point_fraction"]
    whole = box ** stage["dimensions"]
    is_wrong = not (abs(share - expected) < 1e-12 and abs(size / whole - 1.0) < 1e-9)
    print(f"{file}: {share:.9g} of the box, study.json {expected:.9g}{' WRONG' if is_wrong else ''}")
    return is_wrong


def main(results):
    verdicts = []
    study = json.loads((results / "study.json").read_text())
    for stage in study["stages"]:
        for test in stage["tests"]:
            verdicts += [is_field_wrong(results, stage, test, field) for field in test.get("fields", [])]
        if 'mixing = "points"' in study["deck_text"] or 'tests.mixing="points"' in study["overrides"]:
            verdicts.append(are_labels_wrong(results, stage, stage["box_m"]))
    print(f"{len(verdicts)} files, {sum(verdicts)} wrong")
    return 1 if any(verdicts) or not verdicts else 0


sys.exit(main(pathlib.Path(sys.argv[1])))
