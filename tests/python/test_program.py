"""The module offers each command of the program, with the same results."""

from __future__ import annotations

import ast
import inspect
import json
import math
import re
import sys
import warnings
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest

import twrench
from twrench import Scene

#: The counterpart of each command in the module.
COUNTERPARTS: dict[str, Callable[..., Any] | type] = {
    "render": Scene.render,
    "simulate": Scene.simulate,
    "export": Scene.export,
    "page": Scene.page,
    "report": Scene.report,
    "plot": Scene.plot,
    "inertia": twrench.Body,
    "study": twrench.study,
    "encode": twrench.encode,
    "compare": twrench.compare,
    "check": twrench.check,
    "methods": twrench.methods,
    "scenes": twrench.scenes,
    "cases": twrench.cases,
    "schema": twrench.schema,
}
#: Options whose arguments have another name.
RENAMED = {
    "--output": "path",
    "--frame": "camera_frame",
    "--from": "from_time",
    "--to": "to_time",
}
#: Options that no argument is named after, and the reason. Some are those of one command alone.
WITHOUT_ARGUMENT = {
    "--help": "help() shows the documentation",
    "--help-all": "help() shows the documentation",
    "--inertia": "Body(inertia=...) and Body(moments=...) are bodies",
    "--shape": "Body(shape=...)",
    "--bare": "show=() shows only the body",
    "--hide": "show is the set of all overlays",
    "--no-chapters": "chapters=False",
    "--no-video": "render writes a video if it has a path",
    "--no-frames": "render writes frames if it has a folder",
    "--no-fail": "check returns the verdict",
    "--timing": "it measures the program",
    "--all": "twrench.pages",
    "--link": "Robot.read(path).links",
    "--package-path": "Robot.read(path, package_path=...)",
    "check --scene": "body, as in check(file, Scene(...).body)",
    "check --format": "Check has details, text and junit",
    "check --output": "check returns the result",
    "compare --format": "Comparison has frames, text and junit",
    "cases --format": "case() returns the document of JSON",
    "cases --output": "case() returns the document",
    "cases --overwrite": "case() returns the document",
    "inertia --about": "Body.inertia_about",
    "inertia --fix": "Robot.repaired",
    "inertia --from-mesh": "Robot.repaired(from_mesh=...)",
    "inertia --format": "Body has attributes",
    "inertia --report": "Robot.report",
    "inertia --output": "Body has attributes",
    "inertia --overwrite": "Body has attributes",
    "inertia --si": "Body.si",
    "schema --output": "schema() returns the schema",
    "schema --overwrite": "schema() returns the schema",
    "simulate --format": "Motion.save writes CSV, Scene.export also JSON",
    "simulate --output": "Motion.save",
    "simulate --overwrite": "Motion.save",
    "study --format": "Study is data, and to_dataframe() a table",
    "study --output": "study returns the results",
    "study --max-error": "StudyRun.error",
    "study --max-energy-drift": "StudyRun.energy_drift",
    "study --max-flip-error": "StudyRun.flip_error",
}
#: A recording's own options, in the commands that show one.
OF_RECORDINGS = {
    "--from": "a part of the arrays of a Recording",
    "--to": "a part of the arrays of a Recording",
}
OF_RECORDINGS |= dict.fromkeys(
    "--columns --time-unit --units --angle-units --sequence --inverse --rates --axes --offset".split(),
    "Recording.read(...), as in Scene(motion=recording)",
)
WITHOUT_ARGUMENT |= {
    f"{command} {option}": reason
    for command in ("render", "simulate", "export", "page", "plot")
    for option, reason in OF_RECORDINGS.items()
}
#: A recording that can be checked.
GOOD = {"t": [0, 1, 2, 3], "wx": 4 * [1], "wy": 4 * [0], "wz": 4 * [0]}
#: Commands about the program and its machine, which have no counterpart.
OF_THE_PROGRAM = {"doctor", "help"}


def test_every_command_has_a_counterpart(program):
    listed = program("--help").split("Commands:")[1].split("Exit codes:")[0]
    commands = set(re.findall(r"^  ([a-z]+)", listed, re.MULTILINE))
    assert "render" in commands
    assert commands == set(COUNTERPARTS) | OF_THE_PROGRAM


def options_of(program: Callable[..., str], command: str) -> set[str]:
    text = program(command, "--help")
    if "--help-all" in text:
        text = program(command, "--help-all")
    return set(re.findall(r"^  (?:-[a-z],)?(--[a-z-]+)", text, re.MULTILINE))


def arguments_of(program: Callable[..., str], command: str) -> set[str]:
    """The arguments of the counterpart, and those of the scene that a command reads."""
    names = set(inspect.signature(COUNTERPARTS[command]).parameters)
    if "[SCENE" in program(command, "--help"):
        names |= set(inspect.signature(Scene).parameters)
    return names


def test_every_option_has_a_counterpart(program):
    reasons = set()
    for command in COUNTERPARTS:
        options, arguments = options_of(program, command), arguments_of(program, command)
        assert "--help" in options
        for option in options:
            name = option[2:].replace("-", "_")
            if name in arguments or RENAMED.get(option) in arguments:
                continue
            reason = option if option in WITHOUT_ARGUMENT else f"{command} {option}"
            assert reason in WITHOUT_ARGUMENT, f"{command} has {option}, which Python lacks"
            reasons.add(reason)
    assert reasons == set(WITHOUT_ARGUMENT), "a reason is for an option that has a counterpart"


def test_the_schema_is_that_of_the_program(program):
    assert twrench.schema() == json.loads(program("schema"))


@pytest.mark.parametrize("name", twrench.scenes())
def test_samples_are_those_of_the_program(program, tmp_path, name):
    scene, options = Scene(name, method="rkmk4", fps=10), [name, "--method", "rkmk4", "--fps", 10]
    if name not in ("explain", "explain-nb", "explain-short", "explorer-1"):  # their shots have their own durations
        scene.duration = 5
        options += ["--duration", 5]
    assert scene.export(tmp_path / "a.csv") == tmp_path / "a.csv"
    assert (tmp_path / "a.csv").read_text() == program("simulate", *options)
    scene.export(tmp_path / "out", format="json")
    assert (tmp_path / "out").read_text() == program("simulate", *options, "--format", "json")


def test_an_animation_and_an_ephemeris_are_those_of_the_program(program, tmp_path):
    for ending in ("glb", "py", "aem"):
        mine, theirs = tmp_path / f"mine.{ending}", tmp_path / f"theirs.{ending}"
        Scene("stable-y").export(mine, max_angle=1e-3, epoch="2026-02-03T04:05:06")
        options = ["--max-angle", 1e-3, "--epoch", "2026-02-03T04:05:06"]
        program("export", "stable-y", "-o", theirs, *options)
        assert mine.read_bytes() == theirs.read_bytes()


@pytest.mark.parametrize(("lab", "options"), [(False, []), (True, ["--lab"])])
def test_a_page_is_that_of_the_program(program, tmp_path, template, lab, options):
    mine, theirs = tmp_path / "mine.html", tmp_path / "theirs.html"
    Scene("stable-y", omega=(0, 2, 0.5)).page(mine, lab=lab, template=template)
    words = ["--omega", "0,2,0.5", "--template", template, *options]
    program("page", "stable-y", *words, "-o", theirs)
    assert mine.read_bytes() == theirs.read_bytes()


def test_a_page_in_norwegian_is_that_of_the_program(program, tmp_path, template):
    mine, theirs = tmp_path / "mine.html", tmp_path / "theirs.html"
    Scene("explain", language="nb").page(mine, lab=True, template=template)
    program("page", "explain", "--language", "nb", "--lab", "--template", template, "-o", theirs)
    assert mine.read_bytes() == theirs.read_bytes()


def test_the_pages_of_all_scenes_are_as_of_the_program(program, tmp_path, template, monkeypatch):
    mine, theirs = tmp_path / "new" / "mine", tmp_path / "theirs.html"
    few = ["dzhanibekov", "wing-nut", "explain"]  # the others take the same paths
    monkeypatch.setattr("twrench.site.scenes", lambda: few)
    index = twrench.pages(mine, template=template, theme="paper", size=(160, 90))
    assert index == mine / "index.html"
    assert {file.stem for file in mine.iterdir()} == {"index", *few}
    for name in few:
        program("page", name, "--theme", "paper", "--size", "160x90", "--template", template, "-o", theirs)
        assert (mine / f"{name}.html").read_bytes() == theirs.read_bytes(), name
    with pytest.raises(twrench.FileError, match="template.html"):
        twrench.pages(template, template=template)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["new", "template.html", "theirs.html"]


def without_times(content: bytes) -> str:
    """The report without the processor times, which vary: the last cells of rows, and their plot."""
    text = content.decode()
    text = re.sub(r"<svg.*?</svg>", lambda svg: "" if "CPU" in svg[0] else svg[0], text, flags=re.S)
    return re.sub(r"(<td>[^<]*</td></tr>|\| [^|]* \|)$", "", text, flags=re.MULTILINE)


@pytest.mark.parametrize("ending", ["html", "md"])
def test_a_report_is_that_of_the_program(program, tmp_path, monkeypatch, ending):
    monkeypatch.chdir(tmp_path)
    file = f"report.{ending}"
    scene = Scene("stable-y", omega=(0, 2, 0.5), duration=6, method="cf4")
    scene.report(file, author="A. Student", date="today", static=True)
    mine = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    for name in mine:
        (tmp_path / name).unlink()
    options = ["--omega", "0,2,0.5", "--method", "cf4", "--duration", 6]
    named = ["--author", "A. Student", "--date", "today"]
    program("report", "stable-y", *options, *named, "--static", "-o", file)
    theirs = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert mine.keys() == theirs.keys() and len(mine) >= (1 if ending == "html" else 2)

    assert b"CPU" in mine[file] and len(without_times(mine[file])) > 0.3 * len(mine[file])
    for name, content in mine.items():
        assert without_times(content) == without_times(theirs[name])
    assert b"twrench report stable-y --omega 0,2,0.5" in mine[file]


def test_a_plot_is_that_of_the_program(program, tmp_path):
    scene = Scene("stable-y")
    for overlay in ([], ["--overlay"]):
        mine, theirs = tmp_path / "mine.svg", tmp_path / "theirs.svg"
        scene.plot(mine, overlay=bool(overlay))
        program("plot", "stable-y", *overlay, "-o", theirs)
        assert mine.read_bytes() == theirs.read_bytes()


def test_several_scenes_are_plotted_and_reported_as_by_the_program(program, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = ["stable-y", "stable-z"]
    assert twrench.plot("a.svg", [names[0], Scene(names[1])], overlay=True) == Path("a.svg")
    program("plot", *names, "--overlay", "-o", "b.svg")
    assert Path("a.svg").read_bytes() == Path("b.svg").read_bytes()
    for scenes, words, values in (
        (names, names, {"duration": 6, "method": "cf4"}),
        (None, [], {"language": "nb"}),
    ):
        options = [f"--{key}={value}" for key, value in values.items()]
        twrench.report("r.md", scenes, author="A. Student", **values)
        mine = Path("r.md").read_bytes()
        program("report", *words, *options, "--author", "A. Student", "-o", "r.md")
        assert without_times(mine) == without_times(Path("r.md").read_bytes())
    assert "Kulen roterer om x" in Path("r.md").read_text()  # a task of the course, in Norwegian
    for call, message in (
        (lambda: twrench.plot("no.svg", []), "^scenes: must have at least one scene"),
        (lambda: twrench.plot("no.svg", "sphere"), "^scenes: must be a list of scenes"),
        (lambda: twrench.plot("no.svg", [3]), "^scenes: must be a path, not 3"),
        (lambda: twrench.plot("no.txt", names), r"no.txt.*\.svg"),
        (lambda: twrench.report("no.md", []), "^scenes: must have at least one scene"),
        (lambda: twrench.report("no.md", names[0]), "^scenes: must be a list of names"),
        (lambda: twrench.report("no.md", method="rk4"), "^method: is for scenes, and the tasks"),
        (lambda: twrench.report("no.md", names, sise=3), "sise"),
    ):
        with pytest.raises(twrench.UsageError, match=message):
            call()
    assert not list(tmp_path.glob("no*"))


def test_a_plot_is_a_figure_or_else_the_text_of_a_drawing(monkeypatch):
    figure_module = pytest.importorskip("matplotlib.figure")
    scene = Scene("stable-y")
    figure = scene.plot()
    assert isinstance(figure, figure_module.Figure)
    assert len(figure.axes) == 9 and len(scene.plot(overlay=True).axes) == 3
    (line, *flips) = figure.axes[4].lines
    exact = twrench.exact(scene.body, scene.omega).at(line.get_xdata())
    assert np.abs(line.get_ydata() - exact.X[:, 1, 1]).max() < 1e-6
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    assert scene.plot().startswith("<?xml") and "<svg" in scene.plot()


def test_a_check_is_that_of_the_program(program, tmp_path):
    body = twrench.Body(moments=[2, 3, 4])
    motion = twrench.simulate(body, [0.1, 1, 0.2], np.linspace(0, 20, 201), "rk4", step=0.02)
    file = motion.save(tmp_path / "run.csv")
    options = [file, "--inertia", "2,3,4", "--no-fail", "--format", "json"]
    found = twrench.check(file, body)
    assert found.details == json.loads(program("check", *options))
    assert not found.passes and found.finding == "integration" and found.rows == 201
    assert found.rates is not None and found.rates.max_error > 1e-6 and found.rates.unit == "rad/s"
    assert found.text == program("check", *options[:-2])
    assert found.junit == program("check", *options[:-1], "junit")
    bound = twrench.check(file, body, max_rate_error=1)
    assert bound.passes
    expected = json.loads(program("check", *options, "--max-rate-error", 1))
    assert expected["bounds"][0].pop("option") == "--max-rate-error"
    assert bound.details["bounds"][0].pop("option") == "max_rate_error"
    assert bound.details == expected


def test_the_order_of_several_recordings_is_that_of_the_program(program, tmp_path):
    body = twrench.Body(moments=[2, 3, 4])
    steps = [0.04, 0.02, 0.01]
    motions, files = [], []
    for h in steps:
        times = h * np.arange(round(8 / h) + 1)
        motions.append(twrench.simulate(body, [0.1, 1, 0.2], times, "rkmk4", step=h))
        files.append(motions[-1].save(tmp_path / f"{h}.csv"))
    options = ["--inertia", "2,3,4", "--no-fail", "--format", "json"]
    expected = json.loads(program("check", *files, *options))
    found = twrench.check(files, body)
    assert isinstance(found, twrench.Checks) and not found.passes
    assert found.text == program("check", *files, *options[:-2])
    assert found.junit == program("check", *files, *options[:-1], "junit")
    assert found.files[1].text == twrench.check(files[1], body).text
    assert [of.details for of in found.files] == expected["files"]
    assert vars(found.order) == expected["order"]
    assert found.order.rates == pytest.approx(4, abs=0.1) and found.order.why_not is None
    for mixed in (tuple(motions), [files[0], motions[1], files[2]]):
        of_arrays = twrench.check(mixed, body)
        assert of_arrays.order.attitude == pytest.approx(found.order.attitude, rel=1e-6)
    assert [of.details["file"] for of in of_arrays.files] == [str(files[0]), "data[1]", str(files[2])]
    assert "data[1]" in of_arrays.text and 'testsuite name="data[1]"' in of_arrays.junit
    doubled = twrench.check(files, body, steps=[0.4, 0.2, 0.1], max_rate_error=1)
    assert doubled.passes and doubled.order.rates == pytest.approx(found.order.rates)
    assert [of.details["step"] for of in doubled.files] == [0.4, 0.2, 0.1]
    same = twrench.check([motions[0], motions[0]], body)
    assert same.order.rates is None and "same time between rows" in same.order.why_not
    (alone,) = twrench.check([motions[0]], body).files
    assert alone.rates == twrench.check(motions[0], body).rates


def test_plots_of_checks_and_studies_are_those_of_the_program(program, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    body = twrench.Body(moments=[2, 3, 4])
    motion = twrench.simulate(body, [0.1, 1, 0.2], np.linspace(0, 20, 201), "rk4", step=0.02)
    file = motion.save("run.csv")
    twrench.check(file, body, plot="mine.svg")
    program("check", file, "--inertia", "2,3,4", "--no-fail", "--plot", "theirs.svg")
    assert Path("mine.svg").read_bytes() == Path("theirs.svg").read_bytes()
    twrench.check([file, motion], body, plot="both.svg")
    assert "data[1]" in Path("both.svg").read_text()
    twrench.study(body, [0.1, 1, 0.2], ["rk4", "exact"], duration=5, plot="study.svg")
    assert ">rk4<" in Path("study.svg").read_text()
    with pytest.raises(twrench.UsageError, match="^plot: the exact method alone"):
        twrench.study(body, [0.1, 1, 0.2], ["exact"], duration=5, plot="no.svg")
    with pytest.raises(twrench.UsageError, match=r"no.txt.*\.svg"):
        twrench.study(body, [0.1, 1, 0.2], duration=5, plot="no.txt")
    with pytest.raises(twrench.UsageError, match=r"no.txt.*\.svg"):
        twrench.check(motion, body, plot="no.txt")
    with pytest.raises(twrench.FileError, match="run.csv"):
        twrench.check(file, body, plot=file)
    assert not list(tmp_path.glob("no.*"))


def test_a_study_has_all_methods_that_can_compute_the_motion():
    body, omega, ladder = twrench.Body(moments=[1, 2, 3]), [0.1, 1, 0], {"steps": [0.1, 0.05]}
    names = [method.name for method in twrench.methods()]
    study = twrench.study(body, omega, duration=1, tolerances=[1e-6], **ladder)
    assert list(study.methods) == names
    damped = twrench.study(
        body, omega, duration=1, tolerances=[1e-6], energy_loss_time=5, **ladder
    )
    assert list(damped.methods) == [name for name in names if name != "exact"]
    turned = twrench.study(
        body, omega, ["rkmk4"], duration=1, attitude=[0.5, 0.5, 0.5, 0.5], **ladder
    )
    plain = study.methods["rkmk4"].runs[0].error
    assert turned.methods["rkmk4"].runs[0].error == pytest.approx(plain, rel=1e-3)


@pytest.mark.parametrize(
    ("data", "arguments", "message"),
    [
        ([], {}, "^data: must have at least one recording"),
        ([{"t": [0, 1], "wx": [1]}], {}, r"^data\[0\]: must have columns of the same length"),
        ([GOOD, {"t": [0], "wx": ["a"]}], {}, r"^data\[1\]\['wx'\]: must be a one-dim"),
        ([GOOD, {**GOOD, "t": [0, 1, 1, 3]}], {}, r"^data\[1\].*the time 1 is that of the row before"),
        ([GOOD, 3], {}, r"^data\[1\]: must be a path, not 3"),
        ([GOOD, GOOD], {"steps": [1]}, "^steps: has 1 step sizes for 2 recordings"),
        ([GOOD, GOOD], {"steps": [1, -1]}, "^steps: is -1, but must be"),
        (GOOD, {"steps": 1}, "^steps: must be step sizes"),
    ],
)
def test_wrong_checks_of_several_recordings(data, arguments, message):
    with pytest.raises(twrench.Error, match=message):
        twrench.check(data, twrench.Body(moments=[2, 3, 4]), **arguments)


def test_arrays_are_checked_without_loss():
    for scale in (1e-6, 1, 1e6):  # the size of the body
        body = twrench.Body(moments=scale**5 * np.array([2, 3, 4]))
        motion = twrench.exact(body, [0.1, 1, 0.2]).at(np.linspace(0, 20, 50))
        assert twrench.check(motion, body).finding == "exact"
        wx, wy, wz = np.rad2deg(motion.omega.T)
        columns = {"t": motion.t[::2], "wx": wx[::2], "wy": wy[::2], "wz": wz[::2]}
        found = twrench.check(columns, body, units="deg")
        assert found.finding == "exact" and found.attitude is None


def test_a_published_case_is_checked():
    case = twrench.case("basilisk-spacecraft")
    body = twrench.Body(moments=case["inertia"])
    motion = twrench.exact(body, case["omega"]).at(np.linspace(0, 10, 20))
    assert twrench.check(motion, case="basilisk-spacecraft").passes
    with pytest.raises(twrench.UsageError, match="case: gives the body"):
        twrench.check(motion, body, case="basilisk-spacecraft")


@pytest.mark.parametrize(
    ("data", "arguments", "message"),
    [
        ({"t": [0, 1], "wx": [1, 1], "wy": [0, 0], "wz": [0, 0]}, {"units": "hz"}, "^units: unknown"),
        ({"t": [0, 1], "wx": [1, 1], "wy": [0, 0], "wz": [0, 0]}, {"rates": "world"}, "^rates: unk"),
        ({"t": [0, 1], "wx": [1, 1], "wy": [0, 0], "wz": [0, 0]}, {"frame": "last"}, "^frame: unk"),
        ({"t": [0, 1], "wx": [1]}, {}, "data: must have columns of the same length"),
        ({"t": [0, 1], "wx": [1, math.nan]}, {}, r"data\['wx'\]: must be finite"),
        ({"t": [0, 1], "wx": "ab"}, {}, r"data\['wx'\]: must be a one-dimensional array"),
        ({"t": [0, 1, 2, 3], "wx": 4 * [1], "wy": 4 * [0], "wz": 4 * [0]},
         {"max_attitude_error": 1}, "^max_attitude_error: data has no attitude"),
        ({"t": [0, 1], "wx": [1, 1], "wy": [0, 0], "wz": [0, 0]}, {}, "^data: has 2 rows, too few"),
        ({"t": [0, 1], "wx": [1, 1], "wy": [0, 0], "wz": [0, 0]},
         {"max_rate_error": -1}, "^max_rate_error"),
        ({"t": [0, 1], "wx": [1, 1], "wy": [0, 0], "wz": [0, 0]}, {"offset": [1, 2]}, "^offset"),
        ({"t": [0, 1], "wx": [1, 1], "wy": [0, 0], "wz": [0, 0]}, {"omega": [1]}, "^omega"),
    ],
)  # fmt: skip
def test_wrong_checks(data, arguments, message):
    with pytest.raises(twrench.UsageError, match=message):
        twrench.check(data, twrench.Body(moments=[2, 3, 4]), **arguments)


def test_files_that_cannot_be_checked(tmp_path):
    body = twrench.Body(moments=[2, 3, 4])
    with pytest.raises(twrench.FileError, match="none.csv"):
        twrench.check(tmp_path / "none.csv", body)
    with pytest.raises(twrench.UsageError, match="body: must be a twrench.Body"):
        twrench.check(tmp_path / "none.csv")


def test_a_comparison_is_that_of_the_program(small, program, tmp_path):
    a, b = tmp_path / "a.png", tmp_path / "b.png"
    a.write_bytes(small.png(3))
    b.write_bytes(small.png(4))
    assert twrench.compare(a, a)
    found = twrench.compare(a, b, diff=tmp_path / "d.png", report=tmp_path / "r.html")
    (frame,) = found.frames
    assert not found and frame.outcome == "different"
    difference = np.abs(small.frame(3).astype(int) - small.frame(4))
    assert frame.max_difference == difference.max()
    assert frame.mean_difference == pytest.approx(difference.mean())
    assert frame.share == pytest.approx((difference.max(axis=2) > 0).mean())
    assert (tmp_path / "d.png").read_bytes().startswith(b"\x89PNG")
    assert found.text.startswith("different") and "b.png" in found.junit
    assert twrench.compare(a, a).text == program("compare", a, a)
    assert twrench.compare(a, a).junit == program("compare", a, a, "--format", "junit")
    assert "<html" in (tmp_path / "r.html").read_text()
    assert twrench.compare(a, a).frames[0].notes == []
    assert twrench.compare(a, b, share=1)
    assert twrench.compare(a, b, metric="ssim", min_ssim=-1).frames[0].ssim is not None
    twrench.compare(a, b, update=True)
    assert a.read_bytes() == b.read_bytes()
    for arguments, message in (
        ({"metric": "psnr"}, "^metric: unknown name 'psnr'"),
        ({"ignore": [(0, 0, 1)]}, "^ignore: must be rectangles"),
        ({"ignore": [(0, 0, 1000, 1)]}, "rectangle|ignore|within"),
        ({"share": 2}, "^share: must be from 0 to 1"),
    ):
        with pytest.raises(twrench.UsageError, match=message):
            twrench.compare(a, b, **arguments)
    with pytest.raises(twrench.UsageError, match="a folder"):
        twrench.compare(tmp_path, b)
    with pytest.raises(twrench.FileError, match="none.png"):
        twrench.compare(tmp_path / "none.png", b)


def test_frames_are_encoded_as_by_the_program(small, program, tmp_path):
    small.render(frames_dir=tmp_path / "frames")
    film = twrench.encode(tmp_path / "frames", tmp_path / "mine.mp4")
    assert film.frame_count == 24 and film.path == tmp_path / "mine.mp4"
    program("encode", tmp_path / "frames", "-o", tmp_path / "theirs.mp4")
    assert film.path.read_bytes() == (tmp_path / "theirs.mp4").read_bytes()
    with pytest.raises(twrench.UsageError, match="^width"):
        twrench.encode(tmp_path / "frames", tmp_path / "b.mp4", width=64)
    with pytest.raises(twrench.FileError):
        twrench.encode(tmp_path / "none", tmp_path / "b.mp4")


def test_outputs_do_not_replace_inputs(tmp_path, template):
    file = tmp_path / "mine.toml"
    file.write_text("[body]\nmoments = [1, 2, 3]\n")
    scene = Scene(file)
    for write in (scene.page, scene.report, scene.export, scene.plot):
        with pytest.raises(twrench.FileError, match="mine.toml"):
            write(file)
    with pytest.raises(twrench.UsageError, match=r"must end in \.glb"):
        scene.export(tmp_path / "a.xyz")
    with pytest.raises(twrench.UsageError, match="must end in .html or .md"):
        scene.report(tmp_path / "a.pdf")
    with pytest.raises(twrench.FileError, match="No such file"):
        scene.export(tmp_path / "none" / "a.csv")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["mine.toml", "template.html"]


def test_names_of_columns(tmp_path):
    body = twrench.Body(moments=[2, 3, 4])
    rates = {key: GOOD[key] for key in ("wx", "wy", "wz")}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for name in ('a"b,=', '"', "a\nb", "\u03c9", " t "):
            found = twrench.check({name: GOOD["t"], **rates}, body, columns={"t": name})
            assert found.finding == "exact"
    with pytest.raises(twrench.UsageError, match="^data: has a column without a name"):
        twrench.check({"": GOOD["t"], **GOOD}, body)


def test_a_motion_that_is_not_of_a_rigid_body_is_not_checked():
    body = twrench.Body(moments=[2, 3, 4])
    for interior in ({"wheel": [0, 0, 1]}, {"energy_loss_time": 50}):
        motion = twrench.simulate(body, [0.1, 1, 0.2], np.linspace(0, 5, 20), **interior)
        with pytest.raises(twrench.UsageError, match=r"^data\[1\]: a check needs the closed form"):
            twrench.check([GOOD, motion], body)


def test_a_bound_on_the_metric_that_does_not_decide_is_refused(tmp_path):
    for arguments in ({"metric": "ssim", "share": 0.5}, {"min_ssim": 0.5}):
        with pytest.raises(twrench.UsageError, match="bounds the metric"):
            twrench.compare(tmp_path, tmp_path, **arguments)


class Frame:
    """A table with named columns, like a DataFrame of pandas."""

    def __init__(self, columns):
        self._columns, self.columns = columns, list(columns)

    def __getitem__(self, name):
        return self._columns[name]


def test_arrays_and_data_frames_are_checked():
    body = twrench.Body(moments=[2, 3, 4])
    motion = twrench.exact(body, [0.1, 1, 0.2]).at(np.linspace(0, 20, 50))
    numbers = np.column_stack([motion.t, motion.omega])
    names = ["t", "wx", "wy", "wz"]
    expected = twrench.check(dict(zip(names, numbers.T)), body)
    assert expected.finding == "exact"
    structured = np.rec.fromarrays(numbers.T, names=",".join(names))
    labels = np.array(50 * ["a"])
    unused = Frame({**dict(zip(names, numbers.T)), "label": labels, "gap": np.full(50, math.nan)})
    found = [
        twrench.check(numbers, body, columns=names),
        twrench.check(numbers, body),  # as a file without names
        twrench.check(numbers, body, columns={"t": "#1", "wx": "#2", "wy": "#3", "wz": "#4"}),
        twrench.check(structured, body),
        twrench.check(unused, body),
        *twrench.check([numbers, numbers], body, columns=names).files,
    ]
    assert all(each.rates == expected.rates for each in found)
    assert twrench.check(numbers[:, [1, 2, 3, 0]], body, columns=["wx", "wy", "wz", "t"]).passes
    for data, columns, message in (
        (numbers, names[:3], "^columns: must be 4 different names for the columns of data"),
        (numbers, ["t", "wx", "wy", "wy"], "^columns: must be 4 different names"),
        (numbers, "twxy", "^columns: must be a mapping or a list"),
        (numbers[0], names, r"^data: must be an array of numbers of shape \(n, k\)"),
        (unused, names, "^columns: must be a mapping of our names to those of data"),
        (Frame({"t": labels}), None, "^data: must have columns"),
    ):
        with pytest.raises(twrench.UsageError, match=message):
            twrench.check(data, body, columns=columns)


def test_a_data_frame_of_pandas_is_checked():
    pytest.importorskip("pandas")
    body = twrench.Body(moments=[2, 3, 4])
    motion = twrench.exact(body, [0.1, 1, 0.2]).at(np.linspace(0, 20, 50))
    found = twrench.check(motion.to_dataframe(), body)
    assert found.finding == "exact" and found.attitude is not None


def test_a_sequence_of_a_check_is_that_of_scipy():
    pytest.importorskip("scipy")
    body = twrench.Body(moments=[2, 3, 4])
    motion = twrench.exact(body, [0.1, 1, 0.2]).at(np.linspace(0, 20, 50))
    rates = {f"w{axis}": motion.omega[:, i] for i, axis in enumerate("xyz")}
    for sequence in ("ZYX", "zyx", "XZY", "yxz", "ZXZ"):
        angles = motion.euler(sequence).T
        names = ["yaw", "pitch", "roll"]
        if sequence != "ZXZ":
            names = [names["ZYX".index(axis)] for axis in sequence.upper()]
        columns = {"t": motion.t, **rates, **dict(zip(names, angles))}
        assert twrench.check(columns, body, sequence=sequence).passes, sequence
    with pytest.raises(twrench.UsageError, match="first and the third angle, and use 'ZXZ'"):
        twrench.check(columns, body, sequence="zxz")
    for wrong in ("zYx", "zzx", "abc", "", 3):
        with pytest.raises(twrench.UsageError, match="^sequence: must be"):
            twrench.check(columns, body, sequence=wrong)
        with pytest.raises(twrench.UsageError, match="^sequence: must be"):
            motion.euler(wrong)


def test_hints_name_the_arguments():
    body = twrench.Body(moments=[2, 3, 4])
    motion = twrench.exact(body, [0.1, 1, 0.2]).at(np.linspace(0, 20, 50))
    rates = {f"w{axis}": motion.omega[:, i] for i, axis in enumerate("xyz")}
    in_degrees = {"t": motion.t, **{name: np.rad2deg(rate) for name, rate in rates.items()}}
    assert twrench.check(in_degrees, body).verdict.endswith(': use units="deg"')
    names = ("x,y", 'p"', "q", "r", "s", "u", "v")
    w, x, y, z = motion.quaternion_wxyz.T
    columns = dict(zip(names, (x, y, z, w, *rates.values())), t=motion.t)
    ours = dict(zip(("qw", "qx", "qy", "qz", "wx", "wy", "wz"), names))
    right = twrench.check(columns, body, columns=ours).verdict
    named = ast.literal_eval(right[right.index("columns=") + len("columns=") :])
    assert named["qw"] == "r" and named["qx"] == "x,y" and named["qy"] == 'p"'
    assert twrench.check(columns, body, columns=named).passes
    inverse = dict(zip(("qw", "qx", "qy", "qz"), (w, -x, -y, -z)), t=motion.t, **rates)
    assert twrench.check(inverse, body).verdict.endswith("use inverse=True")
    with pytest.raises(twrench.UsageError, match="leave it out"):
        twrench.check(in_degrees, body, max_attitude_error=1)
    same = twrench.check([motion, motion], body).order.why_not
    assert same is not None and same.endswith("with steps") and "--" not in same


@pytest.mark.parametrize("moments", [[1, 2, 3], [2, 3, 4], [3, 3, 5]])
def test_a_component_of_a_quaternion_with_the_wrong_sign_is_named(moments):
    body = twrench.Body(moments=moments)
    motion = twrench.exact(body, [0.1, 2, 0.05]).at(np.linspace(0, 10, 101))
    names = ["qw", "qx", "qy", "qz"]
    rates = {f"w{axis}": motion.omega[:, i] for i, axis in enumerate("xyz")}
    columns = {"t": motion.t, **rates, **dict(zip(names, motion.quaternion_wxyz.T))}
    assert "wrong sign" not in twrench.check(columns, body).verdict
    for name in names[1:]:
        found = twrench.check({**columns, name: -columns[name]}, body)
        assert found.finding == "convention"
        assert found.verdict.endswith(f"{name} has the wrong sign: reverse the sign of {name}")
