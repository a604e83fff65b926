"""The examples run, and the notebooks are those of the examples, with outputs."""

import json
import os
import subprocess
import sys

import pytest

from conftest import ROOT

EXAMPLES = sorted((ROOT / "examples" / "python").glob("ex*.py"))
NOTEBOOKS = sorted((ROOT / "examples" / "python").glob("ex*.ipynb"))


def test_there_are_eleven_examples_and_four_notebooks():
    assert [example.name[:4] for example in EXAMPLES] == [f"ex{number:02d}" for number in range(1, 12)]
    assert len(NOTEBOOKS) == 4


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_example_runs(example):
    finished = subprocess.run([sys.executable, example.name], cwd=example.parent, env=os.environ, capture_output=True,
                              text=True, timeout=300, check=False)
    assert finished.returncode == 0, finished.stderr
    assert finished.stdout and not finished.stderr


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_is_that_of_its_example(path):
    cells = json.loads(path.read_text())["cells"]
    code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    text = path.with_suffix(".py").read_text()
    parts = [part.partition("\n") for part in text.split("# %%")[1:]]
    assert code == [body.strip() for heading, _, body in parts if "[markdown]" not in heading]
    outputs = [output for cell in cells if cell["cell_type"] == "code" for output in cell["outputs"]]
    assert all(output["output_type"] != "error" for output in outputs)
    assert any("<svg" in "".join(output.get("data", {}).get("text/html", "")) for output in outputs)
