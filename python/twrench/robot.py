"""Robot descriptions and the inertia of their links."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, Mapping, Sequence

from . import _arguments, _native, _tables
from ._arguments import Array
from .body import Body
from .names import StrPath

__all__ = ["LinkFinding", "Repaired", "Robot", "RobotLink"]


@dataclass(frozen=True)
class LinkFinding:
    """A fault of a link's mass properties, or a mistake that explains them."""

    #: Its name, one of those in docs/robots.md: ``triangle``, ``products_sign``.
    fault: str
    #: The same as a sentence without its end.
    text: str
    #: For a mistake: the greatest difference from the moments of the geometry without it, relative
    #: to the greatest moment; None if there is no geometry to compare with.
    misfit: float | None
    #: That geometry; empty if there is none.
    geometry: str


@dataclass(frozen=True, eq=False)
class RobotLink:
    """The mass properties of a link as the file states them, and the judgement on them."""

    #: Its name.
    name: str
    #: The line of the file.
    line: int
    #: ``good``; ``unstated``: the file has none; ``doubtful``: a body can have them, but not this
    #: one, or a mistake explains them better; ``impossible``: no body has them.
    verdict: Literal["good", "unstated", "doubtful", "impossible"]
    #: Mass in kg.
    mass: float
    #: Centre of mass in m, (3,), in the frame of the link.
    centre_of_mass: Array
    #: Inertia matrix about the centre of mass in kg m^2, (3, 3), in the axes of the link.
    inertia: Array
    #: Principal moments of inertia in kg m^2, (3,), ascending.
    principal_moments: Array
    #: The faults, the worst first.
    faults: tuple[LinkFinding, ...]
    #: Mistakes that explain them, equally well if there are several.
    mistakes: tuple[LinkFinding, ...]
    _robot: _native.JudgedRobot
    _index: int

    @property
    def body(self) -> Body:
        """The link as a body in g and cm: it moves by these mass properties, and is drawn as the
        link's geometry.

        :raises UsageError: if it has no mass properties, or none that a body can move by.
        """
        return Body._wrap(self._robot.body(self._index))


@dataclass(frozen=True)
class Repaired:
    """A robot description with repaired numbers."""

    #: The bytes of the file; only the numbers of the changed links differ.
    text: bytes
    #: The reason of the change of each link that was changed.
    changes: Mapping[str, str]
    #: The reason why a link that needs a repair got none.
    unrepaired: Mapping[str, str]


class Robot:
    """A robot description in URDF, SDF or MJCF, with a judgement on each link.

    >>> robot = Robot.read("arm.urdf")  # doctest: +SKIP
    >>> robot.links["forearm"].verdict  # doctest: +SKIP
    'impossible'
    """

    _native: _native.JudgedRobot

    @classmethod
    def read(cls, path: StrPath, *, package_path: Sequence[StrPath] = ()) -> Robot:
        """Read a robot description and its meshes.

        What is not read, such as a mesh that is missing, is a warning.

        :param path: a file in URDF, SDF or MJCF; its root element decides.
        :param package_path: folders that contain the packages or models of the file; the folders
            above it are searched too.
        :raises UsageError: for a mistake in the file.
        :raises FileError: if the file cannot be read.
        """
        robot = cls.__new__(cls)
        folders = [_arguments.path("package_path", folder) for folder in package_path]
        robot._native = _native.JudgedRobot(_arguments.path("path", path), folders)
        for note in robot._native.notes:
            warnings.warn(note, stacklevel=2)
        return robot

    @property
    def name(self) -> str:
        """The name that the file gives."""
        return self._native.name

    @property
    def format(self) -> str:
        """``urdf``, ``sdf`` or ``mjcf``."""
        return self._native.format

    @property
    def links(self) -> dict[str, RobotLink]:
        """The links by their names, in the order of the file."""
        links = {}
        for index, values in enumerate(self._native.links):
            for key in ("faults", "mistakes"):
                values[key] = tuple(LinkFinding(**finding) for finding in values[key])
            links[values["name"]] = RobotLink(**values, _robot=self._native, _index=index)
        return links

    def repaired(self, *, from_mesh: bool = False) -> Repaired:
        """The file with repaired numbers: mistakes undone, or else the nearest possible moments.

        :param from_mesh: give links that no mistake explains the moments of their geometry with
            uniform density.
        """
        text, changes, unrepaired = self._native.repaired(from_mesh)
        return Repaired(text, dict(changes), dict(unrepaired))

    def report(self, path: StrPath, *, from_mesh: bool = False, overwrite: bool = False) -> Path:
        """Writes a page with the verdicts, as ``twrench inertia --report`` does.

        It has pictures of links that are not good, before and after the repair.

        :param path: the file, .html.
        :param from_mesh: the kind of repair, as for :meth:`repaired`.
        :param overwrite: replace an existing file that twrench did not write.
        :returns: the path.
        :raises UsageError: for another ending.
        :raises FileError: if the file cannot be written.
        :raises OverwriteError: if another file would be replaced.
        :raises Error: if the pictures cannot be drawn.
        """
        file = Path(_arguments.path("path", path))
        inputs = self._native.inputs
        output = _native.Output("robot report", file, inputs, bool(overwrite), "")
        _native.write_output(output, self._native.page(bool(from_mesh)).encode())
        return output.path

    def __repr__(self) -> str:
        bad = sum(link.verdict == "impossible" for link in self.links.values())
        return f"<twrench.Robot: {self.name}, {len(self.links)} links, {bad} impossible>"

    def _repr_html_(self) -> str:
        """A table of the links for notebooks."""
        return _tables.of_properties({name: link.verdict for name, link in self.links.items()})
