"""Checks of recordings in memory: no file is written or opened for them."""

from __future__ import annotations

import gc
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import twrench

BODY = twrench.Body(moments=[2, 3, 4])
NAMES = ["t", "wx", "wy", "wz"]


def rows(count: int = 50, step: float = 0.4) -> np.ndarray:
    motion = twrench.exact(BODY, [0.1, 1, 0.2]).at(step * np.arange(count))
    return np.column_stack([motion.t, motion.omega])


def columns_of(numbers: np.ndarray) -> dict[str, np.ndarray]:
    return dict(zip(NAMES, numbers.T))


@pytest.mark.parametrize(
    "changed",
    [
        np.asfortranarray,
        lambda numbers: np.repeat(numbers, 3, axis=0)[::3],
        lambda numbers: numbers[::-1][::-1],
        lambda numbers: np.broadcast_to(numbers, (2, *numbers.shape))[1],
        lambda numbers: numbers.astype(">f8"),
        lambda numbers: numbers.astype(np.longdouble),
        lambda numbers: np.hstack([numbers, numbers])[:, :4],
    ],
)
def test_the_layout_of_an_array_changes_nothing(changed):
    numbers = rows()
    expected = twrench.check(numbers, BODY, columns=NAMES)
    assert expected.finding == "exact"
    given = changed(numbers)
    before = given.copy()
    given.flags.writeable = False
    for found in (
        twrench.check(given, BODY, columns=NAMES),
        twrench.check(columns_of(given), BODY),
        twrench.check({name: given[:, i].tolist() for i, name in enumerate(NAMES)}, BODY),
    ):
        assert found.text == expected.text and found.details == expected.details
    assert np.array_equal(given, before)


def test_fields_of_a_packed_array_are_read():
    numbers = rows()
    packed = np.empty(len(numbers), dtype=[("flag", "i1"), *((name, "<f8") for name in NAMES)])
    packed["flag"] = 1
    for i, name in enumerate(NAMES):
        packed[name] = numbers[:, i]
    expected = twrench.check(numbers, BODY, columns=NAMES)

    class Frame:
        columns = NAMES

        def __getitem__(self, name):
            return packed[name]

    for data in (packed, Frame()):
        assert twrench.check(data, BODY).rates == expected.rates


@pytest.mark.parametrize(
    ("kind", "precision"), [(np.float32, "float32 (24 bits)"), (np.float16, "float16 (11 bits)")]
)
def test_narrow_numbers_keep_their_resolution(kind, precision):
    numbers = columns_of(rows())
    narrow = {name: column.astype(kind) for name, column in numbers.items() if name != "t"}
    found = twrench.check({"t": numbers["t"], **narrow}, BODY)
    assert f"rates: {precision}" in found.text
    assert found.finding == "exact"


def test_integers_are_numbers():
    constant = {"t": np.arange(5, dtype=np.uint8), "wx": np.ones(5, dtype=np.int64)}
    found = twrench.check({**constant, "wy": [0] * 5, "wz": np.zeros(5, dtype=np.int8)}, BODY)
    assert found.finding == "exact"


def wrong(**changes: Any) -> dict[str, Any]:
    return {**columns_of(rows(6)), **changes}


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (np.empty((0, 4)), "^data: it has no rows$"),
        (np.empty((4, 0)), "^data: must have columns$"),
        (np.zeros(4), r"^data: must be an array of numbers of shape \(n, k\), not an array of shape"),
        (np.zeros((4, 4, 1)), "^data: must be an array of numbers of shape"),
        (rows(6).astype(object), "^data: must be an array of numbers .* and type object$"),
        (wrong(t=[0, 1, 2]), "^data: must have columns of the same length$"),
        (wrong(wx=[]), "^data: must have columns of the same length$"),
        ({name: [] for name in NAMES}, "^data: it has no rows$"),
        (wrong(wx=np.zeros((6, 1))), r"^data\['wx'\]: must be a one-dimensional array of numbers"),
        (wrong(wx=np.array([None] * 6)), r"^data\['wx'\]: must be a one-dimensional array"),
        (wrong(wx=[1, 2, [3]]), r"^data\['wx'\]: must be a one-dimensional array"),
        (wrong(t=[0, 1, 2, 1, 4, 5]),
         "^data: row 4: the column 't': the time 1 is before that of the row before, 2; sort the"),
        (wrong(t=[0, 1, 2, 2, 4, 5]), "^data: row 4: .* remove doubled rows"),
        (wrong(wy=[0, 0, 1e13, 0, 0, 0]), "^data: row 3: the column 'wy': .* beyond the limit"),
        ([wrong(), wrong(t=[0, 1, 2, 1, 4, 5])], r"^data\[1\]: row 4: the column 't'"),
        ({"t": [0, 1], "a": [1, 2]}, "^data: "),
    ],
)  # fmt: skip
def test_wrong_arrays(data, message):
    with pytest.raises(twrench.UsageError, match=message) as caught:
        twrench.check(data, BODY)
    assert "\n" not in str(caught.value) and "/tmp" not in str(caught.value)


def test_arrays_are_released():
    numbers = rows()
    before = sys.getrefcount(numbers)
    twrench.check(numbers, BODY, columns=NAMES)
    gc.collect()
    assert sys.getrefcount(numbers) == before


def calls_about_files(folder: Path, *words: Any) -> str:
    trace = folder / "trace"
    subprocess.run(["strace", "-f", "-e", "trace=file", "-o", trace, *words], check=True)
    return trace.read_text()


needs_strace = pytest.mark.skipif(shutil.which("strace") is None, reason="strace is not installed")


@needs_strace
@pytest.mark.parametrize("options", [[], ["--fit"], ["--units", "deg", "--no-fail"]])
def test_a_file_is_opened_once(tmp_path, options):
    motion = twrench.exact(BODY, [0.1, 1, 0.2]).at(0.4 * np.arange(50))
    file = motion.save(tmp_path / "run.csv")
    words = [os.environ["TWRENCH_PROGRAM"], "check", file, "--inertia", "2,3,4", *options]
    calls = calls_about_files(tmp_path, *words)
    assert len(re.findall(rf'open\w*\(.*?"{re.escape(str(file))}"', calls)) == 1


@needs_strace
def test_no_file_is_opened_for_arrays(tmp_path):
    script = """
import os, numpy as np, twrench
body = twrench.Body(moments=[2, 3, 4])
motion = twrench.exact(body, [0.1, 1, 0.2]).at(np.linspace(0, 20, 50))
table = np.column_stack([motion.t, motion.omega])
def check():
    twrench.check(table, body, columns=["t", "wx", "wy", "wz"], fit=True)
    twrench.check([{"t": motion.t, "wx": -motion.omega[:, 0], "wy": motion.omega[:, 1],
                    "wz": motion.omega[:, 2]}, motion], body)
check()  # the first use loads modules
os.path.exists("/begin")
check()
os.path.exists("/end")
"""
    (calls,) = calls_about_files(tmp_path, sys.executable, "-c", script).split('"/begin"')[1:]
    opened = re.findall(r'(?:open|mkdir|mknod|rename)\w*\(.*?"(.*?)"', calls.split('"/end"')[0])
    assert set(opened) <= {"/sys/devices/system/cpu/online"}  # by std::thread


def test_arrays_of_vectors_and_matrices_are_columns():
    motion = twrench.exact(BODY, [0.1, 1, 0.2]).at(0.05 * np.arange(50))
    arrays = {"time": motion.t, "omega": motion.omega, "X": motion.X}
    found = twrench.check(arrays, BODY)
    assert found.passes and found.attitude is not None
    momentum = twrench.check({"t": motion.t, "L": motion.omega * [2, 3, 4]}, BODY)
    assert momentum.passes


def test_quaternions_in_integers_have_the_precision_of_these():
    motion = twrench.exact(BODY, [0.1, 1, 0.2]).at(0.05 * np.arange(50))
    integers = np.rint(32767 * motion.quaternion_wxyz).astype(np.int16)
    found = twrench.check(
        {"t": motion.t, "omega": motion.omega, "quaternion_wxyz": integers}, BODY
    )
    assert found.passes, found.verdict


def test_a_recording_is_the_motion_that_was_written(tmp_path):
    motion = twrench.exact(BODY, [0.1, 1, 0.2]).at(0.05 * np.arange(50))
    degrees = {f"w{axis} [deg/s]": rates for axis, rates in zip("xyz", np.rad2deg(motion.omega).T)}
    quaternions = dict(zip(("qx", "qy", "qz", "qw"), motion.quaternion_xyzw.T))
    read = twrench.Recording.read({"time_ms": 1e3 * motion.t + 5e4, **degrees, **quaternions})
    assert read.omega is not None and read.X is not None and read.quaternion_wxyz is not None
    np.testing.assert_allclose(read.t, motion.t, atol=1e-10)
    np.testing.assert_allclose(read.omega, motion.omega, atol=1e-14)
    np.testing.assert_allclose(read.X, motion.X, atol=1e-14)
    np.testing.assert_allclose(read.quaternion_wxyz, motion.quaternion_wxyz, atol=1e-14)
    assert read.start == pytest.approx(50) and len(read) == 50
    assert repr(read) == "<twrench.Recording: 50 rows of rates and attitudes, 2.45 s>"
    file = motion.save(tmp_path / "run.csv")
    whole = twrench.Recording.read(file)
    assert np.array_equal(whole.X, motion.X) and np.array_equal(whole.omega, motion.omega)
    assert whole.check(BODY, fit=True).text == twrench.check(file, BODY, fit=True).text


def test_a_recording_of_arrays_is_judged_as_they_are():
    motion = twrench.exact(BODY, [0.1, 1, 0.2]).at(0.05 * np.arange(50))
    for arrays in (
        {"omega": motion.omega},
        {"X": motion.X},
        {"quaternion_wxyz": motion.quaternion_wxyz, "omega": motion.omega},
    ):
        recording = twrench.Recording(motion.t + 3, **arrays)
        assert recording.check(BODY).passes and twrench.check([recording], BODY).passes
        assert (recording.omega is None) == ("omega" not in arrays)
        assert (recording.X is None) == (len(arrays) == 1 and "omega" in arrays)
        assert recording.t[0] == 3
    reversed_term = twrench.Recording(motion.t, omega=-motion.omega[::-1] * [1, 1, -1])
    assert not reversed_term.check(twrench.Body(moments=[2, 3, 4.5])).passes


def test_the_body_decides_how_a_recording_is_read():
    motion = twrench.exact(BODY, [0.1, 1, 0.2]).at(0.05 * np.arange(50))
    scalar_last = {"t": motion.t, "omega": motion.omega}
    scalar_last |= dict(zip(("q0", "q1", "q2", "q3"), motion.quaternion_xyzw.T))
    with pytest.raises(twrench.UsageError, match="2 ways; say which: columns={"):
        twrench.Recording.read(scalar_last)
    with pytest.raises(twrench.UsageError, match="fit as xyzw, space from body: add columns={"):
        twrench.Recording.read(scalar_last, BODY)
    momentum = {"t": motion.t, "L": motion.omega * [2, 3, 4]}
    with pytest.raises(twrench.UsageError, match="give the body"):
        twrench.Recording.read(momentum)
    omega = twrench.Recording.read(momentum, BODY).omega
    np.testing.assert_allclose(omega, motion.omega, rtol=1e-12)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"t": [0, 1, 2]}, "must have omega, X or quaternion_wxyz"),
        ({"t": [0, 1], "omega": np.ones((3, 3))}, r"omega: must be an array of shape \(2, 3\)"),
        ({"t": [0, 1], "X": np.ones((2, 3))}, r"X: must be an array of shape \(2, 3, 3\)"),
        ({"t": [1, 1], "omega": np.ones((2, 3))}, "the time 1 is that of the row before"),
        ({"t": [0, 1], "X": -np.tile(np.eye(3), (2, 1, 1))}, "it is a reflection"),
        ({"t": [0], "X": np.eye(3)[None], "quaternion_wxyz": [[1, 0, 0, 0]]}, "give one of the two"),
        ({"t": [], "omega": np.ones((0, 3))}, "t: must have at least one time"),
    ],
)
def test_wrong_recordings(arguments, message):
    with pytest.raises(twrench.UsageError, match=message):
        twrench.Recording(**arguments)


def test_a_recording_is_read_once():
    recording = twrench.Recording.read(rows(), columns=NAMES, units="deg")
    with pytest.raises(twrench.UsageError, match="units: the recording was read already"):
        twrench.check(recording, BODY, units="rad")
    with pytest.raises(twrench.UsageError, match="read in different ways"):
        twrench.check([recording, twrench.Recording.read(rows(), columns=NAMES)], BODY)
    with pytest.raises(twrench.UsageError, match="read in different ways"):
        twrench.check([columns_of(rows()), recording], BODY)


def test_a_part_of_the_rows_is_judged():
    numbers = rows()
    numbers[:5, 1:] += 0.3
    found = twrench.check(columns_of(numbers), BODY, from_time=2.0, to_time=10.0)
    assert found.rows == 21
    assert found.passes, found.verdict
    with pytest.raises(twrench.UsageError, match="no row is from 30 to 40 s"):
        twrench.check(columns_of(numbers), BODY, from_time=30.0, to_time=40.0)


def test_the_flight_of_a_toss_is_found():
    """Between the hand, which starts and stops the rotation, and within the noise."""
    sides = np.array([7.2, 15.0, 0.8])
    moments = np.sum(sides**2) - sides**2
    ratios = np.sort(moments) / min(moments)
    t = np.arange(520) / 200
    hand = np.clip(np.minimum(t / 0.8, (2.6 - t) / 0.6), 0, 1)
    wrong = []
    for seed in range(20):
        random = np.random.default_rng(seed)
        start = [random.uniform(6, 10), random.uniform(0.2, 0.5), random.uniform(-0.4, 0.4)]
        omega = twrench.exact(twrench.Body(moments=moments), start).at(np.clip(t - 0.8, 0, 1.2)).omega
        noisy = omega * hand[:, None] + random.normal(0, 0.02, omega.shape)
        toss = {"t": t, "wx": noisy[:, 0], "wy": noisy[:, 1], "wz": noisy[:, 2]}
        for range_of in ({}, {"from_time": 0.7}):
            try:
                text = twrench.check(toss, fit="inertia", **range_of).verdict
            except twrench.Error as error:
                text = str(error)
            named = re.search(r"within their noise: from_time=([\d.]+) to_time=([\d.]+)", text)
            begin, end = map(float, named.groups()) if named else (0.0, 0.0)
            is_right = begin > 0.75 and end < 2.05 and end - begin > 0.9
            if is_right:
                found = twrench.check(toss, fit="inertia", from_time=begin, to_time=end)
                errors = np.abs(found.inertia.moments - ratios)
                is_right = found.finding == "noise" and np.all(errors <= 4 * found.inertia.deviations + 1e-4)
            if not is_right:
                wrong.append((seed, text))
    assert len(wrong) <= 1, wrong


def test_the_inertia_is_fitted_to_the_rates():
    found = twrench.check(columns_of(rows(200)), fit="inertia")
    assert found.passes, found.verdict
    np.testing.assert_allclose(found.inertia.moments, [1, 1.5, 2], atol=1e-9)
    np.testing.assert_allclose(found.inertia.matrix, np.diag([1, 1.5, 2]), atol=1e-9)
    assert np.all(found.inertia.deviations < 1e-9)
    assert twrench.check(columns_of(rows()), BODY).inertia is None
    with pytest.raises(twrench.UsageError, match="finds the body"):
        twrench.check(columns_of(rows()), BODY, fit="inertia")
    with pytest.raises(twrench.UsageError, match="must be True, False or 'inertia'"):
        twrench.check(columns_of(rows()), fit="moments")
    steady = {"t": np.arange(20.0), "wx": np.zeros(20), "wy": np.zeros(20), "wz": np.ones(20)}
    with pytest.raises(twrench.Error, match="does not determine the ratios"):
        twrench.check(steady, fit="inertia")
