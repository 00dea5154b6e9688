"""Scenes: a body, its motion and its presentation, with pictures and films of it."""

from __future__ import annotations

import json
import math
import os
import warnings
from fractions import Fraction
from pathlib import Path
from typing import (
    Any,
    Callable,
    Collection,
    Generic,
    Iterable,
    Literal,
    NoReturn,
    Optional,
    Sequence,
    TypeVar,
    cast,
    overload,
)

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _native, plots
from ._arguments import Array
from .body import Body
from .check import Recording
from .errors import FileError, SceneError, UsageError
from .film import Film, Picture, Progress, frame_range, quality, reporting
from .motion import Motion, simulate
from .names import (
    Attitude,
    BackendName,
    ContainerName,
    EffortName,
    ExportFormat,
    FeatureName,
    ForceName,
    FrameName,
    LanguageName,
    MaterialName,
    MethodName,
    Numbers,
    Rate,
    Rows,
    SoundName,
    StrPath,
    ThemeName,
    UnitName,
    ViewName,
)
from .solids import mesh_scale

__all__ = ["Scene", "scenes", "schema"]

T = TypeVar("T")
Vector = tuple[float, float, float]


class _Unset:
    """The default of an argument for which None is a value."""

    def __repr__(self) -> str:
        return "<the scene's>"


UNSET: Any = _Unset()


def scenes() -> list[str]:
    """The names of the built-in scenes."""
    return list(_native.scene_names())


def schema() -> dict[str, Any]:
    """The JSON Schema (2020-12) of scene files, as printed by ``twrench schema``."""
    return cast("dict[str, Any]", json.loads(_native.scene_schema()))


def _as_json(key: str, value: Any) -> str:
    def convert(other: Any) -> Any:
        if isinstance(other, (np.ndarray, np.generic)):
            return other.tolist()
        if isinstance(other, (set, frozenset)):
            return sorted(other)
        if isinstance(other, os.PathLike):
            return os.fspath(other)
        raise TypeError

    try:
        text = json.dumps(value, default=convert, allow_nan=False, ensure_ascii=False)
        text.encode("utf-8")  # fails for half of a surrogate pair
        return text
    except (TypeError, ValueError, RecursionError) as error:
        raise SceneError(f"{key}: cannot be {_arguments.brief(value)}") from error


def _as_tuple(value: Any) -> Any:
    return tuple(map(_as_tuple, value)) if isinstance(value, list) else value


class _Value(Generic[T]):
    """A value of a scene, as an attribute of :class:`Scene`. It has the name of the key unless that
    is the name of a method."""

    def __init__(self, key: str = "") -> None:
        self.key = key

    def __set_name__(self, owner: type, name: str) -> None:
        self.key = self.key or name
        field = next(field for field in _native.fields() if field.key == self.key)
        self.__doc__ = f"{field.help}. ``{self.key}`` in ``[{field.table}]`` of a scene file."

    @overload
    def __get__(self, scene: None, owner: type) -> _Value[T]: ...

    @overload
    def __get__(self, scene: Scene, owner: type) -> T: ...

    def __get__(self, scene: Scene | None, owner: type) -> _Value[T] | T:
        if scene is None:
            return self
        value = json.loads(scene._native.get(self.key))
        return cast(T, _as_tuple(value))

    def __set__(self, scene: Scene, value: T) -> None:
        scene._native.set(self.key, _as_json(self.key, value))
        scene._drawer = None


class _OfComputedMotion(_Value[T]):
    """A value that computes the motion; a scene that shows a recording refuses it."""

    def __set__(self, scene: Scene, value: T) -> None:
        if scene._native.shows_recording:
            raise _error_of_recorded(self.key)
        super().__set__(scene, value)


class _Attitude(_Value[Optional[tuple[float, float, float, float]]]):
    """The quaternion of X(0). It can be set in any form that :func:`twrench.simulate` accepts."""

    def __set__(self, scene: Scene, value: Any) -> None:
        if value is None:
            return super().__set__(scene, (1.0, 0.0, 0.0, 0.0))
        try:
            matrix = _arguments.attitude(self.key, value)
        except UsageError as error:
            raise SceneError(error.message, error.remedy) from error
        x, y, z, w = _native.quaternions(matrix[None])[0].tolist()
        super().__set__(scene, (w, x, y, z))


class _Wheel(_Value[Optional[Vector]]):
    """The momentum of a wheel; None for none."""

    def __set__(self, scene: Scene, value: Any) -> None:
        super().__set__(scene, (0.0, 0.0, 0.0) if value is None else value)


class _Audio(_Value[Optional[str]]):
    """The path of a sound file; None for none."""

    def __set__(self, scene: Scene, value: Any) -> None:
        super().__set__(scene, "" if value is None else value)


class _Rate(_Value[float]):
    """A number per second. It can be set as a fraction, ``"30000/1001"`` or ``Fraction``."""

    def __set__(self, scene: Scene, value: Rate) -> None:
        if isinstance(value, Fraction):
            value = f"{value.numerator}/{value.denominator}"
        super().__set__(scene, cast(float, value))


class _EnergyLossTime(_Value[Optional[float]]):
    """The time constant of the energy loss; None or infinity for none."""

    def __set__(self, scene: Scene, value: Any) -> None:
        is_none = value is None or (isinstance(value, float) and value == math.inf)
        if not is_none:
            return super().__set__(scene, value)
        scene._native.set_number(self.key, math.inf)
        scene._drawer = None


def _keys() -> list[str]:
    """The attributes of a scene that are keys of a scene file, with a material before the keys that
    replace its values."""
    return [name for name, value in vars(Scene).items() if isinstance(value, _Value)]


class Scene:
    """Everything that determines a film.

    :param source: name of a built-in scene, or path of a scene file or of a mesh in OBJ, STL,
        PLY, glTF, COLLADA or 3MF. A mesh spins about its intermediate axis, or wobbles if it is symmetric.
    :param language: language of the words in the picture, en or nb. A built-in story is also told in
        that language. Another tag of BCP 47, such as sv, is that of the captions; the picture's own
        words are then in English.
    :param unit: unit of a mesh whose file states none: OBJ, STL or PLY: mm, cm, m, inch or km.
    :param scale: centimetres per unit of a mesh, instead of ``unit``.
    :param weld: distance in cm up to which vertices of a mesh are joined.
    :param shell: thickness in cm of a wall along a mesh; None for a solid.
    :param density: density of a mesh in g/cm^3; 1 unless it or the mass is given.
    :param mass: mass of a mesh in g, instead of ``density``.
    :param body: a body that replaces that of the scene.
    :param motion: a :class:`Recording` that the scene shows instead of a computed motion, or of the
        recording that its file names. Frames, films and exports then show it;
        ``compare=["exact"]`` shows the free motion beside it. What needs the free motion of the body
        is left out, with a warning, if the recording does not follow it. It excludes ``omega`` and
        ``method``.
    :param smooth: whether to show the smoothest motion within the noise of ``motion`` instead of its
        rows. A warning says whether the noise can be seen.
    :param unknown: no other arguments are accepted; the error proposes the nearest name.
    :raises SceneError: for a mistake; the message names file, line and key.
    :raises FileError: if the file cannot be read.

    Every key of a scene file is an argument, which replaces the scene's value, and an attribute that
    can be set; ``frame`` of the camera is called ``camera_frame``. ``attitude`` is X(0), in any form
    that :func:`simulate` accepts. An invalid value is rejected and leaves the scene unchanged.

    ``length`` is that of the video in s. With ``duration`` it determines the speed, otherwise the
    duration; it is an error beside both.

    ``step``, ``duration`` and ``speed`` follow from the motion unless the file or the caller gives
    them. Replacing the ``body`` also resets the title, the times and the trail of the scene, except
    those that the caller gave.

    >>> scene = Scene("dzhanibekov", size=(640, 360), method="exact")
    >>> scene.frame(100).shape
    (360, 640, 3)
    """

    title = _Value[str]()
    language = _Value[str]()
    omega = _OfComputedMotion[Vector]()
    attitude = _Attitude("attitude")
    wheel = _Wheel()
    energy_loss_time = _EnergyLossTime()
    method = _OfComputedMotion[MethodName]()
    step = _Value[float]()
    tolerance = _Value[float]()
    duration = _Value[float]()
    size = _Value[tuple[int, int]]()
    fps = _Rate()
    speed = _Value[float]()
    audio = _Audio()
    sound = _Value[SoundName]()
    text_fade = _Value[Optional[float]]()
    theme = _Value[ThemeName]()
    samples = _Value[int]()
    motion_blur = _Value[int]()
    background = _Value[Optional[str]]()
    material = _Value[Optional[MaterialName]]()
    color = _Value[Optional[str]]()
    metallic = _Value[Optional[float]]()
    roughness = _Value[Optional[float]]()
    azimuth = _Value[float]()
    elevation = _Value[float]()
    distance = _Value[float]()
    orbit = _Value[float]()
    field_of_view = _Value[float]()
    camera_frame = _Value[FrameName]("frame")
    view = _Value[ViewName]()
    show = _Value[tuple[FeatureName, ...]]()
    stress = _Value[Optional[tuple[FeatureName, ...]]]()
    forces = _Value[Optional[tuple[ForceName, ...]]]()
    compare = _Value[tuple[MethodName, ...]]()
    compare_omega = _Value[Optional[tuple[Vector, ...]]]()
    compare_wheel = _Value[Optional[tuple[Vector, ...]]]()
    trail_point = _Value[Optional[Vector]]()
    trail_length = _Value[Optional[float]]()
    star_trail = _Value[Optional[float]]()
    font = _Value[str]()

    def __init__(
        self,
        source: StrPath = "dzhanibekov",
        *,
        unit: UnitName | None = None,
        scale: float | None = None,
        weld: float | None = None,
        shell: float | None = None,
        density: float | None = None,
        mass: float | None = None,
        body: Body = UNSET,
        motion: Recording = UNSET,
        smooth: bool = UNSET,
        title: str = UNSET,
        language: LanguageName | str = UNSET,
        omega: Numbers = UNSET,
        attitude: Attitude = UNSET,
        wheel: Numbers = UNSET,
        energy_loss_time: float = UNSET,
        method: MethodName = UNSET,
        step: float = UNSET,
        tolerance: float = UNSET,
        duration: float = UNSET,
        length: float = UNSET,
        size: tuple[int, int] = UNSET,
        fps: Rate = UNSET,
        speed: float = UNSET,
        audio: StrPath | None = UNSET,
        sound: SoundName = UNSET,
        text_fade: float = UNSET,
        theme: ThemeName = UNSET,
        samples: int = UNSET,
        motion_blur: int = UNSET,
        background: str = UNSET,
        material: MaterialName = UNSET,
        color: str = UNSET,
        metallic: float = UNSET,
        roughness: float = UNSET,
        azimuth: float = UNSET,
        elevation: float = UNSET,
        distance: float = UNSET,
        orbit: float = UNSET,
        field_of_view: float = UNSET,
        camera_frame: FrameName = UNSET,
        view: ViewName = UNSET,
        show: Collection[FeatureName] = UNSET,
        stress: Collection[FeatureName] = UNSET,
        forces: Collection[ForceName] = UNSET,
        compare: Sequence[MethodName] = UNSET,
        compare_omega: Rows = UNSET,
        compare_wheel: Rows = UNSET,
        trail_point: Numbers = UNSET,
        trail_length: float = UNSET,
        star_trail: float = UNSET,
        font: StrPath = UNSET,
        **unknown: NoReturn,
    ) -> None:
        given = locals()  # before other local names exist
        name = _arguments.path("source", source)
        self._source = name
        self._of_mesh: dict[str, Any] = {}
        # A built-in scene has no file.
        self._inputs = [Path(name)] if os.path.exists(name) else []
        of_mesh = {
            "unit": unit,
            "scale": scale,
            "weld": weld,
            "shell": shell,
            "density": density,
            "mass": mass,
        }
        if _native.is_mesh_name(name):
            self._native = _scene_of_mesh(name, of_mesh)
            self._of_mesh = of_mesh
        else:
            _require_no_mesh_values(name, of_mesh)
            self._native = _native.Scene.load(
                name, None if language is UNSET else _arguments.text("language", language)
            )
        for note in self._native.notes():
            warnings.warn(note, stacklevel=2)
        self._original = _native.Scene(self._native)
        self._drawer: _native.FrameDrawer | None = None
        keys = ("body", *_keys(), "motion", "smooth", "length")
        values = {key: given[key] for key in keys if given[key] is not UNSET}
        self._set_all(values | unknown)

    @classmethod
    def from_toml(cls, text: str, name: str = "scene", **values: Any) -> Scene:
        """Makes a scene from the text of a scene file.

        :param text: the text, in TOML.
        :param name: name of the file in messages; paths of meshes are relative to its folder.
        :param values: values that replace those of the text, as in :class:`Scene`.
        :raises SceneError: for a mistake; the message names line and key.
        """
        scene = cls.__new__(cls)
        scene._source, scene._of_mesh = name, {}
        scene._inputs = []
        scene._native = _native.Scene.parse(
            _arguments.text("text", text), _arguments.text("name", name)
        )
        for note in scene._native.notes():
            warnings.warn(note, stacklevel=2)
        scene._original = _native.Scene(scene._native)
        scene._drawer = None
        scene._set_all(values)
        return scene

    def _set_all(self, values: dict[str, Any]) -> None:
        if "language" in values:  # of the title that a body gets
            self.language = values["language"]
        if "body" in values:  # first, because it resets the title and the times
            self.body = values["body"]
        for key, value in values.items():
            if key in ("body", "motion", "smooth", "length"):
                continue
            if isinstance(getattr(type(self), key, None), _Value):
                setattr(self, key, value)
            else:
                self._native.set(key, "null")  # raises an error that lists the keys
        if "motion" in values or self._native.names_recording:
            _require_nothing_computed(values)
        if "smooth" in values and "motion" not in values:
            raise SceneError(
                "smooth: it applies to the recording given as motion, and there is none",
                "give motion too; in a scene file [motion] has the key smooth",
            )
        if "motion" in values:  # after what it is compared with
            recording = _arguments.instance("motion", values["motion"], Recording)
            smooth = _arguments.flag("smooth", values.get("smooth", False))
            self._show(lambda: _native.show_recording(self._native, *recording._origin, smooth))
        elif self._native.names_recording:
            self._show(lambda: _native.show_own_recording(self._native))
        if "length" in values:  # last, because it follows from the others or determines one of them
            if "duration" in values and "speed" in values:
                raise SceneError("length: duration and speed determine it; leave out one of the three")
            self._set_length(values["length"], "duration" in values)

    def _show(self, recording: Callable[[], None]) -> None:
        before = self._native.notes()
        recording()
        for note in self._native.notes():
            if note not in before:
                warnings.warn(note, stacklevel=4)
        self._drawer = None

    def _require_computed(self, result: str) -> None:
        if self._native.shows_recording:
            raise SceneError(
                f"motion: {result} of the free motion is not one of the recording that the scene shows",
                "use a scene without the recording",
            )

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_") and not hasattr(type(self), name):
            self._native.set(name, "null")
        super().__setattr__(name, value)

    @property
    def name(self) -> str:
        """The name of the scene. Names of outputs are derived from it."""
        return self._native.name

    @property
    def body(self) -> Body:
        """The rigid body."""
        return Body._wrap(self._native.body)

    @body.setter
    def body(self, body: Body) -> None:
        if not isinstance(body, Body):
            raise SceneError(f"body: must be a twrench.Body, not {_arguments.brief(body)}")
        self._native.body = body._native
        self._drawer = None

    @property
    def length(self) -> float:
        """The length of the video in s: duration / speed, or that of all shots. A new length keeps the
        speed, so it cuts or extends the motion."""
        return self._native.video_length()

    @length.setter
    def length(self, length: float) -> None:
        self._set_length(length, keeps_duration=False)

    def _set_length(self, length: Any, keeps_duration: bool) -> None:
        self._native.set_video_length(_arguments.number("length", length), keeps_duration)
        self._drawer = None

    @property
    def frame_count(self) -> int:
        """The number of frames: round(duration * fps / speed), or those of all shots."""
        return self._native.frame_count()

    @property
    def times(self) -> Array:
        """The time of the motion in each frame, s, (frame_count,)."""
        if self._native.has_shots():
            return np.array(self._native.motion_times(), dtype=np.float64)
        return np.asarray(np.arange(self.frame_count) * self.speed / self.fps, dtype=np.float64)

    def to_dict(self) -> dict[str, Any]:
        """Every value, with the tables, keys and units of a scene file."""
        values: dict[str, Any] = json.loads(self._native.json())
        return values

    def simulate(
        self,
        times: Numbers | None = None,
        *,
        span: Numbers | None = None,
        fps: Rate | None = None,
    ) -> Motion:
        """The motion by the scene's method, at the times of the frames unless others are given.

        For a film with shots, it is the scene's own motion, at intervals of ``speed / fps``.

        :param times: times in s, (n,), in any order and of either sign.
        :param span: in place of ``times``, (start, end) in s, both of which are sampled.
        :param fps: samples per second of ``span``, also as a fraction; 60 unless given.
        :raises UsageError: for a wrong argument.
        :raises MotionError: if the method fails.
        """
        self._require_computed("the simulation")
        if times is None and span is None and fps is None:
            times = self._own_times() if self._native.has_shots() else self.times
        return simulate(
            self.body,
            self.omega,
            times,
            self.method,
            span=span,
            fps=fps,
            attitude=self.attitude,
            wheel=self.wheel,
            energy_loss_time=self.energy_loss_time,
            step=self.step,
            tolerance=self.tolerance,
        )

    def _own_times(self) -> Array:
        """The times of the frames that the scene itself would have without its shots."""
        count = round(self.duration * self.fps / self.speed)
        return np.asarray(np.arange(count) * self.speed / self.fps, dtype=np.float64)

    def __copy__(self) -> Scene:
        scene = type(self).__new__(type(self))
        scene.__dict__.update(vars(self))
        scene._native = _native.Scene(self._native)
        scene._drawer = None
        return scene

    def __getstate__(self) -> dict[str, Any]:
        natives = _native.state_of_scenes([self._native, self._original])  # they share meshes
        return {**vars(self), "_drawer": None, "_native": natives, "_original": None}

    def __setstate__(self, state: dict[str, Any]) -> None:
        natives = _native.scenes_with(state.get("_native") if isinstance(state, dict) else None)
        if len(natives) != 2:
            raise UsageError("the pickled scene: is damaged", "pickle the object again")
        self.__dict__.update(state, _native=natives[0], _original=natives[1])

    def __deepcopy__(self, _: object) -> Scene:
        return self.__copy__()

    def __repr__(self) -> str:
        width, height = self.size
        return f"<twrench.Scene {self.name}: {self.frame_count} frames of {width}x{height}>"

    # Pictures.

    def frame(self, index: int | None = None, *, time: float | None = None) -> NDArray[np.uint8]:
        """Draws a frame, byte for byte as ``twrench render`` does.

        :param index: number of the frame, from 0; negative ones count from the end.
        :param time: instead of ``index``, time of the motion in s, for the frame nearest to it. Not
            for a film with shots, which may show a time twice.
        :returns: (height, width, 3), sRGB; (height, width, 4) with unpremultiplied alpha if the
            background is transparent. Row 0 is the top.
        :raises GlError: if there is no OpenGL.

        The first call opens OpenGL and takes longer. Several threads may call it; their calls are
        serialized.
        """
        return self._drawing().frame(self._index(index, time))

    def png(self, index: int | None = None, *, time: float | None = None) -> bytes:
        """A frame as PNG, byte for byte as ``twrench render`` writes it.

        ``index`` or ``time``, and errors, are as in :meth:`frame`.
        """
        return self._drawing().png(self._index(index, time))

    def _snapshot(self) -> _native.Scene:
        """A copy, which other threads do not change while it is used without Python's global lock."""
        return _native.Scene(self._native)

    def _drawing(self) -> _native.FrameDrawer:
        if self._drawer is None:
            self._drawer = _native.FrameDrawer(self._snapshot(), "auto")
        return self._drawer

    def _index(self, index: int | None, time: float | None) -> int:
        if (index is None) == (time is None):
            raise UsageError("frame: give either index or time")
        count = self.frame_count
        if index is not None:
            number = _arguments.whole("index", index, -count, count - 1)
            return number % count
        if self._native.has_shots():
            raise UsageError("time: a film with shots may show it twice; give index instead")
        place = _arguments.number("time", time) * self.fps / self.speed
        last = (count - 1) * self.speed / self.fps
        if not -0.5 <= place < count - 0.5:
            raise UsageError(f"time: must be from 0 to {last:g} s, not {time}")
        return round(place)

    def picture(self, t: float) -> Picture:
        """The frame nearest to the time ``t`` of the motion, in s, for display in a notebook.

        Errors are as in :meth:`frame`.
        """
        return Picture(self.png(time=t))

    def _repr_png_(self) -> bytes:
        """The picture for a notebook: the frame at a quarter of the film, where trails are long."""
        return self.png(self.frame_count // 4)

    def _repr_html_(self) -> str | None:
        """The page in an iframe for a notebook; None if there is no page, and the picture is shown.

        The iframe may run the scripts of the page and copy to the clipboard. It has no other rights:
        ``sandbox`` without ``allow-same-origin``.
        """
        try:
            html = self._page("", has_article=False).html
        except (UsageError, FileError):  # No page can show the recording, or this build has none.
            return None
        text = html.replace("&", "&amp;").replace('"', "&quot;")
        if len(text) > _LARGEST_PAGE:
            return None
        style = "width: 100%; height: 600px; border: 0"
        return f'<iframe sandbox="allow-scripts" allow="clipboard-write" style="{style}" srcdoc="{text}"></iframe>'

    def _page(self, template: str, *, has_article: bool) -> _native.Page:
        words = _mesh_words(self._of_mesh)
        page = _native.page(
            self._snapshot(), self._original, self._source, words, template, has_article
        )
        for note in page.notes:
            warnings.warn(note, stacklevel=3)
        return page

    def page(
        self,
        path: StrPath,
        *,
        lab: bool = False,
        template: StrPath | None = None,
        overwrite: bool = False,
    ) -> Path:
        """Writes an HTML file with an interactive view of the motion, as ``twrench page`` does.

        It opens in Norwegian if that is the scene's language, otherwise in the reader's.

        :param path: the file.
        :param lab: leave out the article, which explains why the body turns over.
        :param template: the page without a scene, as built by scripts/maintain/page.sh; None for the
            built-in one.
        :param overwrite: replace an existing file that twrench did not write, or that is of another kind.
        :returns: the path. The page needs no network and no server.
        :raises UsageError: for a scene that a page cannot show.
        :raises FileError: if the file cannot be written, or this build has no page.
        :raises OverwriteError: if another file would be replaced.
        """
        source = "" if template is None else _arguments.path("template", template)
        output = self._output("page", path, overwrite, reads=[source] if source else [])
        page = self._page(source, has_article=not lab)
        _native.write_output(output, page.html.encode("utf-8"))
        return output.path

    def report(
        self,
        path: StrPath,
        *,
        author: str = "",
        date: str = "",
        static: bool = False,
        overwrite: bool = False,
    ) -> Path:
        """Writes a report on the motion, as ``twrench report`` does: theory, tables and figures.

        It is in the language of the scene, English or Norwegian.

        :param path: the file, .html or .md; the figures of a Markdown report are files beside it.
        :param author: name of the author, shown below the title.
        :param date: date below the title, in any form.
        :param static: leave out the interactive page.
        :param overwrite: replace an existing file that twrench did not write, or that is of another kind.
        :returns: the path.
        :raises UsageError: for another ending.
        :raises MotionError: if the scene's method cannot compute the motion.
        :raises FileError: if a file cannot be written.
        :raises OverwriteError: if another file would be replaced.
        :raises Error: if gnuplot, which draws the figures, is missing or fails.
        """
        return write_report([self], path, author, date, static, overwrite, solves_tasks=False)

    def export(
        self,
        path: StrPath,
        *,
        format: ExportFormat | None = None,
        max_angle: float = 1e-4,
        speed: float | None = None,
        epoch: str = "2026-01-01T00:00:00",
        overwrite: bool = False,
    ) -> Path:
        """Writes the motion for other programs, as ``twrench export`` does.

        :param path: the file: .glb is an animated model in glTF 2.0, .py a script that animates an
            object in Blender, .aem a CCSDS attitude ephemeris message, .csv, .json and .npz are samples
            as ``twrench simulate`` writes them.
        :param format: glb, py, aem, csv, json or npz; None to choose it by the ending of ``path``.
        :param max_angle: for .glb and .py, bound for the angle between the animation and the exact motion at
            any time, rad.
        :param speed: for .glb and .py, seconds of motion per second of the animation; None for 1, or for the
            speed of the film if real time is too fast or too slow.
        :param epoch: for .aem, date and time of t = 0, TAI.
        :param overwrite: replace an existing file that twrench did not write, or that is of another kind.
        :returns: the path.
        :raises UsageError: for a wrong argument or another ending.
        :raises FileError: if the file cannot be written.
        :raises OverwriteError: if another file would be replaced.
        """
        name = "" if format is None else _arguments.text("format", format)
        output = self._output("export", path, overwrite, format=name)
        notes = _native.export_motion(
            self._snapshot(),
            output,
            _arguments.positive("max_angle", max_angle),
            None if speed is None else _arguments.positive("speed", speed),
            _arguments.text("epoch", epoch),
        )
        for note in notes:
            warnings.warn(note, stacklevel=2)
        return output.path

    def plot(
        self, path: StrPath | None = None, *, overlay: bool = False, overwrite: bool = False
    ) -> Any:
        """Plots the nine components of X against time, with the flips marked.

        A recorded motion is plotted with the exact one, which is dashed in a Matplotlib figure.

        :param path: a file for gnuplot to draw, .svg, .pdf or .png, as in ``twrench plot``; or None.
        :param overlay: one panel per column of X instead of one per component.
        :param overwrite: replace an existing file that twrench did not write, or that is of another kind.
        :returns: a Matplotlib figure; without Matplotlib, the text of an SVG file.
        :raises UsageError: for another ending.
        :raises MotionError: if the scene's method cannot compute the motion.
        :raises FileError: if the file cannot be written.
        :raises OverwriteError: if another file would be replaced.
        :raises Error: if gnuplot is needed, but is missing or fails.
        """
        if path is not None:
            output = self._output("plot", path, overwrite)
            _native.draw_plot([self._snapshot()], output, bool(overlay))
        try:
            from matplotlib.figure import Figure
        except ImportError:
            return _native.plot_svg(self._snapshot(), bool(overlay))
        return _matplotlib_figure(Figure, self, overlay)

    def _output(
        self,
        kind: str,
        path: StrPath,
        overwrite: bool,
        *,
        format: str = "",
        reads: Iterable[StrPath] = (),
    ) -> _native.Output:
        """An output of that kind, which must not be an input of the scene or one of ``reads``."""
        inputs = self._inputs + self._native.input_files() + [Path(file) for file in reads]
        file = Path(_arguments.path("path", path))
        return _native.Output(kind, file, inputs, bool(overwrite), format)

    def render(
        self,
        path: StrPath | None = None,
        *,
        frames_dir: StrPath | None = None,
        frames: str | Iterable[int] | None = None,
        shard: tuple[int, int] | None = None,
        container: ContainerName | None = None,
        chapters: bool = True,
        encode: EffortName | None = None,
        crf: int | None = None,
        resume: bool = False,
        overwrite: bool = False,
        jobs: int | None = None,
        backend: BackendName = "auto",
        egl_device: int | Literal["software"] | None = None,
        progress: Progress | bool = True,
    ) -> Film:
        """Draws the frames and writes the film.

        :param path: the video, .mp4, .mov, .mkv or .webm, or an animated image of the scene's size,
            .gif or .webp; None for only the frames. All except .mp4 and .mkv keep a transparent
            ``background``.
        :param frames_dir: folder for the frames as PNG, with their manifest; None for only a video.
        :param frames: numbers of the frames, or a range such as ``"0-99:3"``; None for all.
        :param shard: draw only part i of n of these frames, (i, n) with i from 1, into a folder that
            all n parts share. There is no video; :func:`encode` makes it when all parts are drawn.
        :param container: mp4, mov, mkv, webm, gif or webp; None to choose it by the ending of ``path``.
        :param chapters: start a chapter of the video at each flip.
        :param encode: effort of the encoder, only for H.264 and VP9: fast takes less processor time and
            small makes a smaller file, both at the quality of balanced, the default.
        :param crf: quality of H.264 (0 to 51) or VP9 (0 to 63), smaller is better; None for the
            default of the codec.
        :param resume: keep existing intact frames of this scene.
        :param overwrite: replace frames and a video of another scene.
        :param jobs: number of threads that compress frames, 1 to 256; None: half the
            processors, at most 8.
        :param backend: auto, osmesa or egl.
        :param egl_device: number of the EGL device, or "software"; None for the first usable one.
        :param progress: True shows a tqdm bar if tqdm is installed; False shows nothing. A function is
            called after each frame with the number of finished frames and of all frames; an
            exception that it raises ends the run.
        :raises UsageError: if the container cannot keep a transparent background.
        :raises OverwriteError: if another file would be overwritten.
        :raises EncoderError: if ffmpeg is missing or fails.
        :raises FileError: if a file cannot be written.
        :raises GlError: if there is no OpenGL.

        A video appears only when it is complete. However the run ends, even by Ctrl-C, the existing
        frames are complete, and ``resume=True`` continues the run.
        """
        if path is None and frames_dir is None:
            raise UsageError("render: give path, frames_dir or both")
        if path is None and not (encode is None and crf is None):
            raise UsageError("render: no video is written; leave out encode and crf, or give path")
        if resume and overwrite:
            raise UsageError("render: resume keeps frames and overwrite replaces them; give one")
        if shard is not None and path is not None:
            raise UsageError("shard: draws a part of the frames, without a video; leave out path")
        video = None if path is None else Path(_arguments.path("path", path))
        folder = None if frames_dir is None else Path(_arguments.path("frames_dir", frames_dir))
        existing = "overwrite" if overwrite else "resume" if resume else "none"
        inputs = self._inputs + self._native.input_files()
        chosen = None if container is None else _arguments.text("container", container)
        selected = frame_range(frames)
        threads = None if jobs is None else _arguments.whole("jobs", jobs, 1, 256)
        drawn_by = _arguments.text("backend", backend)
        device = _egl_device(egl_device, drawn_by)
        part = None if shard is None else _shard(shard)
        with reporting(progress) as report:
            count, notes = _native.render(
                self._snapshot(),
                video,
                chosen,
                bool(chapters),
                *quality(encode, crf),
                folder,
                selected,
                part,
                existing,
                threads,
                drawn_by,
                device,
                inputs,
                report,
            )
        for note in notes:
            warnings.warn(note, stacklevel=2)
        return Film(video, folder, count)


def write_report(
    scenes: Sequence[Scene],
    path: StrPath,
    author: str,
    date: str,
    static: bool,
    overwrite: bool,
    *,
    solves_tasks: bool,
) -> Path:
    """Writes a report for :meth:`Scene.report` or :func:`twrench.report`."""
    for scene in scenes:
        scene._require_computed("a report")
    output = output_of_all("report", scenes, path, overwrite)
    reported = [
        (scene._snapshot(), scene._original, [scene._source, *_mesh_words(scene._of_mesh)])
        for scene in scenes
    ]
    author, date = _arguments.text("author", author), _arguments.text("date", date)
    notes = _native.report(reported, output, author, date, bool(static), solves_tasks)
    for note in notes:
        warnings.warn(note, stacklevel=3)
    return output.path


def output_of_all(
    kind: str, scenes: Sequence[Scene], path: StrPath, overwrite: bool
) -> _native.Output:
    """An output that must not be an input of any of the scenes."""
    inputs = [file for each in scenes for file in each._inputs + each._native.input_files()]
    return scenes[0]._output(kind, path, overwrite, reads=inputs)


#: Maximum number of characters of a page in a notebook, which would otherwise become too large.
_LARGEST_PAGE = 1_000_000


def _shard(shard: tuple[int, int]) -> str:
    form = "two integers (i, n), part i of n"
    numbers = _arguments.sequence("shard", shard, form)
    if len(numbers) != 2:
        raise UsageError(f"shard: must be {form}, not {_arguments.brief(shard)}")
    count = _arguments.whole("shard", numbers[1], 1, 2**31 - 1)
    return f"{_arguments.whole('shard', numbers[0], 1, count)}/{count}"


def _egl_device(device: int | str | None, backend: str) -> str | None:
    if device is None:
        return None
    if backend == "osmesa":
        raise UsageError("egl_device: OSMesa has none; use backend='egl', or leave it out")
    if isinstance(device, str):
        return _arguments.text("egl_device", device)
    return str(_arguments.whole("egl_device", device, 0, 2**31 - 1))


def _mesh_words(of_mesh: dict[str, Any]) -> list[str]:
    """The options of a mesh on the command line that pages and reports show."""
    words: list[str] = []
    for key, value in of_mesh.items():
        if value is not None:
            words += [f"--{key}", value if isinstance(value, str) else f"{value:.17g}"]
    return words


def _matplotlib_figure(make: Any, scene: Scene, overlay: bool) -> Any:
    """The plot as a figure without a window."""
    curves = _native.attitude_curves(scene._snapshot())  # a recorded motion, then the exact one
    figure = make(figsize=(10, 3 if overlay else 7), layout="constrained")
    figure.suptitle(scene.title or scene.name)
    axes = figure.subplots(1 if overlay else 3, 3, sharex=True, sharey=True, squeeze=False)
    for i, (t, X, _) in enumerate(curves):
        plots.draw_components(axes[0] if overlay else axes, t, X, "paper", dashed=i > 0)
    for panel in axes.flat:
        for flip in curves[0][2]:
            panel.axvline(flip, color="0.6", linewidth=0.6, linestyle="--")
    return figure


def _error_of_recorded(key: str) -> SceneError:
    return SceneError(
        f"{key}: the motion of the scene is recorded",
        "leave it out; compare=['exact'] shows the free motion beside it",
    )


def _require_nothing_computed(values: dict[str, Any]) -> None:
    for key in ("omega", "method"):
        if key in values:
            raise _error_of_recorded(key)


def _require_no_mesh_values(name: str, of_mesh: dict[str, Any]) -> None:
    for key, value in of_mesh.items():
        if value is not None and not _native.is_mesh_name(name):
            raise UsageError(f"{key}: is for a mesh, and {_arguments.brief(name)} is a scene")


def _scene_of_mesh(file: str, of_mesh: dict[str, Any]) -> _native.Scene:
    if of_mesh["mass"] is not None and of_mesh["density"] is not None:
        raise UsageError("mass: density determines it")
    numbers = {
        key: None if of_mesh[key] is None else _arguments.number(key, of_mesh[key])
        for key in ("weld", "shell", "density", "mass")
    }
    return _native.Scene.of_mesh(
        file, mesh_scale(of_mesh["unit"], of_mesh["scale"]), **numbers
    )
