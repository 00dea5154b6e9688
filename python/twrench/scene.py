"""Scenes: a body, its motion, and how it is shown; their pictures and their film."""

from __future__ import annotations

import base64
import json
import os
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Generic, Iterable, Optional, TypeVar, Union, cast, overload

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _native
from ._arguments import Array
from .body import Body
from .errors import SceneError, UsageError
from .motion import Motion, simulate
from .solids import mesh_scale

__all__ = ["Film", "Scene", "scenes"]

T = TypeVar("T")
Vector = tuple[float, float, float]
StrPath = Union[str, "os.PathLike[str]"]
Progress = Callable[[int, int], object]


def scenes() -> list[str]:
    """The names of the built-in scenes."""
    return list(_native.scene_names())


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
        text.encode("utf-8")  # fails where there is half of a surrogate pair
        return text
    except (TypeError, ValueError, RecursionError) as error:
        raise SceneError(f"{key}: cannot be {_arguments.brief(value)}") from error


def _as_tuple(value: Any) -> Any:
    return tuple(map(_as_tuple, value)) if isinstance(value, list) else value


class _Value(Generic[T]):
    """A value of a scene, an attribute of :class:`Scene` with the name of its key or, where that is
    the name of a method, another."""

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


class Scene:
    """Everything that determines a film.

    :param source: name of a built-in scene, or path of a scene file or of a mesh in OBJ, STL, PLY
        or glTF. A mesh spins about its intermediate axis, or wobbles if it is symmetric.
    :param language: code of the language of the captions and the title of a built-in story, en or
        nb; None for that of the scene.
    :param unit: unit of a mesh that is not glTF: mm, cm, m, inch or km.
    :param scale: centimetres per unit of a mesh, in place of ``unit``.
    :param weld: vertices of a mesh that are no farther apart than this are joined, cm.
    :param shell: thickness in cm of a wall along a mesh; None for a solid.
    :param density: density of a mesh in g/cm^3; 1 unless it or the mass is given.
    :param mass: mass of a mesh in g, in place of ``density``.
    :param values: values that replace those of the scene, by their keys in a scene file; also
        ``body``.
    :raises SceneError: for a mistake, which it names with file, line and key.
    :raises FileError: where the file cannot be read.

    Every key of a scene file is an attribute that can be set; ``frame`` of the camera is
    ``camera_frame``. A value that is not allowed is refused and changes nothing.

    ``step``, ``duration`` and ``speed`` follow from the motion where neither the file nor the
    caller gives them. Another ``body`` takes the title, the times and the trail of the scene with
    it, but not those that the caller gave.

    >>> scene = Scene("dzhanibekov", size=(640, 360), method="exact")
    >>> scene.frame(100).shape
    (360, 640, 3)
    """

    title = _Value[str]()
    omega = _Value[Vector]()
    method = _Value[str]()
    step = _Value[float]()
    tolerance = _Value[float]()
    duration = _Value[float]()
    size = _Value[tuple[int, int]]()
    fps = _Value[float]()
    speed = _Value[float]()
    theme = _Value[str]()
    samples = _Value[int]()
    motion_blur = _Value[int]()
    background = _Value[Optional[str]]()
    material = _Value[Optional[str]]()
    color = _Value[Optional[str]]()
    metallic = _Value[Optional[float]]()
    roughness = _Value[Optional[float]]()
    azimuth = _Value[float]()
    elevation = _Value[float]()
    distance = _Value[float]()
    orbit = _Value[float]()
    field_of_view = _Value[float]()
    camera_frame = _Value[str]("frame")
    view = _Value[str]()
    show = _Value[tuple[str, ...]]()
    stress = _Value[Optional[tuple[str, ...]]]()
    compare = _Value[tuple[str, ...]]()
    compare_omega = _Value[Optional[tuple[Vector, ...]]]()
    trail_point = _Value[Optional[Vector]]()
    trail_length = _Value[Optional[float]]()
    font = _Value[str]()

    def __init__(
        self,
        source: StrPath = "dzhanibekov",
        *,
        language: str | None = None,
        unit: str | None = None,
        scale: float | None = None,
        weld: float | None = None,
        shell: float | None = None,
        density: float | None = None,
        mass: float | None = None,
        **values: Any,
    ) -> None:
        name = _arguments.path("source", source)
        # A built-in scene is no file.
        self._inputs = [Path(name)] if os.path.exists(name) else []
        of_mesh = {
            "unit": unit,
            "scale": scale,
            "weld": weld,
            "shell": shell,
            "density": density,
            "mass": mass,
        }
        if language is None and _native.is_mesh_name(name):
            self._native = _scene_of_mesh(name, of_mesh)
        else:
            _require_no_mesh_values(name, of_mesh)
            self._native = _native.Scene.load(
                name, None if language is None else _arguments.text("language", language)
            )
        for note in self._native.notes():
            warnings.warn(note, stacklevel=2)
        self._drawer: _native.FrameDrawer | None = None
        self._set_all(values)

    @classmethod
    def from_toml(cls, text: str, name: str = "scene", **values: Any) -> Scene:
        """The scene of the text of a scene file.

        :param text: the text, in TOML.
        :param name: what stands for the file in messages; paths of meshes start from its folder.
        :param values: values that replace those of the text, as in :class:`Scene`.
        :raises SceneError: for a mistake, which it names with line and key.
        """
        scene = cls.__new__(cls)
        scene._inputs = []
        scene._native = _native.Scene.parse(
            _arguments.text("text", text), _arguments.text("name", name)
        )
        for note in scene._native.notes():
            warnings.warn(note, stacklevel=2)
        scene._drawer = None
        scene._set_all(values)
        return scene

    def _set_all(self, values: dict[str, Any]) -> None:
        if "body" in values:  # first: it takes the scene's own title and times away
            self.body = values["body"]
        for key, value in values.items():
            if key == "body":
                continue
            if isinstance(getattr(type(self), key, None), _Value):
                setattr(self, key, value)
            else:
                self._native.set(key, "null")  # says which keys there are

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_") and not hasattr(type(self), name):
            self._native.set(name, "null")
        super().__setattr__(name, value)

    @property
    def name(self) -> str:
        """The name of the scene, from which names of outputs derive."""
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
    def frame_count(self) -> int:
        """The number of frames: round(duration * fps / speed), or those of all shots."""
        return self._native.frame_count()

    @property
    def times(self) -> Array:
        """The time of the motion that each frame shows, s, (frame_count,)."""
        if self._native.has_shots():
            return np.array(self._native.motion_times(), dtype=np.float64)
        return np.asarray(np.arange(self.frame_count) * self.speed / self.fps, dtype=np.float64)

    def to_dict(self) -> dict[str, Any]:
        """Every value, with the tables, keys and units of a scene file."""
        values: dict[str, Any] = json.loads(self._native.json())
        return values

    def simulate(self) -> Motion:
        """The motion at the times of the frames, by the scene's method.

        Of a film that is told in shots, it is the scene's own motion, at steps of ``speed / fps``.

        :raises MotionError: where the method fails.
        """
        count = round(self.duration * self.fps / self.speed)
        return simulate(
            self.body,
            self.omega,
            np.arange(count) * self.speed / self.fps if self._native.has_shots() else self.times,
            self.method,
            step=self.step,
            tolerance=self.tolerance,
        )

    def __copy__(self) -> Scene:
        scene = type(self).__new__(type(self))
        scene._inputs = list(self._inputs)
        scene._native = _native.Scene(self._native)
        scene._drawer = None
        return scene

    def __getstate__(self) -> dict[str, Any]:
        return {"_inputs": self._inputs, "_native": self._native, "_drawer": None}

    def __deepcopy__(self, _: object) -> Scene:
        return self.__copy__()

    def __repr__(self) -> str:
        width, height = self.size
        return f"<twrench.Scene {self.name}: {self.frame_count} frames of {width}x{height}>"

    # Pictures.

    def frame(self, index: int | None = None, *, time: float | None = None) -> NDArray[np.uint8]:
        """Draws a frame, byte for byte as ``twrench render`` does.

        :param index: number of the frame, from 0; negative ones count from the end.
        :param time: time of the motion in s, in place of ``index``: the frame nearest to it. Not
            for a film that is told in shots, which may show a time twice.
        :returns: (height, width, 3), sRGB; (height, width, 4) with unpremultiplied alpha where the
            background is transparent. Row 0 is the top.
        :raises GlError: where there is no OpenGL.

        The first call opens OpenGL and takes longer. Threads may call it; they take turns.
        """
        return self._drawing().frame(self._index(index, time))

    def png(self, index: int | None = None, *, time: float | None = None) -> bytes:
        """A frame as the PNG file that ``twrench render`` writes.

        ``index`` or ``time``, and errors, are as in :meth:`frame`.
        """
        return self._drawing().png(self._index(index, time))

    def _drawing(self) -> _native.FrameDrawer:
        if self._drawer is None:
            self._drawer = _native.FrameDrawer(_native.Scene(self._native), "auto")
        return self._drawer

    def _index(self, index: int | None, time: float | None) -> int:
        if (index is None) == (time is None):
            raise UsageError("frame: give either index or time")
        count = self.frame_count
        if index is not None:
            number = _arguments.whole("index", index, -count, count - 1)
            return number % count
        if self._native.has_shots():
            raise UsageError("time: may be shown twice by a film told in shots; give index")
        number = round(_arguments.number("time", time) * self.fps / self.speed)
        last = (count - 1) * self.speed / self.fps
        if not 0 <= number < count:
            raise UsageError(f"time: must be from 0 to {last:g} s, not {time}")
        return number

    def _repr_png_(self) -> bytes:
        """The picture of a notebook: the frame at a quarter of the film, where trails are long."""
        return self.png(self.frame_count // 4)

    def render(
        self,
        path: StrPath | None = None,
        *,
        frames_dir: StrPath | None = None,
        frames: str | Iterable[int] | None = None,
        container: str | None = None,
        chapters: bool = True,
        resume: bool = False,
        overwrite: bool = False,
        jobs: int | None = None,
        backend: str = "auto",
        progress: Progress | None = None,
    ) -> Film:
        """Draws the frames and writes the film.

        :param path: the video, .mp4, .mov, .mkv or .webm, or an animated image of the scene's size,
            .gif or .webp; None for frames alone. All but .mp4 and .mkv keep a transparent
            ``background``.
        :param frames_dir: folder for the frames as PNG, with their manifest; None for a video alone.
        :param frames: numbers of the frames, or a range such as ``"0-99:3"``; None for all.
        :param container: mp4, mov, mkv, webm, gif or webp, if the ending of ``path`` does not say.
        :param chapters: make the flips chapters of a video.
        :param resume: keep the intact frames of this scene that are there.
        :param overwrite: replace frames and a video of another scene.
        :param jobs: number of threads that compress frames, 1 to 256; None: half the
            processors, at most 8.
        :param backend: auto, osmesa or egl.
        :param progress: is called with the numbers of frames done and of all, after each frame. An
            exception that it raises ends the run.
        :raises UsageError: where the container cannot keep a transparent background.
        :raises OverwriteError: where something else would be overwritten.
        :raises EncoderError: where ffmpeg is missing or fails.
        :raises FileError: where something cannot be written.
        :raises GlError: where there is no OpenGL.

        A video appears when it is complete, and not at all otherwise. Whatever ends the run, Ctrl-C
        included, the frames that are there are whole and ``resume=True`` continues.
        """
        if path is None and frames_dir is None:
            raise UsageError("render: give path, frames_dir or both")
        if resume and overwrite:
            raise UsageError("render: resume keeps frames and overwrite replaces them; give one")
        if progress is not None and not callable(progress):
            raise UsageError(f"progress: must be callable, not {_arguments.brief(progress)}")
        video = None if path is None else Path(_arguments.path("path", path))
        folder = None if frames_dir is None else Path(_arguments.path("frames_dir", frames_dir))
        existing = "overwrite" if overwrite else "resume" if resume else "none"
        inputs = self._inputs + self._native.input_files()
        count = _native.render(
            self._native,
            video,
            None if container is None else _arguments.text("container", container),
            bool(chapters),
            folder,
            _range(frames),
            existing,
            None if jobs is None else _arguments.whole("jobs", jobs, 1, 256),
            _arguments.text("backend", backend),
            inputs,
            progress,
        )
        return Film(video, folder, count)


def _range(frames: str | Iterable[int] | None) -> str:
    if frames is None:
        return ""
    if isinstance(frames, str):
        if not frames:
            raise UsageError("frames: must be a range such as '0-99', not an empty string")
        return frames
    try:
        numbers = [_arguments.whole("frames", number, 0, 10**7) for number in frames]
    except TypeError as error:
        raise UsageError(f"frames: must be integers, not {_arguments.brief(frames)}") from error
    if not numbers:
        raise UsageError("frames: must name one frame at least")
    return ",".join(str(number) for number in numbers)


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


@dataclass(frozen=True)
class Film:
    """What :meth:`Scene.render` wrote. In a notebook it plays."""

    #: The video; None if none was written.
    path: Path | None
    #: The folder of the frames; None if none were written.
    frames_dir: Path | None
    #: The number of frames.
    frame_count: int

    def _repr_html_(self) -> str | None:
        if self.path is None:
            return None
        data = base64.b64encode(self.path.read_bytes()).decode("ascii")
        try:
            media_type = _native.media_type(self.path)
        except UsageError:  # The ending does not say what the container is.
            media_type = "video/mp4"
        source = f'style="max-width: 100%" src="data:{media_type};base64,{data}"'
        if media_type.startswith("image/"):
            return f"<img {source}>"
        return f"<video controls loop {source}></video>"
