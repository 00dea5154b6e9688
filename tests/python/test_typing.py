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
twrench.Scene().fps = [24]
"""

#: Calls that a type checker must accept.
RIGHT = """
import numpy as np
import twrench
from twrench import Body, Box, Scene
box = Box(size=(1, 2, 3), density=2, material="brass", position=np.zeros(3))
body = Body([box, twrench.Sphere(radius=1, mass=3), twrench.Mesh(file="a.obj", unit="mm", density=1)])
Body(moments=[1, 2, 3])
Body(inertia=[[1, 0, 0], [0, 2, 0], [0, 0, 3]], shape="cross")
motion = twrench.simulate(body, (1, 0.05, 0), np.linspace(0, 1, 3), "rk4", step=0.1)
twrench.simulate(body, np.array([1, 0, 0]), span=(0, 10), fps=60, attitude=motion.rotation)
twrench.exact(body, [1, 0, 0], attitude=[1, 0, 0, 0]).at([0, 1])
scene = Scene("phone", size=(640, 360), theme="paper", body=body, show={"floor", "hud"})
scene.method = "cf4"
scene.fps = "30000/1001"
checks = twrench.check([motion, motion], body, steps=[0.1, 0.05])
same: twrench.Checks = twrench.check(("a.csv", "b.csv"), body, units="deg")
order: float | None = checks.order.rates
verdict: str = twrench.check("a.csv", body).verdict
finding: str = twrench.check(np.zeros((9, 4)), body, columns=["t", "wx", "wy", "wz"]).finding
twrench.check(motion.to_dataframe(), body, sequence="ZYX")
recording = twrench.Recording.read("a.csv", body, units="deg", inverse=True)
twrench.check([recording, twrench.Recording(motion.t, X=motion.X)], body).order
has_rates: bool = twrench.Recording([0, 1], np.zeros((2, 3))).omega is not None
print(motion[0].X, motion[1:].t, twrench.exact(body, [1, 0, 0]).at(0).omega)
for path in (twrench.pages("site", theme="paper"), twrench.pages("site", template="t.html")):
    print(path.name)
for method in twrench.methods():
    twrench.simulate(body, [1, 0, 0], [0], method.name)
scene.export("a.glb", format="glb", max_angle=1e-3)
passes: bool = twrench.check(motion, body, units="deg").passes
share: float | None = twrench.compare("a", "b", metric="ssim").frames[0].share
scene.render("a.mp4", container="mp4", encode="small", crf=20, progress=lambda done, total: print(done))
scene.render(frames_dir="frames", shard=(1, 4), egl_device="software")
print(scene.simulate(span=(0, 1), fps=4).t.max())
text: str = twrench.check(motion, body, plot="a.svg", time_unit="ns").text
twrench.compare("a", "b").junit.encode()
twrench.study(body, [1, 0, 0], duration=1, attitude=motion.rotation, plot="a.svg")
for path in (twrench.plot("a.svg", ["phone", scene]), twrench.report("a.md", ["phone"], fps=24)):
    print(path.name)
print(twrench.Robot.read("a.urdf").report("a.html", from_mesh=True, overwrite=True).name)
"""

#: Calls that a type checker must reject, one per line.
WRONG = """
import twrench
from twrench import Body, Box, Scene
Scene("phone", sise=(1, 2))
Scene("phone", theme=4)
Scene("phone", theme="dark")
Scene("phone", omega="fast")
Box(size="hello")
Box(size=(1, 2, 3), material="gold")
Box((1, 2, 3), 1)
Body(moments="abc")
twrench.simulate(Body(moments=[1, 2, 3]), [1, 0, 0], [0], "RK4")
twrench.simulate(Body(moments=[1, 2, 3]), [1, 0, 0], [0], attitude="up")
twrench.study(Body(moments=[1, 2, 3]), [1, 0, 0], ["rk5"], duration=1)
Scene().export("a.glb", format="gltf")
twrench.check("a.csv", units="hz")
twrench.compare("a", "b", metric="psnr")
Scene().render("a.mp4", encode="slow")
twrench.check("a.csv", time_unit="days")
twrench.check("a.csv", angle_units="rev")
twrench.Recording.read("a.csv", units="degrees")
twrench.Recording([0, 1], omgea=np.zeros((2, 3)))
twrench.Recording.read("a.csv").omega.shape
Scene().render(frames_dir="frames", shard="1/4")
Scene().render(frames_dir="frames", egl_device="hardware")
twrench.plot("a.svg", [4])
"""


@pytest.fixture(scope="module")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the cache that the runs of mypy share."""
    return tmp_path_factory.mktemp("mypy")


def mypy_errors(folder: Path, cache: Path, text: str) -> list[int]:
    """The numbers of the lines with errors in a program."""
    file = folder / "use.py"
    file.write_text(text)
    command = [sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports"]
    command += ["--cache-dir", str(cache), str(file)]
    output = subprocess.run(command, capture_output=True, text=True, cwd=PACKAGE.parent).stdout
    return sorted({int(line.split(":")[1]) for line in output.splitlines() if ": error:" in line})


def test_mypy_accepts_right_calls_and_rejects_each_wrong_one(tmp_path, cache):
    pytest.importorskip("mypy")
    assert mypy_errors(tmp_path, cache, RIGHT) == []
    assert mypy_errors(tmp_path, cache, WRONG) == list(range(4, len(WRONG.splitlines()) + 1))


def test_mypy_accepts_the_package_and_sees_mistakes_of_its_users(tmp_path, cache):
    pytest.importorskip("mypy")
    mypy = [sys.executable, "-m", "mypy", "--cache-dir", str(cache)]
    mypy.append("--ignore-missing-imports")
    strict = subprocess.run([*mypy, "--strict", str(PACKAGE)], capture_output=True, text=True)
    assert strict.returncode == 0, strict.stdout
    file = tmp_path / "use.py"
    file.write_text(USE)
    used = subprocess.run([*mypy, str(file)], capture_output=True, text=True, cwd=PACKAGE.parent)
    errors = [line for line in used.stdout.splitlines() if ": error:" in line]
    assert [line.split(":")[1] for line in errors] == ["9", "10"], used.stdout
    assert "tuple[" in used.stdout.lower() and "float" in used.stdout
