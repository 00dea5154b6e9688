"""Rigid bodies and their mass properties."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass
from typing import Literal, Protocol, Sequence, cast

import numpy as np

from . import _arguments, _native, _tables
from ._arguments import Array
from .errors import UsageError
from .names import Numbers, Rows, ShapeName, StrPath
from .solids import Part, native_parts

__all__ = ["Body", "InSI", "Stability"]


@dataclass(frozen=True)
class Stability:
    """The behaviour of a small tilt of a steady rotation about a principal axis (docs/theory.md)."""

    #: ``unstable``: it grows as exp(rate t); ``stable``: it wobbles as cos(rate t); ``neutral``:
    #: neither, because another axis has the same moment, to 1e-4, or the body is at rest.
    kind: Literal["unstable", "stable", "neutral"]
    #: Rate of growth in 1/s or angular frequency in rad/s; 0 if neutral.
    rate: float

    @property
    def doubling_time(self) -> float:
        """The time in s in which an unstable tilt doubles; infinite otherwise."""
        return math.log(2) / self.rate if self.kind == "unstable" else math.inf

    @property
    def period(self) -> float:
        """The time in s of one turn of a stable wobble; infinite otherwise."""
        return 2 * math.pi / self.rate if self.kind == "stable" else math.inf


@dataclass(frozen=True)
class InSI:
    """The mass properties of a body in SI units."""

    #: Mass in kg; NaN unless the body was given by its parts.
    mass: float
    #: Centre of mass in m, (3,).
    centre_of_mass: Array
    #: Inertia matrix about the centre of mass in kg m^2, (3, 3), in body axes.
    inertia: Array
    #: Principal moments of inertia in kg m^2, (3,), ascending.
    principal_moments: Array


class HasBody(Protocol):
    """An object with a body: a :class:`Scene`, whose module imports this one."""

    @property
    def body(self) -> Body: ...


class Body:
    """A rigid body, given in exactly one of three ways.

    :param parts: homogeneous solids that overlap nowhere.
    :param moments: principal moments of inertia about the body's x, y and z axes in g cm^2, (3,).
    :param inertia: inertia matrix about the centre of mass in g cm^2, (3, 3), symmetric and positive
        definite; or its six entries Ixx, Iyy, Izz, Ixy, Ixz, Iyz, (6,), as in MuJoCo's
        ``fullinertia``. ``Ixy`` is minus the integral of x y dm.
    :param shape: the solid to draw for ``moments`` or ``inertia``, along the principal axes: box,
        ellipsoid or cross.
    :raises UsageError: for a length, a density, a moment or a mesh that no body has.
    :raises FileError: if the file of a mesh cannot be read.

    Repairs to a mesh, and moments that no real body has, are reported as warnings.

    >>> body = Body(moments=[1, 2, 3])
    >>> body.principal_moments
    array([1., 2., 3.])
    >>> Body(inertia=[2, 2, 3, 1, 0, 0]).inertia
    array([[2., 1., 0.],
           [1., 2., 0.],
           [0., 0., 3.]])
    """

    def __init__(
        self,
        parts: Sequence[Part] | None = None,
        *,
        moments: Numbers | None = None,
        inertia: Numbers | Rows | None = None,
        shape: ShapeName | None = None,
    ) -> None:
        if sum(way is not None for way in (parts, moments, inertia)) != 1:
            raise UsageError("Body: give exactly one of parts, moments and inertia")
        if shape is not None and parts is not None:
            raise UsageError("shape: is for a body given by moments or inertia")
        form = _arguments.text("shape", "box" if shape is None else shape)
        if parts is not None:
            self._native = _native.Body.from_parts(native_parts(parts))
        elif moments is not None:
            self._native = _native.Body.from_moments(_arguments.vector("moments", moments), form)
        elif inertia is not None:
            matrix = _arguments.inertia("inertia", inertia)
            self._native = _native.Body.from_inertia(matrix, form)
        for note in self._native.notes:
            warnings.warn(note, stacklevel=2)

    @classmethod
    def from_scene(cls, scene: StrPath | HasBody) -> Body:
        """The body of a ``scene``: a :class:`Scene`, a scene file, or the name of a built-in scene.

        :raises SceneError: for a mistake in the file, or an unknown name.
        :raises FileError: if the file cannot be read.
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

    def inertia_about(self, point: Numbers) -> Array:
        """Inertia matrix about a point in g cm^2, (3, 3), in body axes: the parallel-axis theorem.

        :param point: the point in cm, (3,), in the frame in which the parts were placed.
        :raises UsageError: for a wrong point, or if the mass is not known.
        """
        if self.mass != self.mass:
            raise UsageError("inertia_about: needs the mass of the body, which is not given")
        return self._native.inertia_about(
            _arguments.array("point", point, (3,), "a point in cm")
        )

    @property
    def si(self) -> InSI:
        """The mass properties in SI units."""
        return InSI(
            self.mass / 1e3,
            np.asarray(self.centre_of_mass / 1e2, dtype=np.float64),
            np.asarray(self.inertia / 1e7, dtype=np.float64),
            np.asarray(self.principal_moments / 1e7, dtype=np.float64),
        )

    @property
    def principal_moments(self) -> Array:
        """Principal moments of inertia in g cm^2, (3,), ascending."""
        return self._native.moments

    @property
    def principal_axes(self) -> Array:
        """Rotation body_from_principal, (3, 3): column i is the axis of ``principal_moments[i]``."""
        return self._native.axes

    def stability(self, omega: float = 1.0) -> tuple[Stability, Stability, Stability]:
        """The stability of a steady rotation at ``omega`` rad/s about each principal axis, in the
        order of ``principal_moments``.

        :raises UsageError: if ``omega`` is not finite.

        >>> [axis.kind for axis in Body(moments=[3, 4, 5]).stability()]
        ['stable', 'unstable', 'stable']
        """
        rate = _arguments.number("omega", omega)
        least, middle, greatest = _native.stability(self.principal_moments, rate)
        return _stability(*least), _stability(*middle), _stability(*greatest)

    def stabilizing_wheel(self, omega: float = 1.0) -> float:
        """The angular momentum in g cm^2/s above which a wheel along the intermediate axis makes a
        rotation at ``omega`` rad/s about that axis stable.

        :raises UsageError: if ``omega`` is not finite.
        """
        rate = _arguments.number("omega", omega)
        return _native.stabilizing_wheel(self.principal_moments, rate)

    def _properties(self) -> dict[str, str]:
        """The mass, if it is known, and the principal moments, in words."""
        moments = ", ".join(f"{moment:.6g}" for moment in self.principal_moments)
        mass = {} if self.mass != self.mass else {"mass": f"{self.mass:.6g} g"}
        return mass | {"principal moments": f"{moments} g cm^2"}

    def __repr__(self) -> str:
        properties = ", ".join(f"{name} {value}" for name, value in self._properties().items())
        return f"<twrench.Body: {properties}>"

    def _repr_html_(self) -> str:
        """A table of its properties for notebooks."""
        return _tables.of_properties(self._properties())


def _stability(kind: str, rate: float) -> Stability:
    return Stability(cast(Literal["unstable", "stable", "neutral"], kind), rate)
