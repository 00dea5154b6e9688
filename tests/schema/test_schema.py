"""`twrench schema` and the reader of scene files accept and reject the same files.

The validator is python3-jsonschema; without it, only the reader is tested.
"""

from __future__ import annotations

import json
import os
import subprocess
import tomllib
from pathlib import Path

import pytest

PROJECT = Path(__file__).parents[2]
SCENES = sorted((PROJECT / "assets/scenes").glob("*.toml"))
EXAMPLES = sorted([*(PROJECT / "examples").rglob("*.toml"), *(PROJECT / "tests/fuzz/corpus/scene").glob("*.toml")])

BODY = "[body]\nmoments = [1, 2, 3]\n"
SPHERE = "[[part]]\nshape = 'sphere'\nradius = 1\n"
SOLID = SPHERE + "density = 1\n"
SHOT = BODY + "[[shot]]\nlength = 5\n"

# Scenes with a mistake, and the key or table that the reader's message names.
BAD_SCENES = {
    "unknown table": (BODY + "[movie]\nfps = 30", "movie"),
    "unknown key": (BODY + "[film]\nfsp = 30", "fsp"),
    "title no text": ("title = 3\n" + BODY, "title"),
    "no body": ("title = 'x'", "part"),
    "omega of two numbers": (BODY + "[motion]\nomega = [1, 2]", "omega"),
    "omega no array": (BODY + "[motion]\nomega = 1", "omega"),
    "omega out of range": (BODY + "[motion]\nomega = [1e13, 0, 0]", "omega"),
    "wheel of two numbers": (BODY + "[motion]\nwheel = [1, 2]", "wheel"),
    "wheel out of range": (BODY + "[motion]\nwheel = [1e43, 0, 0]", "wheel"),
    "energy_loss_time of zero": (BODY + "[motion]\nenergy_loss_time = 0", "energy_loss_time"),
    "energy_loss_time negative": (BODY + "[motion]\nenergy_loss_time = -1", "energy_loss_time"),
    "file of a recording no text": (BODY + "[motion]\nfile = 1", "file"),
    "part of a recording without a file": (BODY + "[motion]\nfrom = 1", "from"),
    "recording and omega": (BODY + "[motion]\nomega = [1, 0, 0]\nfile = 'a.csv'", "omega"),
    "recording and method": (BODY + "[motion]\nmethod = 'exact'\nfile = 'a.csv'", "method"),
    "from a text": (BODY + "[motion]\nfile = 'a.csv'\nfrom = '1 s'", "from"),
    "unknown unit of rates": (BODY + "[motion]\nfile = 'a.csv'\nunits = 'degrees'", "units"),
    "inverse a number": (BODY + "[motion]\nfile = 'a.csv'\ninverse = 1", "inverse"),
    "offset of three numbers": (BODY + "[motion]\nfile = 'a.csv'\noffset = [1, 0, 0]", "offset"),
    "recording in a shot": (SHOT + "[shot.motion]\nfile = 'a.csv'", "file"),
    "unknown method": (BODY + "[motion]\nmethod = 'rk5'", "method"),
    "step of zero": (BODY + "[motion]\nstep = 0", "step"),
    "tolerance out of range": (BODY + "[motion]\ntolerance = 1e-20", "tolerance"),
    "duration a text": (BODY + "[motion]\nduration = '10 s'", "duration"),
    "size no integers": (BODY + "[film]\nsize = [640.5, 360]", "size"),
    "size of three": (BODY + "[film]\nsize = [640, 360, 1]", "size"),
    "fps out of range": (BODY + "[film]\nfps = 2000", "fps"),
    "speed negative": (BODY + "[film]\nspeed = -1", "speed"),
    "unknown theme": (BODY + "[look]\ntheme = 'dark'", "theme"),
    "samples no integer": (BODY + "[look]\nsamples = 1.5", "samples"),
    "motion_blur too large": (BODY + "[look]\nmotion_blur = 257", "motion_blur"),
    "background no colour": (BODY + "[look]\nbackground = '#12345'", "background"),
    "color transparent": (BODY + "[look]\ncolor = 'transparent'", "color"),
    "unknown material": (BODY + "[look]\nmaterial = 'gold'", "material"),
    "metallic true": (BODY + "[look]\nmetallic = true", "metallic"),
    "roughness below the least": (BODY + "[look]\nroughness = 0.01", "roughness"),
    "elevation beyond the pole": (BODY + "[camera]\nelevation = 1.6", "elevation"),
    "distance of zero": (BODY + "[camera]\ndistance = 0", "distance"),
    "unknown frame": (BODY + "[camera]\nframe = 'earth'", "frame"),
    "camera no table": ("camera = 1\n" + BODY, "camera"),
    "unknown view": (BODY + "[overlay]\nview = 'side'", "view"),
    "show an unknown name": (BODY + "[overlay]\nshow = ['floor', 'ceiling']", "show"),
    "show a text": (BODY + "[overlay]\nshow = 'floor'", "show"),
    "stress a number": (BODY + "[overlay]\nstress = [1]", "stress"),
    "compare five methods": (BODY + "[overlay]\ncompare = ['rk4', 'rk4', 'rk4', 'rk4', 'rk4']", "compare"),
    "compare_omega no vectors": (BODY + "[overlay]\ncompare_omega = [1, 2, 3]", "compare_omega"),
    "trail_point of two numbers": (BODY + "[overlay]\ntrail_point = [1, 2]", "trail_point"),
    "part no array": ("[part]\nshape = 'sphere'\nradius = 1\ndensity = 1", "part"),
    "part without a shape": ("[[part]]\ndensity = 1", "shape"),
    "unknown shape": ("[[part]]\nshape = 'ball'\nradius = 1\ndensity = 1", "shape"),
    "dimension missing": ("[[part]]\nshape = 'cylinder'\nradius = 1\ndensity = 1", "length"),
    "dimension of another shape": (SOLID + "length = 2", "length"),
    "radius negative": ("[[part]]\nshape = 'sphere'\nradius = -1\ndensity = 1", "radius"),
    "box of two lengths": ("[[part]]\nshape = 'box'\nsize = [1, 2]\ndensity = 1", "size"),
    "neither density nor mass": (SPHERE, "density"),
    "density and mass": (SOLID + "mass = 1", "mass"),
    "axis and rotation": (SOLID + "axis = [0, 0, 1]\nrotation = [1, 0, 0]", "rotation"),
    "color of a part": (SOLID + "color = 'blue'", "color"),
    "name of a part": (SOLID + "name = 3", "name"),
    "position of a part": (SOLID + "position = [0, 0, '1']", "position"),
    "mesh without a file": ("[[part]]\nshape = 'mesh'\ndensity = 1", "file"),
    "unknown unit": ("[[part]]\nshape = 'mesh'\nfile = 'phone.stl'\nunit = 'ft'\ndensity = 1", "unit"),
    "unit and scale": (
        "[[part]]\nshape = 'mesh'\nfile = 'phone.stl'\nunit = 'mm'\nscale = 0.1\ndensity = 1", "scale"),
    "crease beyond pi": ("[[part]]\nshape = 'mesh'\nfile = 'phone.stl'\ncrease = 4\ndensity = 1", "crease"),
    "body empty": ("[body]\nshape = 'box'", "body"),
    "moments and inertia": (BODY + "inertia = [[1, 0, 0], [0, 2, 0], [0, 0, 3]]", "inertia"),
    "moment of zero": ("[body]\nmoments = [0, 1, 1]", "moments"),
    "inertia of two rows": ("[body]\ninertia = [[1, 0, 0], [0, 2, 0]]", "inertia"),
    "unknown equimomental solid": (BODY + "shape = 'sphere'", "shape"),
    "shot no array": (BODY + "[shot]\nlength = 5", "shot"),
    "shot without a length": (BODY + "[[shot]]\ncaption = 'x'", "length"),
    "shot too short": (BODY + "[[shot]]\nlength = 0", "length"),
    "caption no text": (SHOT + "caption = 1", "caption"),
    "fade negative": (SHOT + "fade = -1", "fade"),
    "speed without points": (SHOT + "speed = []", "speed"),
    "speed of a single number in a pair": (SHOT + "speed = [[0]]", "speed"),
    "speed negative in a pair": (SHOT + "speed = [[0, -1]]", "speed"),
    "start negative": (SHOT + "start = -1", "start"),
    "start of another word": (SHOT + "start = 'mach'", "start"),
    "film in a shot": (SHOT + "[shot.film]\nfps = 30", "film"),
    "font in a shot": (SHOT + "[shot.overlay]\nfont = 'mono'", "font"),
    "unknown key in a shot": (SHOT + "[shot.camera]\nazimut = 1", "azimut"),
}  # fmt: skip

# Mistakes that only the reader can find: relations between values, and the content of other files.
READER_ONLY = {
    "rotation too slow": (BODY + "[motion]\nomega = [1e-200, 0, 0]", "omega"),
    "wheel too slow": (BODY + "[motion]\nwheel = [1e-200, 0, 0]", "wheel"),
    "energy lost too fast": (BODY + "[motion]\nenergy_loss_time = 0.01", "energy_loss_time"),
    "energy lost by a ball": (SOLID + "[motion]\nenergy_loss_time = 9", "energy_loss_time"),
    "recording and shots": (BODY + "[motion]\nfile = 'a.csv'\n[[shot]]\nlength = 5", "file"),
    "recording without a name": (BODY + "[motion]\nfile = ''", "file"),
    "axes of a recording": (BODY + "[motion]\nfile = 'a.csv'\naxes = 'x,x,z'", "axes"),
    "not a number": (BODY + "[motion]\nduration = nan", "duration"),
    "moments too unequal": ("[body]\nmoments = [1, 1, 1e13]", "moments"),
    "inertia not symmetric": ("[body]\ninertia = [[1, 0.1, 0], [0, 2, 0], [0, 0, 3]]", "inertia"),
    "inertia not positive": ("[body]\ninertia = [[1, 5, 0], [5, 2, 0], [0, 0, 3]]", "inertia"),
    "diagonal entry negative": ("[body]\ninertia = [[-1, 0, 0], [0, 2, 0], [0, 0, 3]]", "inertia"),
    "axis of zero": (SOLID + "axis = [0, 0, 0]", "axis"),
    "hole larger than the tube": (
        "[[part]]\nshape = 'tube'\nradius = 1\ninner_radius = 2\nlength = 3\ndensity = 1", "inner_radius"),
    "density of a mass": (SPHERE + "mass = 1e20", "mass"),
    "no such file": ("[[part]]\nshape = 'mesh'\nfile = 'none.stl'\nunit = 'mm'\ndensity = 1", "file"),
    "fade of the first shot": (SHOT + "fade = 1", "fade"),
    "fade longer than a shot": (SHOT + "[[shot]]\nlength = 1\nfade = 2", "fade"),
    "move without a body": (
        BODY + "[overlay]\nview = 'quad'\n[[shot]]\nlength = 5\n[[shot]]\nlength = 5\nmove = 1", "move"),
    "speed beyond the shot": (SHOT + "speed = [[0, 1], [9, 1]]", "speed"),
    "speed not in order": (SHOT + "speed = [[2, 1], [1, 1]]", "speed"),
    "background of one shot": (SHOT + "[shot.look]\nbackground = 'transparent'", "background"),
}  # fmt: skip


def run(*words: str | Path, folder: Path | None = None) -> subprocess.CompletedProcess[str]:
    return subprocess.run([os.environ["TWRENCH_PROGRAM"], *words], capture_output=True, text=True, cwd=folder)


@pytest.fixture(scope="module")
def schema():
    printed = run("schema")
    assert printed.returncode == 0, printed.stderr
    return json.loads(printed.stdout)


@pytest.fixture(scope="module")
def validator(schema):
    jsonschema = pytest.importorskip("jsonschema")
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def places(schema, at=""):
    """Each value that a scene file may contain, with its location in the schema."""
    for key, value in schema.get("properties", {}).items():
        yield f"{at}.{key}", value
        yield from places(value, f"{at}.{key}")
    for key, value in schema.get("$defs", {}).items():
        yield from places(value, f"{at}.{key}")


@pytest.mark.parametrize("file", [*SCENES, *EXAMPLES], ids=lambda file: file.name)
def test_scenes_are_accepted(validator, file):
    errors = list(validator.iter_errors(tomllib.loads(file.read_text())))
    assert not errors, errors


def test_all_scenes_are_found():
    assert len(SCENES) >= 16
    assert len(EXAMPLES) >= 9


@pytest.mark.parametrize("text", [BODY, SOLID, BODY + SOLID, SHOT], ids=["body", "solid", "both", "shot"])
def test_what_the_mistakes_are_made_in_is_accepted(validator, tmp_path, text):
    (tmp_path / "good.toml").write_text(text)
    assert run("inertia", "good.toml", folder=tmp_path).returncode == 0
    assert validator.is_valid(tomllib.loads(text))


@pytest.mark.parametrize("mistake", BAD_SCENES)
def test_the_schema_rejects(validator, mistake):
    assert not validator.is_valid(tomllib.loads(BAD_SCENES[mistake][0]))


@pytest.mark.parametrize("mistake", READER_ONLY)
def test_the_schema_cannot_know(validator, mistake):
    """If the schema detects a mistake, move that mistake to the other list."""
    assert validator.is_valid(tomllib.loads(READER_ONLY[mistake][0]))


@pytest.mark.parametrize("size", [10.0**n for n in range(-10, 8)])
def test_both_agree_on_a_body_of_any_size(validator, tmp_path, size):
    text = f"[[part]]\nshape = 'cylinder'\nradius = {size}\nlength = {size}\ndensity = 6.7"
    (tmp_path / "body.toml").write_text(text)
    accepted = run("inertia", "body.toml", folder=tmp_path).returncode == 0
    assert accepted == (1e-9 <= size <= 1e6)
    assert validator.is_valid(tomllib.loads(text)) == accepted


@pytest.mark.parametrize("mistake", [*BAD_SCENES, *READER_ONLY])
def test_the_reader_rejects_with_the_key(tmp_path, mistake):
    text, key = (BAD_SCENES | READER_ONLY)[mistake]
    (tmp_path / "bad.toml").write_text(text)
    ended = run("inertia", "bad.toml", folder=tmp_path)
    assert ended.returncode in (2, 5), ended
    first = ended.stderr.splitlines()[0]
    assert first.startswith("twrench: error: bad.toml:"), first
    assert key in first, first
    assert ended.stdout == ""


def test_each_value_is_described(schema):
    described = list(places(schema))
    assert len(described) > 80
    for place, value in described:
        assert value.get("description") or value.get("$ref") or value["items"].get("$ref"), place


def test_each_number_has_limits(schema):
    for place, value in places(schema):
        while value.get("type") == "array":
            value = value["items"]
        if value.get("type") in ("number", "integer"):
            assert {"minimum", "maximum"} <= value.keys(), place


def test_defaults_are_allowed(validator, schema):
    jsonschema = pytest.importorskip("jsonschema")
    defaults = [(place, value) for place, value in places(schema) if "default" in value]
    assert len(defaults) > 15
    for place, value in defaults:
        assert jsonschema.Draft202012Validator(value).is_valid(value["default"]), place


def test_the_document_lists_each_key(schema):
    document = (PROJECT / "docs/scene-files.md").read_text()
    for place, _ in places(schema):
        assert place.rpartition(".")[2] in document, place


def test_the_copy_beside_the_scenes_is_current(schema):
    """Editors read the copy for the built-in scenes, whose first line names it."""
    copy = PROJECT / "assets/scenes/twrench.schema.json"
    assert json.loads(copy.read_text()) == schema, f"renew it: twrench schema -o {copy.relative_to(PROJECT)}"
    for scene in SCENES:
        assert scene.read_text().startswith("#:schema ./twrench.schema.json\n"), scene


def test_it_is_written_to_a_file(schema, tmp_path):
    (tmp_path / "it.json").write_text("old")
    assert run("schema", "-o", "it.json", "--overwrite", folder=tmp_path).returncode == 0
    assert json.loads((tmp_path / "it.json").read_text()) == schema
    assert [file.name for file in tmp_path.iterdir()] == ["it.json"]
