"""Results of earlier runs, and of sweeps."""

import json
import pickle

import numpy as np
import pytest

import breccia
from conftest import MODEL


@pytest.fixture(scope="module", params=["shear", "isotropic"])
def run(request, tmp_path_factory):
    """A study of two grids under both bounds and one load, with what was computed and its directory."""
    directory = tmp_path_factory.mktemp("stored") / "run"
    study = breccia.read_study(MODEL, {"stages.0.cells": [24, 48], "tests.method": "quasistatic",
                                       "tests.boundaries": ["displacement", "traction"],
                                       "tests.loads": [request.param],
                                       "tests.volumetric": "standard" if request.param == "shear" else "averaged"})
    return breccia.run(study, directory), directory


def test_what_was_computed_is_read(run):
    result, directory = run
    stored = breccia.read_results(directory)
    assert stored.title == result.title and list(stored) == list(result) and stored.seconds > 0.0
    assert stored.materials == result.materials and stored.warnings == result.warnings
    stage, there = result["model"], stored["model"]
    assert (there.cells, there.dimensions, there.points) == (stage.cells, stage.dimensions, stage.points)
    assert there.point_fraction == stage.point_fraction and there.microstructure is None
    assert [repr(test) for test in there.tests] == [repr(test) for test in stage.tests]
    for test, again in zip(stage.tests, there.tests):
        assert np.array_equal(again.time, test.time) and np.array_equal(again.modulus, test.modulus)
        assert np.array_equal(again.compliance, test.compliance)
        assert np.array_equal(again.half_bands, test.half_bands)
        assert again.error_estimate == test.error_estimate or np.isnan(test.error_estimate)
    for boundary in ("displacement", "traction"):
        assert there.prony(boundary=boundary) == stage.prony(boundary=boundary)
    assert "displacement" in stored._repr_html_()


def test_stored_results_answer_and_are_pickled(run, binder):
    result, directory = run
    stored = pickle.loads(pickle.dumps(breccia.read_results(directory)))
    assert np.array_equal(breccia.respond(stored, binder)["model"].curve(boundary="traction"),
                          breccia.respond(result, binder)["model"].curve(boundary="traction"))


def test_series_that_no_directory_has_are_refused(run):
    _, directory = run
    stage = breccia.read_results(directory)["model"]
    with pytest.raises(breccia.InputError, match=r"fit\(\) makes one"):
        stage.prony(boundary="traction", grid=24)


def test_directories_without_results_are_refused(run, tmp_path):
    _, directory = run
    with pytest.raises(breccia.InputError, match="no such directory"):
        breccia.read_results(tmp_path / "nothing")
    with pytest.raises(breccia.InputError, match="no prony.csv"):
        breccia.read_results(tmp_path)
    with pytest.raises(breccia.InputError, match="no sweep.json"):
        breccia.read_sweep_results(directory)
    for name in ("study.json", "prony.csv", "curves.csv"):
        (tmp_path / name).write_bytes((directory / name).read_bytes())
    record = json.loads((tmp_path / "study.json").read_text())
    record["stages"][0]["name"] = "../elsewhere"
    (tmp_path / "study.json").write_text(json.dumps(record))
    with pytest.raises(breccia.FileError, match="is not a name that `breccia run` gives"):
        breccia.read_results(tmp_path)
    (tmp_path / "study.json").write_text("{}")
    with pytest.raises(breccia.FileError, match="study.json: not as `breccia run` writes it"):
        breccia.read_results(tmp_path)


def test_sweeps_are_studies_by_names(command, tmp_path):
    overrides = {"stages.0.cells": 8, "tests.method": "quasistatic"}
    studies = breccia.read_sweep(MODEL, overrides, keys={"tests.volumetric": ["standard", "averaged"]})
    assert list(studies) == ["volumetric-standard", "volumetric-averaged"]
    run = command("run", MODEL, "--set", "stages.0.cells=8", "--set", 'tests.method="quasistatic"', "--sweep",
                  'tests.volumetric=["standard", "averaged"]', "--out", tmp_path / "sweep", "--quiet")
    assert run.returncode == 0, run.stderr
    stored = breccia.read_sweep_results(tmp_path / "sweep")
    assert list(stored) == list(studies)
    for name, study in studies.items():
        solved = breccia.solve(study)["model"].tests[0]
        assert np.array_equal(stored[name]["model"].tests[0].modulus, solved.modulus)
    with pytest.raises(breccia.InputError, match="task"):
        breccia.read_results(tmp_path / "sweep")


def test_mistakes_of_sweeps_are_those_of_arguments():
    with pytest.raises(breccia.InputError) as error:
        breccia.read_sweep(MODEL, {"stages.modle.cells": 3}, keys={"tests.volumetric": []})
    assert "overrides stages.modle.cells=3: stages has no entry" in str(error.value)
    assert "--" not in str(error.value)
