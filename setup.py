"""Builds the extension of the Python module by CMake, with the library inside it; pyproject.toml says the rest.

It takes the packages of scripts/install-dependencies, and no network: pip install --no-build-isolation --no-index .
Further settings of CMake are taken from CMAKE_ARGS, another directory for the build from BRECCIA_BUILD_DIRECTORY.
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

ROOT = Path(__file__).parent.absolute()


class CMakeBuild(build_ext):
    """Configures and builds one target, and takes its module."""

    def build_extension(self, extension: Extension) -> None:
        build = Path(os.environ.get("BRECCIA_BUILD_DIRECTORY", self.build_temp)).absolute()
        settings = {
            "BRECCIA_PYTHON": "ON",
            "BRECCIA_BUILD_TESTS": "OFF",
            "BUILD_SHARED_LIBS": "OFF",
            "CMAKE_BUILD_TYPE": "Release",
            "CMAKE_UNITY_BUILD": "ON",
            "Python_EXECUTABLE": sys.executable,
        }
        definitions = [f"-D{name}={value}" for name, value in settings.items()]
        definitions += shlex.split(os.environ.get("CMAKE_ARGS", ""))
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *definitions], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "breccia_python"], check=True)
        module = Path(self.get_ext_fullpath(extension.name))
        module.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(next((build / "python" / "breccia").glob("_native.*.so")), module)


class SourceDistribution(sdist):
    """Takes the packages of npm along, so that a build from it needs no network."""

    def run(self) -> None:
        if not (ROOT / "node_modules" / "three").is_dir():
            sys.exit("node_modules is missing; scripts/install-dependencies fetches it")
        super().run()


version = re.search(r"project\(breccia VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
setup(version=version, ext_modules=[Extension("breccia._native", sources=[])],
      cmdclass={"build_ext": CMakeBuild, "sdist": SourceDistribution})
