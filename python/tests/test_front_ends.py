"""The command line, the module and the page of a result answer twenty studies alike: moduli, errors, warnings and the
words on their accuracy."""

import csv
import json
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import breccia
from conftest import ROOT

MATERIALS = """
title = "One of twenty"
[materials.binder]
density = "1.0 g/cm^3"
bulk = "1 GPa"
shear = { equilibrium = "1 MPa", terms = [{ time = "1 ms", modulus = "20 MPa" }, { time = "0.1 s", modulus = "5 MPa" }] }
[materials.glass]
density = "2.5 g/cm^3"
bulk = "40 GPa"
shear = "30 GPa"
[materials.foam]
density = "0.3 g/cm^3"
bulk = "50 MPa"
shear = "0.1 MPa"
"""
DISCS = """
[[stages]]
name = "composite"
matrix = "binder"
box = "6 mm"
cells = 48
filler = { material = "glass", fraction = 0.35, sizes = { diameter = "1 mm" }, gap = "0.1 mm" }
packing = { method = "lubachevsky-stillinger" }
"""
TESTS = """
[tests]
times = ["1 ms", "1 s"]
"""
MEASURED = """
[[measurements]]
name = "a laboratory"
shear = { curve = "measured.csv" }
"""


def changed(deck, *changes):
    """A deck with other lines in place of some of its own."""
    for old, new in changes:
        assert old in deck, old
        deck = deck.replace(old, new)
    return MATERIALS + deck


def of_space(deck):
    return changed(deck, ('"6 mm"', '"2 mm"'), ("cells = 48", "cells = 16"), ("0.35", "0.2")).replace(
        'title =', 'dimensions = 3\ntitle =', 1)


ONE = DISCS + TESTS
COATED = 'gap = "0.1 mm", coating = { material = "foam", thickness = "0.1 mm" }'
ELLIPSES = 'gap = "0.1 mm", shape = { aspect = 1.5 }'
GRAINS = """
[[stages]]
name = "composite"
matrix = "binder"
box = "6 mm"
cells = 96
filler = { material = "glass", sizes = { diameter = "1 mm" } }
packing = { method = "laguerre", film = "0.1 mm" }
"""
IMAGE = f"""
[[stages]]
name = "composite"
matrix = "binder"
cells = 50
packing = {{ method = "image", file = "{ROOT}/examples/image/labels.png", pixel = "1 um", periodic = true, labels = [
  {{ value = 0, material = "binder" }}, {{ value = 255, material = "glass" }} ] }}
"""
SECOND = DISCS.replace('"composite"', '"coarse"').replace('"binder"', '"composite"').replace("mm", "cm")
STUDIES = {
    "random discs": changed(ONE),
    "two grids": changed(ONE, ("cells = 48", "cells = [24, 48]")),
    "a box chosen for an accuracy": changed(ONE, ('box = "6 mm"\ncells = 48\n', ""), ("[tests]", "[tests]\naccuracy = \"15 %\"")),
    "the number of particles": changed(ONE, ('box = "6 mm"', "particles = 20")),
    "walls": changed(ONE, ("stillinger\"", 'stillinger", walls = true')),
    "a window": changed(ONE, ("stillinger\"", 'stillinger", walls = "cut"')),
    "shear and bulk": changed(ONE, ("[tests]", '[tests]\nloads = ["shear", "bulk"]')),
    "frequencies": changed(ONE, ('times = ["1 ms", "1 s"]', 'frequencies = ["1 Hz", "100 Hz"]')),
    "a measurement": changed(ONE + MEASURED),
    "two fillers": changed(ONE, ("filler = {", "filler = [{"), ('gap = "0.1 mm" }', 'gap = "0.1 mm" }, { material = "foam", '
                           'fraction = 0.1, sizes = { diameter = "0.8 mm" }, gap = "0.1 mm" }]')),
    "a coating": changed(ONE, ('gap = "0.1 mm"', COATED), ("0.35", "0.25")),
    "a soft filler": changed(ONE, ('material = "glass"', 'material = "foam"')),
    "ellipses": changed(ONE, ('gap = "0.1 mm"', ELLIPSES), ("lubachevsky-stillinger", "random")),
    "grains": changed(GRAINS + TESTS),
    "films": changed(GRAINS + TESTS, ("[tests]", '[tests]\nmodel = "films"')),
    "an image": changed(IMAGE + TESTS, ("[tests]", '[tests]\nboundaries = ["periodic"]')),
    "spheres": of_space(ONE),
    "two stages": changed(DISCS + SECOND + TESTS),
    "a regular array": changed(ONE, ('"lubachevsky-stillinger"', '"regular", columns = 3, rows = 3'), (", gap = \"0.1 mm\"", ""),
                               ("fraction = 0.35, ", "")),
    "time steps": changed(ONE, ("[tests]", '[tests]\nsolver = "stepping"\nloads = ["shear"]')),
}


@pytest.fixture(scope="module", params=STUDIES)
def answers(request, command, tmp_path_factory):
    """What all three say about a study: the output and the files of the command line, a result, and the first screen."""
    directory = tmp_path_factory.mktemp("study")
    deck = directory / "deck.toml"
    deck.write_text(STUDIES[request.param])
    (directory / "measured.csv").write_text("time_s,modulus_Pa\n1e-3,40e6\n1,3e6\n")
    run = command("run", deck, "--out", directory / "out", "--threads", "1")
    assert run.returncode == 0, run.stderr
    solved = breccia.solve(breccia.read_study(deck), threads=1)
    return run.stdout, directory / "out", solved


def rows_of(file: Path):
    with file.open() as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def data_of_page(results: Path):
    page = (results / "report.html").read_text()
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S)[1])


def test_moduli(answers):
    _, results, solved = answers
    rows = rows_of(results / "curves.csv")
    in_page = data_of_page(results)["tables"]["curves.csv"]
    assert np.array_equal(in_page["modulus_Pa"], [float(row["modulus_Pa"]) for row in rows])
    for stage in solved.stages:
        for test in stage.tests:
            if test.grid == "extrapolated":
                continue  # curves.csv has the grids
            of_test = [float(row["modulus_Pa"]) for row in rows if (row["stage"], row["load"], row["boundary"], row["cells"])
                       == (stage.name, test.load, test.boundary, str(test.grid))]
            assert test.modulus.tolist() == of_test


def test_errors(answers):
    _, results, solved = answers
    rows = rows_of(results / "errors.csv")
    in_page = data_of_page(results)["tables"]["errors.csv"]
    assert len(rows) == sum(len(test.error) for stage in solved.stages for test in stage.tests) > 0
    for stage in solved.stages:
        for test in stage.tests:
            of_test = [number for number, row in enumerate(rows) if (row["stage"], row["load"], row["boundary"], row["cells"])
                       == (stage.name, test.load, test.boundary, str(test.grid))]
            written = [float(rows[number]["error"] or "nan") for number in of_test]
            assert np.allclose(test.error, written, rtol=1e-6, equal_nan=True)
            shown = [in_page["error"][number] or np.nan for number in of_test]
            assert np.allclose(test.error, np.array(shown, float), rtol=1e-6, equal_nan=True)


def test_warnings_and_accuracy(answers):
    printed, results, solved = answers
    study = json.loads((results / "study.json").read_text())
    in_page = data_of_page(results)["study"]
    assert study["stages"] == in_page["stages"]
    matrices = {stage["matrix"] for stage in study["stages"]}
    for stage, entry in zip(solved.stages, study["stages"], strict=True):
        assert stage.warnings == entry["warnings"]
        for warning in stage.warnings:
            assert printed.count(f"warning: {warning}\n") == 1
        assert stage.accuracy == entry["quality"]["summary"]
        if stage.name not in matrices:
            assert f"{stage.name}, this box: {stage.accuracy}" in printed


def test_the_first_screen(answers):
    if shutil.which("node") is None:
        pytest.skip("there is no node")
    printed, results, solved = answers
    script = Path(__file__).parent / "first_screen.mjs"
    screen = json.loads(subprocess.run(["node", script, results / "report.html"], capture_output=True, text=True, check=True).stdout)
    warnings = {warning for stage in solved.stages for warning in stage.warnings}
    assert {warning.replace("\u00b5", "u") for warning in screen["warnings"]} == warnings
    assert solved.stages[-1].name in screen["answer"]
    # The moduli of the page are those of the last table that the command has printed, in the same three digits.
    head, *rows = [[cell.replace("\u00b5", "u") for cell in row] for row in screen["rows"]]
    first = 1 if head[0] in ("time", "frequency") else 0
    assert first == 1 and rows
    for row in rows:
        modulus = row[1].split(" \u00b1 ")[0]
        lines = [line for line in printed.splitlines() if re.match(rf"\s+{re.escape(row[0])}  ", line)]
        assert any(modulus in line for line in lines), (row, lines)
