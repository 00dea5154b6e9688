"""Rigid bodies and their mass properties."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Sequence, Union

from numpy.typing import ArrayLike

from . import _arguments, _native
from ._arguments import Array
from .errors import UsageError

if TYPE_CHECKING:
    from os import PathLike

    from .scene import Scene

__all__ = ["Body", "Box", "Cylinder", "Ellipsoid", "Part", "Sphere"]


@dataclass(frozen=True)
class _Solid:
    """A homogeneous solid, placed in the frame in which the body is described."""

    #: Density in g/cm^3.
    density: float
    #: Position of the centre in cm, three numbers.
    position: ArrayLike = (0.0, 0.0, 0.0)
    #: Direction of the solid's own z axis, three numbers of any length but 0; or None.
    axis: ArrayLike | None = None
    #: Rotation vector in rad, three numbers, in place of ``axis``; or None.
    rotation: ArrayLike | None = None

    def _part(self, shape: str, size: Sequence[float]) -> _native.Part:
        if self.axis is not None and self.rotation is not None:
            raise UsageError("rotation: cannot be combined with axis")
        axis = None if self.axis is None else _arguments.vector("axis", self.axis)
        if axis is not None and not axis.any():
            raise UsageError("axis: must not be zero")
        rotation = None if self.rotation is None else _arguments.vector("rotation", self.rotation)
        density = _arguments.number("density", self.density)
        position = _arguments.vector("position", self.position)
        return _native.Part(shape, size, density, position, axis, rotation)

    def _native_part(self) -> _native.Part:
        raise NotImplementedError


@dataclass(frozen=True, kw_only=True)
class Cylinder(_Solid):
    """A solid cylinder whose axis is its own z axis."""

    #: Radius in cm.
    radius: float
    #: Length in cm.
    length: float

    def _native_part(self) -> _native.Part:
        radius = _arguments.number("radius", self.radius)
        return self._part("cylinder", [radius, _arguments.number("length", self.length), 0.0])


@dataclass(frozen=True, kw_only=True)
class Box(_Solid):
    """A solid box."""

    #: Lengths of the edges along its own x, y and z axes in cm.
    size: ArrayLike

    def _native_part(self) -> _native.Part:
        return self._part("box", list(_arguments.vector("size", self.size)))


@dataclass(frozen=True, kw_only=True)
class Ellipsoid(_Solid):
    """A solid ellipsoid."""

    #: Semi-axes along its own x, y and z axes in cm.
    radii: ArrayLike

    def _native_part(self) -> _native.Part:
        return self._part("ellipsoid", list(_arguments.vector("radii", self.radii)))


@dataclass(frozen=True, kw_only=True)
class Sphere(_Solid):
    """A solid sphere."""

    #: Radius in cm.
    radius: float

    def _native_part(self) -> _native.Part:
        return self._part("ellipsoid", 3 * [_arguments.number("radius", self.radius)])


Part = Union[Cylinder, Box, Ellipsoid, Sphere]


class Body:
    """A rigid body, given in exactly one of three ways.

    :param parts: homogeneous solids that overlap nowhere.
    :param moments: principal moments of inertia about the body's x, y and z axes in g cm^2, (3,).
    :param inertia: inertia matrix about the centre of mass in g cm^2, (3, 3), symmetric and positive
        definite. Such a body can be integrated, but not shown in a scene.
    :raises UsageError: for a length, a density or a moment that no body has.

    >>> body = Body(moments=[1, 2, 3])
    >>> body.principal_moments
    array([1., 2., 3.])
    """

    def __init__(
        self,
        parts: Sequence[Part] | None = None,
        *,
        moments: ArrayLike | None = None,
        inertia: ArrayLike | None = None,
    ) -> None:
        if sum(way is not None for way in (parts, moments, inertia)) != 1:
            raise UsageError("Body: give exactly one of parts, moments and inertia")
        if parts is not None:
            self._native = _native.Body.from_parts(_native_parts(parts))
        elif moments is not None:
            self._native = _native.Body.from_moments(_arguments.vector("moments", moments))
        elif inertia is not None:
            matrix = _arguments.array("inertia", inertia, (3, 3), "an array of shape (3, 3)")
            self._native = _native.Body.from_inertia(matrix)

    @classmethod
    def from_scene(cls, scene: str | PathLike[str] | Scene) -> Body:
        """The body of a ``scene``: a :class:`Scene`, a scene file, or the name of a built-in scene.

        :raises SceneError: for a mistake in the file, or a name that no scene has.
        :raises FileError: where the file cannot be read.
        """
        body = getattr(scene, "body", None)
        if isinstance(body, Body):
            return body
        return cls._wrap(_native.Scene.load(_arguments.path("scene", scene)).body)

    @classmethod
    def _wrap(cls, native: _native.Body) -> Body:
        body = cls.__new__(cls)
        body._native = native
        return body

    @property
    def mass(self) -> float:
        """Mass in g; NaN unless the body was given by its parts."""
        return self._native.mass

    @property
    def centre_of_mass(self) -> Array:
        """Centre of mass in cm, (3,), in the frame in which the parts were placed."""
        return self._native.centre_of_mass

    @property
    def inertia(self) -> Array:
        """Inertia matrix about the centre of mass in g cm^2, (3, 3), in body axes."""
        return self._native.inertia

    @property
    def principal_moments(self) -> Array:
        """Principal moments of inertia in g cm^2, (3,), ascending."""
        return self._native.moments

    @property
    def principal_axes(self) -> Array:
        """Rotation body_from_principal, (3, 3): column i is the axis of ``principal_moments[i]``."""
        return self._native.axes

    def __repr__(self) -> str:
        moments = ", ".join(f"{moment:.6g}" for moment in self.principal_moments)
        mass = "" if self.mass != self.mass else f"mass {self.mass:.6g} g, "
        return f"<twrench.Body: {mass}principal moments {moments} g cm^2>"


def _native_parts(parts: Sequence[Part]) -> list[_native.Part]:
    form = "a sequence of Cylinder, Box, Ellipsoid and Sphere"
    try:
        solids = list(parts)
    except TypeError as error:
        raise UsageError(f"parts: must be {form}, not {_arguments.brief(parts)}") from error
    for solid in solids:
        if not isinstance(solid, _Solid):
            raise UsageError(f"parts: must be {form}, but has {_arguments.brief(solid)}")
    return [solid._native_part() for solid in solids]
