from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import twrench

PACKAGE = Path(twrench.__file__).parent

USE = """
import numpy as np
import twrench
body: twrench.Body = twrench.Body([twrench.Cylinder(radius=1, length=2, density=3)])
motion = twrench.simulate(body, [1, 0, 0], np.arange(3.0))
x: np.ndarray = motion.X
size: tuple[int, int] = twrench.Scene().size
reveal_type(twrench.Scene().omega)
twrench.simulate(body, [1, 0, 0], [0], step="x")
twrench.Scene().fps = "fast"
"""


def test_mypy_accepts_the_package_and_sees_mistakes_of_its_users(tmp_path):
    pytest.importorskip("mypy")
    mypy = [sys.executable, "-m", "mypy", "--cache-dir", str(tmp_path / "cache")]
    strict = subprocess.run(
        [*mypy, "--strict", "--ignore-missing-imports", str(PACKAGE)], capture_output=True, text=True
    )
    assert strict.returncode == 0, strict.stdout
    file = tmp_path / "use.py"
    file.write_text(USE)
    used = subprocess.run([*mypy, str(file)], capture_output=True, text=True, cwd=PACKAGE.parent)
    errors = [line for line in used.stdout.splitlines() if ": error:" in line]
    assert [line.split(":")[1] for line in errors] == ["9", "10"], used.stdout
    assert "tuple[" in used.stdout.lower() and "float" in used.stdout
