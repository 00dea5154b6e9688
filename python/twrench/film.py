"""Rendered films and pictures, and the encoding of frames."""

from __future__ import annotations

import base64
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterable, Iterator, Literal, Union

from . import _arguments, _native
from .errors import UsageError
from .names import ContainerName, EffortName, StrPath

__all__ = ["Film", "Picture", "encode"]

#: A function of the number of finished frames and of all frames; True for a tqdm bar if installed.
Progress = Union[Callable[[int, int], object], bool]


@dataclass(frozen=True)
class Film:
    """The files that :meth:`Scene.render` or :func:`encode` wrote. In a notebook the film plays."""

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
        except UsageError:  # The extension does not determine the container.
            media_type = "video/mp4"
        source = f'style="max-width: 100%" src="data:{media_type};base64,{data}"'
        if media_type.startswith("image/"):
            return f"<img {source}>"
        return f"<video controls loop {source}></video>"


@dataclass(frozen=True)
class Picture:
    """A picture, which a notebook shows."""

    #: The bytes of the PNG file.
    png: bytes

    def _repr_png_(self) -> bytes:
        return self.png


def encode(
    frames_dir: StrPath,
    path: StrPath,
    *,
    container: ContainerName | None = None,
    chapters: bool = True,
    encode: EffortName | None = None,
    crf: int | None = None,
    width: int | None = None,
    audio: StrPath | None = None,
    sound: Literal["none"] | None = None,
    allow_missing: bool = False,
    overwrite: bool = False,
    progress: Progress = True,
) -> Film:
    """Encodes a film from frames that were rendered earlier, as ``twrench encode`` does.

    :param frames_dir: folder with frames and their manifest, or the manifests of all shards.
    :param path: the video or the animated image.
    :param container: mp4, mov, mkv, webm, gif or webp; None to choose it by the ending of ``path``.
    :param chapters: start a chapter of the video at each flip.
    :param encode: as in :meth:`Scene.render`.
    :param crf: as in :meth:`Scene.render`.
    :param width: width of an animated image in pixels; None for that of the frames, but at most 640.
    :param audio: a sound file under the video, trimmed to it or followed by silence.
    :param sound: "none" leaves out the sound of the scene, which the frames do not contain;
        :meth:`Scene.render` with ``resume`` adds it.
    :param allow_missing: encode the frames that exist even if some are missing.
    :param overwrite: replace an existing video of another motion.
    :param progress: as in :meth:`Scene.render`.
    :raises UsageError: for a wrong argument.
    :raises OverwriteError: if another file would be overwritten.
    :raises EncoderError: if ffmpeg is missing or fails.
    :raises FileError: if frames are missing or damaged, or the film cannot be written.
    """
    folder = Path(_arguments.path("frames_dir", frames_dir))
    video = Path(_arguments.path("path", path))
    chosen = None if container is None else _arguments.text("container", container)
    pixels = None if width is None else _arguments.whole("width", width, 1, 2**31 - 1)
    track = None if audio is None else Path(_arguments.path("audio", audio))
    if sound not in (None, "none"):
        raise UsageError(f"sound: must be 'none' or None, not {_arguments.brief(sound)}")
    with reporting(progress) as report:
        count = _native.encode(
            folder,
            video,
            chosen,
            bool(chapters),
            *quality(encode, crf),
            pixels,
            track,
            sound is not None,
            bool(allow_missing),
            bool(overwrite),
            report,
        )
    return Film(video, None, count)


def quality(encode: str | None, crf: int | None) -> tuple[str | None, int | None]:
    """The effort and the quality of a video. The codec checks the range of the quality."""
    return (
        None if encode is None else _arguments.text("encode", encode),
        None if crf is None else _arguments.whole("crf", crf, 0, 2**31 - 1),
    )


@contextmanager
def reporting(progress: Progress) -> Iterator[Callable[[int, int], object] | None]:
    """Yields the function to call after each frame. The bar is closed however the run ends."""
    if not isinstance(progress, bool):
        if not callable(progress):
            raise UsageError(
                f"progress: must be a function, True or False, not {_arguments.brief(progress)}"
            )
        yield progress
        return
    tqdm = _tqdm() if progress else None
    if tqdm is None:
        yield None
        return
    with tqdm(unit="frame") as bar:

        def show(done: int, total: int) -> None:
            bar.total = total
            bar.update(done - bar.n)

        yield show


def _tqdm() -> Any:
    """The bar of tqdm; None if tqdm is not installed."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm


def frame_range(frames: str | Iterable[int] | None) -> str:
    if frames is None:
        return ""
    if isinstance(frames, str):
        if not frames:
            raise UsageError("frames: must be a range such as '0-99', not an empty string")
        return _arguments.text("frames", frames)
    try:
        numbers = [_arguments.whole("frames", number, 0, 10**7) for number in frames]
    except TypeError as error:
        raise UsageError(f"frames: must be integers, not {_arguments.brief(frames)}") from error
    if not numbers:
        raise UsageError("frames: must name one frame at least")
    return ",".join(str(number) for number in numbers)
