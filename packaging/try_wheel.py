"""Uses the installed module: try_wheel.py [gl] [ffmpeg]. The arguments are what the system has."""

import sys
import tempfile
from pathlib import Path

import numpy as np
import twrench


def message(error, call):
    """The message of the error that the call must raise."""
    try:
        call()
    except error as raised:
        return str(raised)
    sys.exit(f"{error.__name__} was not raised")


with tempfile.TemporaryDirectory() as folder:
    place = Path(folder)
    scene = twrench.Scene("toutatis", size=(160, 90))
    exact = twrench.exact(scene.body, scene.omega)
    times = np.linspace(0, 0.2, 21) * scene.duration
    motion = twrench.simulate(scene.body, scene.omega, times, "taylor")
    assert np.abs(motion.X - exact.at(times).X).max() < 1e-10
    assert twrench.check(exact.at(times), scene.body).passes
    assert len(twrench.scenes()) > 10 and twrench.cases() and twrench.schema()
    small = twrench.Scene(size=(160, 90), duration=24, fps=2, speed=6)
    assert "<canvas" in small.page(place / "page.html").read_text()
    assert small.export(place / "motion.glb").stat().st_size > 1000
    if "gl" in sys.argv:
        assert scene.frame(0).std() > 1
        assert small.render(frames_dir=place / "film").frame_count == 8
    else:
        print(message(twrench.GlError, lambda: scene.frame(0)))
    if "ffmpeg" in sys.argv:
        assert small.render(place / "film.mp4").path.stat().st_size > 1000
    elif "gl" in sys.argv:
        print(message(twrench.EncoderError, lambda: small.render(place / "film.mp4")))
    print(f"twrench {twrench.__version__} with NumPy {np.__version__} works")
