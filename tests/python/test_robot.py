"""Robot descriptions in Python."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import twrench

ARM = """<robot name="arm">
<link name="base"><inertial><mass value="12"/>
<inertia ixx="13" ixy="0" ixz="0" iyy="10" iyz="0" izz="5"/></inertial>
<visual><geometry><box size="1 2 3"/></geometry></visual></link>
<link name="flat"><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="3"/></inertial></link>
<link name="lost"><visual><geometry><mesh filename="none.stl"/></geometry></visual></link>
</robot>
"""


@pytest.fixture
def robot(tmp_path: Path) -> twrench.Robot:
    path = tmp_path / "arm.urdf"
    path.write_text(ARM)
    with pytest.warns(UserWarning, match="a mesh was not found: .*none.stl"):
        return twrench.Robot.read(path)


def test_links_have_the_properties_of_the_file(robot: twrench.Robot) -> None:
    base = robot.links["base"]
    assert (robot.name, robot.format, base.verdict, base.line) == ("arm", "urdf", "good", 2)
    assert base.mass == 12
    np.testing.assert_array_equal(base.inertia, np.diag([13, 10, 5]))
    np.testing.assert_allclose(base.principal_moments, [5, 10, 13])


def test_an_impossible_link_has_its_fault(robot: twrench.Robot) -> None:
    flat = robot.links["flat"]
    assert flat.verdict == "impossible"
    assert flat.faults[0].fault == "triangle"
    assert robot.links["lost"].verdict == "unstated"
    assert "1 impossible" in repr(robot)
    assert "<th" in robot._repr_html_()


def test_a_link_is_a_body_in_grams_and_centimetres(robot: twrench.Robot) -> None:
    body = robot.links["base"].body
    assert body.mass == pytest.approx(12e3, rel=1e-14)
    np.testing.assert_allclose(body.inertia, np.diag([13e7, 10e7, 5e7]), rtol=1e-14)
    scene = twrench.Scene(body=body, omega=(0, 1, 0.01), size=(64, 36))
    assert scene.frame(0).shape[:2] == (36, 64)


def test_a_link_without_mass_properties_is_no_body(robot: twrench.Robot) -> None:
    with pytest.raises(twrench.UsageError, match="link 'lost'.*no mass properties"):
        _ = robot.links["lost"].body


def test_the_repair_changes_only_numbers(robot: twrench.Robot, tmp_path: Path) -> None:
    repaired = robot.repaired()
    assert list(repaired.changes) == ["flat"]
    assert "nearest possible" in repaired.changes["flat"]
    changed = [
        (a, b)
        for a, b in zip(ARM.splitlines(), repaired.text.decode().splitlines())
        if a != b
    ]
    assert len(changed) == 1 and 'izz="' in changed[0][1]
    fixed = tmp_path / "fixed.urdf"
    fixed.write_bytes(repaired.text)
    with pytest.warns(UserWarning):
        assert twrench.Robot.read(fixed).links["flat"].verdict == "good"


def test_the_report_is_a_page_with_pictures(robot: twrench.Robot, tmp_path: Path) -> None:
    file = robot.report(tmp_path / "arm.html")
    page = file.read_text("utf-8")
    assert page.count("<h2>") == 1 and page.count("<img") == 2
    assert "nearest possible moments" in page
    assert robot.report(file, from_mesh=True) == file
    assert "nearest possible moments" not in file.read_text("utf-8")


def test_the_report_replaces_no_other_file(robot: twrench.Robot, tmp_path: Path) -> None:
    with pytest.raises(twrench.UsageError, match="must end in .html"):
        robot.report(tmp_path / "arm.pdf")
    other = tmp_path / "other.html"
    other.write_text("mine")
    with pytest.raises(twrench.OverwriteError):
        robot.report(other)
    assert other.read_text() == "mine"
    robot.report(other, overwrite=True)


def test_messages_name_the_arguments_of_the_module(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    box = '<visual><geometry><mesh filename="package://p/a.stl"/></geometry></visual>'
    inertia = '<inertia ixx="nan" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
    inertial = f'<inertial><mass value="1"/>{inertia}</inertial>'
    path.write_text(f'<robot name="r"><link name="a">{inertial}{box}</link></robot>')
    with pytest.warns(UserWarning, match=r"contains the packages: package_path=\[.DIR.\]$"):
        robot = twrench.Robot.read(path)
    assert "from_mesh=True takes" in robot.repaired().unrepaired["a"]
    with pytest.raises(twrench.UsageError, match=r'package_path=\["none"\]: there is no such'):
        twrench.Robot.read(path, package_path=["none"])


def test_bytes_that_are_no_text_are_escaped(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_bytes(ARM.encode().replace(b"flat", b"fl\xe4t").replace(b"none", b"n\xf6ne"))
    with pytest.warns(UserWarning, match=r"n\\xf6ne.stl"):
        robot = twrench.Robot.read(path)
    assert "fl\\xe4t" in robot.links and list(robot.repaired().changes) == ["fl\\xe4t"]
    assert "fl\\xe4t" in robot.report(tmp_path / "arm.html").read_text("utf-8")


def test_mistakes_are_errors(tmp_path: Path) -> None:
    with pytest.raises(twrench.FileError):
        twrench.Robot.read(tmp_path / "none.urdf")
    path = tmp_path / "bad.urdf"
    path.write_text("<robot><link/></robot>")
    with pytest.raises(twrench.UsageError, match="bad.urdf:1: link"):
        twrench.Robot.read(path)
