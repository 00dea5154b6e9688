"""twrench: the torque-free rotation of rigid bodies, from the equations of motion to the film.

Units are g, cm, s and rad throughout. Attitudes ``X`` are rotation matrices space_from_body, and
angular velocities ``omega`` are in body axes; X = Id at t = 0 unless an ``attitude`` is given.
"""

from . import plots
from ._native import version as __version__
from .body import Body, InSI, Stability
from .check import Check, CheckOrder, Checks, ErrorSize, FittedInertia, Recording, check
from .compare import Comparison, FrameComparison, compare
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
from .film import Film, Picture, encode
from .motion import (
    ExactMotion,
    ManyMotions,
    Method,
    Motion,
    Phase,
    exact,
    exact_many,
    first_flip_times,
    methods,
    simulate,
)
from .published import case, cases
from .robot import LinkFinding, Repaired, Robot, RobotLink
from .scene import Scene, scenes, schema
from .several import plot, report
from .site import pages
from .solids import Box, Capsule, Cone, Cylinder, Ellipsoid, Mesh, Part, Sphere, Torus, Tube
from .study import MethodStudy, Study, StudyRun, study

__all__ = [
    "Body",
    "Box",
    "Capsule",
    "Check",
    "CheckOrder",
    "Checks",
    "Comparison",
    "Cone",
    "Cylinder",
    "Ellipsoid",
    "EncoderError",
    "Error",
    "ErrorSize",
    "ExactMotion",
    "FileError",
    "Film",
    "FittedInertia",
    "FrameComparison",
    "GlError",
    "InSI",
    "LinkFinding",
    "ManyMotions",
    "Mesh",
    "Method",
    "MethodStudy",
    "Motion",
    "MotionError",
    "OverwriteError",
    "Part",
    "Phase",
    "Picture",
    "Recording",
    "Repaired",
    "Robot",
    "RobotLink",
    "Scene",
    "SceneError",
    "Sphere",
    "Stability",
    "Study",
    "StudyRun",
    "Torus",
    "Tube",
    "UsageError",
    "__version__",
    "case",
    "cases",
    "check",
    "compare",
    "encode",
    "exact",
    "exact_many",
    "first_flip_times",
    "methods",
    "pages",
    "plot",
    "plots",
    "report",
    "scenes",
    "schema",
    "simulate",
    "study",
]
