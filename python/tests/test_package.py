"""The source distribution holds what a build takes, and the package its own files."""

import subprocess
import sys
import tarfile

import pytest

from conftest import ROOT


def tracked(*folders):
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", *folders], capture_output=True, text=True, check=False)
    if listed.returncode != 0:
        pytest.skip("no checkout")
    return set(listed.stdout.splitlines())


def test_source_distribution_is_whole(tmp_path):
    pytest.importorskip("setuptools")
    subprocess.run([sys.executable, "setup.py", "-q", "egg_info", "--egg-base", tmp_path, "sdist", "-d", tmp_path],
                   cwd=ROOT, capture_output=True, check=True)
    with tarfile.open(next(tmp_path.glob("breccia-*.tar.gz"))) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    needed = tracked("CMakeLists.txt", "setup.py", "pyproject.toml", "cmake", "include", "packaging", "src", "package.json",
                     "package-lock.json", ".npmrc", "python/breccia", "python/src", "python/CMakeLists.txt", "python/METADATA.in", "examples/starter.toml", "LICENSE")
    assert needed
    needed |= {f"node_modules/{name}" for name in (
        "plotly.js-basic-dist-min/LICENSE", "plotly.js-basic-dist-min/package.json",
        "plotly.js-basic-dist-min/plotly-basic.min.js", "three/LICENSE", "three/package.json",
        "three/build/three.module.js", "three/build/three.core.js", "three/examples/jsm/controls/OrbitControls.js")}
    assert needed <= names, needed - names


def test_build_lists_every_file_of_the_package():
    listed = (ROOT / "python" / "CMakeLists.txt").read_text()
    for file in tracked("python/breccia", "python/src"):
        if not file.endswith(".hpp"):
            assert file.rpartition("/")[2] in listed, file
