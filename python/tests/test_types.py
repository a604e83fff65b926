"""The package is typed: mypy finds no mistake in it, and the stubs name what the extension has."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import breccia
from breccia import _native
from conftest import ROOT


def test_mypy_finds_no_mistake():
    mypy = "/usr/bin/mypy"
    if not Path(mypy).exists():
        pytest.skip("without mypy")
    checked = subprocess.run([mypy, "--no-incremental", "--cache-dir=/dev/null", "--config-file",
                              ROOT / "pyproject.toml", ROOT / "python" / "breccia"],
                             capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stdout


def members(body):
    return {node.name for node in body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}


def test_stubs_and_extension_have_the_same_names():
    stub = ast.parse((ROOT / "python" / "breccia" / "_native.pyi").read_text())
    real = {name for name in vars(_native) if not name.startswith("_")}
    assert {name for name in members(stub.body) if not name.startswith("_")} == real
    bases = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
    for name, node in bases.items():
        if name.startswith("_"):
            continue
        stubbed = members(node.body) | {member for base in node.bases for member in members(bases[base.id].body)}
        real = {member for member in vars(getattr(_native, name)) if not member.startswith("_")}
        assert {member for member in stubbed if not member.startswith("_")} == real, name


def test_everything_public_has_a_docstring():
    for name in breccia.__all__:
        assert getattr(breccia, name).__doc__, name
