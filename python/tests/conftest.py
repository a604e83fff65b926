"""What several tests take: paths, the command line, a result that is solved once."""

import os
import subprocess
from pathlib import Path

import pytest

import breccia

ROOT = Path(__file__).parents[2]
MODEL = ROOT / "examples" / "model-composite.toml"
FILMS = ROOT / "examples" / "pbx9501-films.toml"
FILMS_IN_SPACE = ROOT / "examples" / "pbx9501-films-3d.toml"
OVERRIDES = {"stages.0.cells": 24, "tests.method": "quasistatic", "tests.boundaries": ["displacement", "traction"]}


@pytest.fixture(scope="session")
def command():
    """Runs the command line; skipped where there is none."""
    program = os.environ.get("BRECCIA_COMMAND")
    if not program:
        pytest.skip("BRECCIA_COMMAND names no program")

    def run(*arguments):
        return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, check=False)

    return run


@pytest.fixture(scope="session")
def model():
    """The model composite of the paper, coarsely."""
    return breccia.solve(breccia.read_study(MODEL, OVERRIDES))


@pytest.fixture
def binder():
    return breccia.Material("binder", density="1.0 g/cm^3", bulk="1.0 MPa",
                            shear=breccia.PronySeries([(0.01, 0.5e6)]))


@pytest.fixture
def particle():
    return breccia.Material("particle", density="1.5 g/cm^3", bulk=50e6, shear="18.8 MPa")


@pytest.fixture
def composite(binder, particle):
    """The same composite, built in Python."""
    return breccia.Stage("model", matrix=binder, box="6 mm", cells=24, fillers=breccia.Filler(particle, diameter=2e-3),
                         packing=breccia.Packing("regular", columns=2, rows=2))
