"""The exceptions of twrench, all of which derive from :class:`Error`.

``str(error)`` is one line that names the argument or the file, describes the problem and usually
proposes a remedy; ``error.remedy`` is only the remedy.
"""

from __future__ import annotations

__all__ = [
    "EncoderError",
    "Error",
    "FileError",
    "GlError",
    "MotionError",
    "OverwriteError",
    "SceneError",
    "UsageError",
]


class Error(Exception):
    """The base class of all exceptions for problems that the caller can act on."""

    def __init__(self, message: str, remedy: str = "") -> None:
        super().__init__(f"{message}; {remedy}" if remedy else message)
        self.message = message
        self.remedy = remedy

    def __reduce__(self) -> tuple[type[Error], tuple[str, str]]:
        return type(self), (self.message, self.remedy)

    def __str__(self) -> str:
        return str(self.args[0])


class UsageError(Error, ValueError):
    """An argument has a wrong type, shape or value."""


class SceneError(UsageError):
    """A scene has a wrong value, or its file has a mistake; the message names file, line and key."""


class MotionError(Error):
    """A method cannot compute the motion, though each argument is allowed."""


class GlError(Error):
    """There is no usable OpenGL, or it cannot draw the requested picture."""


class EncoderError(Error):
    """ffmpeg is missing, lacks the encoder, or failed."""


class FileError(Error, OSError):
    """A file or folder cannot be read or written."""


class OverwriteError(FileError):
    """An output would overwrite something without permission."""
