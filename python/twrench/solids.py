"""The parts of rigid bodies: homogeneous solids."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, ClassVar, Optional, Sequence, TypeVar, Union

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _native
from ._arguments import Array
from .errors import UsageError
from .names import MaterialName, Numbers, Rows, StrPath, UnitName

__all__ = [
    "Box",
    "Capsule",
    "Cone",
    "Cylinder",
    "Ellipsoid",
    "Mesh",
    "Part",
    "Sphere",
    "Torus",
    "Tube",
]

T = TypeVar("T")


@dataclass(frozen=True, kw_only=True)
class Solid:
    """A homogeneous solid, placed in the frame in which the body is described."""

    _name: ClassVar[str]  # its name in scene files; its dimensions are attributes

    def __post_init__(self) -> None:
        self._refusing_by_name(self._check)

    def _refusing_by_name(self, work: Callable[[], T]) -> T:
        """Calls `work`; the messages of its errors name this solid."""
        try:
            return work()
        except UsageError as error:
            solid = type(self).__name__ + (f" {self.name!r}" if self.name else "")
            raise UsageError(f"{solid}: {error.message}", error.remedy) from None

    def _check(self) -> None:
        self._place_and_look()
        self._shape().volume  # rejects invalid dimensions

    #: Density in g/cm^3; give it or ``mass``.
    density: float | None = None
    #: Position of the solid's own origin in cm, three numbers.
    position: Numbers = (0.0, 0.0, 0.0)
    #: Direction of the solid's own z axis, three numbers of any length but 0; or None.
    axis: Numbers | None = None
    #: Rotation vector in rad, three numbers, instead of ``axis``; or None.
    rotation: Numbers | None = None
    #: Mass in g, instead of ``density``.
    mass: float | None = None
    #: Its name; parts with the same name belong together.
    name: str = ""
    #: Steel, brass, wood, plastic, rubber, rock or paper; None for the look of the scene.
    material: MaterialName | None = None
    #: #rrggbb, #rgb, black, gray or white, instead of the material's colour.
    color: str | None = None
    #: Metalness, 0 (paint) to 1 (metal), instead of the material's.
    metallic: float | None = None
    #: Roughness, 0.05 (mirror) to 1 (chalk), instead of the material's.
    roughness: float | None = None

    def _shape(self) -> _native.Shape:
        numbers: list[float] = []
        for key, count in _native.shapes[self._name]:
            value = getattr(self, key)
            if count == 1:
                numbers.append(_arguments.number(key, value))
            else:
                numbers.extend(_arguments.vector(key, value))
        return _native.solid(self._name, numbers)

    def _crease(self) -> float | None:
        return None

    def _native_part(self) -> _native.Part:
        return _native.Part(self._refusing_by_name(self._shape), *self._place_and_look())

    def _place_and_look(self) -> _PlaceAndLook:
        if self.axis is not None and self.rotation is not None:
            raise UsageError("rotation: cannot be combined with axis")
        axis = None if self.axis is None else _arguments.vector("axis", self.axis)
        if axis is not None and not axis.any():
            raise UsageError("axis: must not be zero")
        rotation = None if self.rotation is None else _arguments.vector("rotation", self.rotation)
        if (self.density is None) == (self.mass is None):
            raise UsageError("density: give exactly one of density and mass")
        density = None if self.density is None else _arguments.positive("density", self.density)
        mass = 0.0 if self.mass is None else _arguments.positive("mass", self.mass)
        position = _arguments.vector("position", self.position)
        name = _arguments.text("name", self.name)
        return density, mass, position, axis, rotation, name, self._look()

    def _look(self) -> _native.Look:
        return _native.Look(
            "" if self.material is None else _arguments.text("material", self.material),
            "" if self.color is None else _arguments.text("color", self.color),
            _number_or_none("metallic", self.metallic),
            _number_or_none("roughness", self.roughness),
            self._crease(),
        )


_PlaceAndLook = tuple[
    Optional[float], float, Array, Optional[Array], Optional[Array], str, _native.Look
]


def _number_or_none(name: str, value: float | None) -> float | None:
    return None if value is None else _arguments.number(name, value)


@dataclass(frozen=True, kw_only=True)
class Cylinder(Solid):
    """A solid cylinder whose axis is its own z axis, with its origin in the centre."""

    _name = "cylinder"

    #: Radius in cm.
    radius: float
    #: Length in cm.
    length: float


@dataclass(frozen=True, kw_only=True)
class Box(Solid):
    """A solid box, with its origin in the centre."""

    _name = "box"

    #: Lengths of the edges along its own x, y and z axes in cm.
    size: Numbers


@dataclass(frozen=True, kw_only=True)
class Ellipsoid(Solid):
    """A solid ellipsoid, with its origin in the centre."""

    _name = "ellipsoid"

    #: Semi-axes along its own x, y and z axes in cm.
    radii: Numbers


@dataclass(frozen=True, kw_only=True)
class Sphere(Solid):
    """A solid sphere, with its origin in the centre."""

    #: Radius in cm.
    radius: float

    def _shape(self) -> _native.Shape:
        return _native.solid("ellipsoid", 3 * [_arguments.positive("radius", self.radius)])


@dataclass(frozen=True, kw_only=True)
class Cone(Solid):
    """A solid cone, or a frustum, whose axis is its own z axis, with its origin halfway between base
    and top."""

    _name = "cone"

    #: Radius of the base, at z = -length/2, in cm.
    radius: float
    #: Length in cm.
    length: float
    #: Radius of the top, at z = length/2, in cm; 0 for a cone with an apex.
    top_radius: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Torus(Solid):
    """A solid ring torus in its own xy plane, with its origin in the centre."""

    _name = "torus"

    #: Radius of the circle in the middle of the tube in cm.
    radius: float
    #: Radius of the tube in cm, less than ``radius``.
    tube_radius: float


@dataclass(frozen=True, kw_only=True)
class Capsule(Solid):
    """A solid cylinder with hemispherical ends, whose axis is its own z axis, with its origin in the
    centre."""

    _name = "capsule"

    #: Radius of the cylinder and of its ends in cm.
    radius: float
    #: Length of the cylinder, between the centres of the hemispheres, in cm.
    length: float


@dataclass(frozen=True, kw_only=True)
class Tube(Solid):
    """A cylinder with a coaxial hole from end to end, whose axis is its own z axis, with its origin in
    the centre."""

    _name = "tube"

    #: Outer radius in cm.
    radius: float
    #: Radius of the hole in cm, less than ``radius``.
    inner_radius: float
    #: Length in cm.
    length: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Mesh(Solid):
    """The solid inside a closed surface of triangles, or a thin wall along a surface. Its origin is
    that of the surface's coordinates.

    The surface is a ``file``, or ``vertices`` and ``triangles``. It is read and checked when a
    :class:`Body` is made of it.
    """

    _name = "mesh"

    def _check(self) -> None:
        self._place_and_look()

    #: An OBJ, STL, PLY, glTF, COLLADA or 3MF file, or the name of a built-in mesh.
    file: StrPath | None = None
    #: Coordinates of the vertices, (n, 3).
    vertices: Rows | None = None
    #: Indices of the vertices of each triangle, counter-clockwise as seen from outside, (m, 3).
    triangles: Rows | None = None
    #: sRGB colours of ``vertices``, each component from 0 to 1, (n, 3).
    colors: Rows | None = None
    #: Unit of the coordinates: mm, cm, m, inch or km. A file in glTF, COLLADA or 3MF needs none, and
    #: arrays without one are in cm.
    unit: UnitName | None = None
    #: Centimetres per unit, instead of ``unit``.
    scale: float | None = None
    #: Distance in cm up to which vertices are joined.
    weld: float = 0.0
    #: Thickness of the wall in cm; None for a solid.
    shell: float | None = None
    #: The largest angle in rad between triangles that are drawn as one smooth surface; 0 draws flat
    #: facets, None is 35 degrees.
    crease: float | None = None

    def _shape(self) -> _native.Shape:
        scale = mesh_scale(self.unit, self.scale)
        weld = _arguments.number("weld", self.weld)
        shell = 0.0 if self.shell is None else _arguments.positive("shell", self.shell)
        if self.file is not None:
            if any(given is not None for given in (self.vertices, self.triangles, self.colors)):
                raise UsageError("file: cannot be combined with vertices, triangles and colors")
            return _native.mesh_of_file(_arguments.path("file", self.file), scale, weld, shell)
        if self.vertices is None or self.triangles is None:
            raise UsageError("vertices: give either file, or vertices and triangles")
        vertices = _arguments.vectors("vertices", self.vertices)
        triangles = _arguments.indices("triangles", self.triangles, len(vertices))
        colors = self._vertex_colors(len(vertices))
        return _native.mesh_of_arrays(vertices, triangles, colors, scale, weld, shell)

    def _vertex_colors(self, count: int) -> NDArray[np.float32]:
        if self.colors is None:
            return np.empty((0, 3), np.float32)
        form = f"an array of shape ({count}, 3)"
        colors = _arguments.array("colors", self.colors, (count, 3), form)
        if ((colors < 0) | (colors > 1)).any():
            raise UsageError("colors: must be from 0 to 1")
        return colors.astype(np.float32)

    def _crease(self) -> float | None:
        return _number_or_none("crease", self.crease)


def mesh_scale(unit: str | None, scale: float | None) -> float | None:
    """The centimetres per unit of a mesh; None if neither argument is given."""
    if unit is None:
        return None if scale is None else _arguments.positive("scale", scale)
    if scale is not None:
        raise UsageError("scale: cannot be combined with unit")
    return _native.unit_length("unit", _arguments.text("unit", unit))


Part = Union[Cylinder, Box, Ellipsoid, Sphere, Cone, Torus, Capsule, Tube, Mesh]


def native_parts(parts: Sequence[Part]) -> list[_native.Part]:
    form = "a sequence of solids such as Cylinder, Box and Mesh"
    try:
        solids = list(parts)
    except TypeError as error:
        raise UsageError(f"parts: must be {form}, not {_arguments.brief(parts)}") from error
    for solid in solids:
        if not isinstance(solid, Solid):
            raise UsageError(f"parts: must be {form}, but has {_arguments.brief(solid)}")
    return [solid._native_part() for solid in solids]
