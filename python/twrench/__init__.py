"""twrench: the torque-free rotation of rigid bodies, from the equations of motion to the film.

Units are g, cm, s and rad throughout. Attitudes ``X`` are rotation matrices space_from_body, and
angular velocities ``omega`` are in body axes; X = Id at t = 0.
"""

from ._native import version as __version__
from .body import Body
from .errors import (
    EncoderError,
    Error,
    FileError,
    GlError,
    MotionError,
    OverwriteError,
    SceneError,
    UsageError,
)
from .motion import (
    ExactMotion,
    ManyMotions,
    Method,
    Motion,
    exact,
    exact_many,
    first_flip_times,
    methods,
    simulate,
)
from .published import case, cases
from .scene import Film, Scene, scenes
from .solids import Box, Capsule, Cone, Cylinder, Ellipsoid, Mesh, Part, Sphere, Torus, Tube
from .study import MethodStudy, Study, StudyRun, study

__all__ = [
    "Body",
    "Box",
    "Capsule",
    "Cone",
    "Cylinder",
    "Ellipsoid",
    "EncoderError",
    "Error",
    "ExactMotion",
    "FileError",
    "Film",
    "GlError",
    "ManyMotions",
    "Mesh",
    "Method",
    "MethodStudy",
    "Motion",
    "MotionError",
    "OverwriteError",
    "Part",
    "Scene",
    "SceneError",
    "Sphere",
    "Study",
    "StudyRun",
    "Torus",
    "Tube",
    "UsageError",
    "__version__",
    "case",
    "cases",
    "exact",
    "exact_many",
    "first_flip_times",
    "methods",
    "scenes",
    "simulate",
    "study",
]
