"""The exceptions of twrench, all of which derive from :class:`Error`.

``str(error)`` is one line that names the argument or the file, describes the problem and usually
proposes a remedy; ``error.remedy`` is only the remedy.
"""

from __future__ import annotations

import re
from contextlib import contextmanager
from typing import Iterator

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


_NUMBERS = r"[-+.\de]+(?:,[-+.\de]+)+"
_AXIS = "-?[xyz]"
_ANGLES = "(?:rad|deg|rev|rpm)"
#: The values that messages give to options.
_VALUES = {
    "columns": r"'.*?'(?![^\s:;,.)])",
    "time-unit": "(?:min|ms|us|ns|s|h)",
    "units": _ANGLES,
    "angle-units": _ANGLES,
    "sequence": "[xyz]{3}",
    "rates": "(?:body|space)",
    "axes": f"{_AXIS},{_AXIS},{_AXIS}",
    "offset": _NUMBERS,
    "inertia": _NUMBERS,
}
_WITH_VALUE = "|".join(f"{option} {value}" for option, value in _VALUES.items())
_OPTION = re.compile(rf"--(?:(?P<with_value>{_WITH_VALUE})(?!\w)|(?P<alone>[a-z][a-z-]*))")


def _argument_of(option: re.Match[str]) -> str:
    if option["alone"]:
        is_flag = option["alone"] in ("fit", "inverse")
        return option["alone"].replace("-", "_") + ("=True" if is_flag else "")
    name, value = option["with_value"].split(" ", 1)
    if name == "columns":
        columns = re.findall(r"""(\w+)=("(?:[^"]|"")*"|[^,]*)""", value[1:-1])
        named = {
            ours: theirs[1:-1].replace('""', '"') if theirs.startswith('"') else theirs
            for ours, theirs in columns
        }
        return f"columns={named}"
    if name == "inertia":
        return f"body=Body(moments=[{value.replace(',', ', ')}])"
    if name == "offset":
        return f"offset=[{value.replace(',', ', ')}]"
    # In the program, the axes of every sequence turn with the body.
    return f'{name.replace("-", "_")}="{value.upper() if name == "sequence" else value}"'


def as_arguments(text: str) -> str:
    """Replaces the options in a text of the libraries by the arguments of the same names."""
    text = re.sub(
        r"\bsequence( of the angles is)? ([xyz]{3})\b",
        lambda found: f"sequence{found[1] or ''} {found[2].upper()}",
        _OPTION.sub(_argument_of, text),
    )
    return text.replace("leave the option out", "leave the argument out")


@contextmanager
def argument_names() -> Iterator[None]:
    """Replaces the options in error messages of the libraries by the arguments of the same names."""
    try:
        yield
    except UsageError as error:
        raise type(error)(as_arguments(error.message), as_arguments(error.remedy)) from None
