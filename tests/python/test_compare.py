"""``twrench compare --metric ssim`` gives the same number as scikit-image's structural similarity."""

from __future__ import annotations

import json
import os
import re
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

image = pytest.importorskip("PIL.Image")
metrics = pytest.importorskip("skimage.metrics")


def similarity(folder: Path, a: Any, b: Any) -> float:
    """The structural similarity of two arrays of pixels, computed by the program."""
    for name, pixels in (("a.png", a), ("b.png", b)):
        image.fromarray(pixels).save(folder / name)
    command = [os.environ["TWRENCH_PROGRAM"], "compare", "a.png", "b.png"]
    command += ["--metric", "ssim", "--format", "json"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return json.loads(done.stdout)["frames"][0]["ssim"]


def pattern(width: int, height: int, seed: int) -> Any:
    """Pixels that are the same in any language."""
    y, x, c = np.meshgrid(np.arange(height), np.arange(width), np.arange(3), indexing="ij")
    value = 3 * x + 5 * y + 40 * c + (x * y + seed * (x + 2 * y + c)) % (17 + seed)
    return (value % 256).astype(np.uint8)


@pytest.mark.parametrize("channels", [3, 4])
@pytest.mark.parametrize("size", [(7, 7), (64, 48), (301, 97)])
def test_noise(tmp_path, size, channels):
    random = np.random.default_rng(7)
    a = random.integers(0, 256, (size[1], size[0], channels), dtype=np.uint8)
    a[..., 3:] = np.maximum(a[..., 3:], 50)  # colours of invisible pixels do not count
    noise = random.integers(-40, 41, a.shape)
    b = np.clip(a.astype(int) + noise, 0, 255).astype(np.uint8)
    theirs = metrics.structural_similarity(a, b, channel_axis=-1)
    assert similarity(tmp_path, a, b) == pytest.approx(theirs, abs=1e-9)


def test_smooth_pictures_with_a_local_change(tmp_path):
    a = pattern(160, 90, 3)
    b = a.copy()
    b[40:43, 100:120] //= 2
    theirs = metrics.structural_similarity(a, b, channel_axis=-1)
    assert 0.9 < theirs < 0.999
    assert similarity(tmp_path, a, b) == pytest.approx(theirs, abs=1e-9)


def test_the_numbers_of_the_test_in_cpp(tmp_path):
    """tests/image/similarity_test.cpp tests these numbers on machines without scikit-image."""
    source = (Path(__file__).parents[1] / "image/similarity_test.cpp").read_text()
    cases = re.findall(r"\{(\d+), (\d+), (0\.\d{12})\}", source)
    assert len(cases) == 3
    for a, b, similarity in cases:
        one, other = pattern(60, 40, int(a)), pattern(60, 40, int(b))
        theirs = metrics.structural_similarity(one, other, channel_axis=-1)
        assert float(similarity) == pytest.approx(theirs, abs=1e-11)
