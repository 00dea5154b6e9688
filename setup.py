"""Builds the Python module with CMake, for ``pip install .``; pyproject.toml has the rest.

The wheel holds the shared libraries that the module is linked with, all but those that every system
has and those that belong to its drivers: OpenGL is opened at run time.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

PROJECT = Path(__file__).resolve().parent


class BuildWithCMake(build_ext):
    def build_extension(self, extension: Extension) -> None:
        build = PROJECT / "build" / f"wheel-{sys.implementation.cache_tag}"
        package = Path(self.get_ext_fullpath(extension.name)).resolve().parent
        configure = [
            "cmake", "-S", PROJECT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
            "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=0", "-DBUILD_TESTING=OFF",
            "-DTWRENCH_PYTHON=ON", "-DTWRENCH_PYTHON_DIR=.", "-DTWRENCH_BUNDLE_LIBRARIES=ON",
            f"-DPython_EXECUTABLE={sys.executable}",
        ]  # fmt: skip
        install = ["cmake", "--install", build, "--component", "python", "--strip"]
        call(configure)
        call(["cmake", "--build", build, "--target", "twrench_python"])
        call([*install, "--prefix", package.parent])
        # A wheel has no links: it would hold each library twice.
        for link in (package / "libraries").iterdir():
            if link.is_symlink():
                link.resolve().rename(link)


def call(command: list[str | os.PathLike[str]]) -> None:
    try:
        subprocess.run(command, check=True)
    except FileNotFoundError:
        sys.exit(f"twrench: error: {command[0]} is missing; scripts/maintain/setup.sh python installs it")
    except subprocess.CalledProcessError:
        sys.exit("twrench: error: the module could not be built for the reason above")


def project_version() -> str:
    text = (PROJECT / "CMakeLists.txt").read_text()
    match = re.search(r"project\(twrench VERSION ([\d.]+)", text)
    assert match is not None
    return match[1]


def numpy_requirement() -> str:
    """The NumPy that the module can read arrays of: pybind11 knows NumPy 2 from its version 2.12."""
    command = ["pkg-config", "--atleast-version=2.12", "pybind11"]
    try:
        return "numpy" if subprocess.run(command).returncode == 0 else "numpy<2"
    except FileNotFoundError:
        return "numpy"  # the build itself will say what is missing


setup(
    version=project_version(),
    install_requires=[numpy_requirement()],
    ext_modules=[Extension("twrench._native", sources=[])],
    cmdclass={"build_ext": BuildWithCMake},
)
