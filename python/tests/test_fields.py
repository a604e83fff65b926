"""Fields: equilibrium, which test has them, the work of grains and films."""

import pickle

import numpy as np
import pytest

import breccia
from conftest import FILMS, FILMS_IN_SPACE, MODEL, OVERRIDES


def test_fields_hold_equilibrium(model):
    field = model["model"].test(boundary="displacement").fields[-1]
    assert field["stress"].shape == (48, 48, 4) and field["phase"].shape == (48, 48)
    # Hill: under an affine boundary the mean strain is that of the load, its tensor shear one half.
    mean = field["strain"].reshape(-1, 3).mean(axis=0)
    assert mean == pytest.approx([0.0, 0.0, 0.5], abs=1e-9)
    modulus = model["model"].prony(boundary="displacement").at(field["time"])
    assert field["stress"][..., 3].mean() == pytest.approx(modulus, rel=1e-3)


def test_fields_are_those_of_a_grid_and_a_load():
    study = breccia.read_study(MODEL, {**OVERRIDES, "stages.0.cells": [12, 24], "tests.loads": "isotropic",
                                       "tests.boundaries": ["displacement"], "tests.fields": "last"})
    stage = breccia.solve(study)["model"]
    assert stage.test().grid == "extrapolated" and stage.test().fields == []
    assert stage.fields()[-1]["phase"].shape == (48, 48)
    assert np.array_equal(stage.fields()[-1]["stress"], stage.test("shear", grid=24).fields[-1]["stress"])
    for words in ({"grid": 12}, {"load": "bulk"}):
        with pytest.raises(breccia.InputError, match="no such fields; tests.fields"):
            stage.fields(**words)


def test_fields_of_grains_and_films_have_the_work_of_the_load():
    study = breccia.read_study(FILMS, {"stages.0.box": "0.4 mm", "tests.times": ["1 us", "1 ms"],
                                       "tests.fields": "last", "tests.loads": ["shear"]})
    result = breccia.solve(study)
    for test in (result["PBX-9501"].tests[0], pickle.loads(pickle.dumps(result))["PBX-9501"].tests[0]):
        field = test.fields[-1]
        cells = len(field["part"])
        assert set(field["part"]) == {0, 1, 2} and field["time"] == 1e-3
        assert field["strain"].shape == (cells, 3) and field["stress"].shape == (cells, 4)
        assert field["first_corner"][-1] == len(field["corners"]) and field["corners"].max() < len(field["points"])
        assert field["displacement"].shape == field["points"].shape
        # The mean of the work over the box is the modulus.
        assert (field["work"] * field["area"]).sum() / 0.4e-3**2 == pytest.approx(test.modulus[-1], rel=2e-3)


def test_fields_of_films_in_space_have_the_work_of_the_load():
    study = breccia.read_study(FILMS_IN_SPACE, {"stages.0.particles": 4, "tests.films": {"divisions": 1},
                                                "tests.times": ["1 us", "1 ms"], "tests.loads": ["shear"]})
    result = breccia.solve(study)
    for test in (result["PBX-9501"].tests[0], pickle.loads(pickle.dumps(result))["PBX-9501"].tests[0]):
        field = test.fields[-1]
        cells = len(field["part"])
        assert set(field["part"]) == {0, 1, 2, 4} and field["points"].shape[1] == 3
        assert field["strain"].shape == (cells, 6) and field["stress"].shape == (cells, 6)
        box = field["volume"].sum()
        assert (field["work"] * field["volume"]).sum() / box == pytest.approx(test.modulus[-1], rel=2e-3)
