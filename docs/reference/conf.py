"""Sphinx's configuration for the documents and the reference pages of the Python module.

scripts/maintain/docs.sh puts the sources together and runs Sphinx, with the built module on PYTHONPATH.
"""

from __future__ import annotations

from typing import Any

from sphinx.application import Sphinx
from sphinx.util.logging import getLogger

import twrench

project = "twrench"
version = release = twrench.__version__
copyright = "the twrench authors, MIT License"
extensions = ["myst_parser", "sphinx.ext.autodoc"]

myst_heading_anchors = 3
autodoc_member_order = "bysource"
autodoc_default_options = {"members": True, "undoc-members": True}
autodoc_preserve_defaults = True
python_use_unqualified_type_names = True
# Unions have the names that the sources give them; written out they fill half a page.
autodoc_type_aliases = {
    name: name
    for name in (
        "AngleUnit",
        "Array",
        "ArrayLike",
        "Attitude",
        "BackendName",
        "ContainerName",
        "EffortName",
        "FeatureName",
        "ForceName",
        "FrameSource",
        "FrameName",
        "MaterialName",
        "Metric",
        "MethodName",
        "Numbers",
        "Part",
        "Path",
        "PathLike",
        "Progress",
        "RateAxes",
        "RateUnit",
        "R",
        "Rate",
        "Recording",
        "Recordings",
        "Rotation",
        "Rows",
        "ShapeName",
        "StrPath",
        "LanguageName",
        "SoundName",
        "ThemeName",
        "TimeUnit",
        "UnitName",
        "Vector",
        "ViewName",
        "twrench.names.HasMatrix",
    )
}
# A private protocol, which only a scene fulfils.
autodoc_type_aliases["HasBody"] = "twrench.Scene"
# These, and other projects' objects, whose pages would have to be fetched, lead nowhere.
nitpick_ignore_regex = [
    ("py:class", r"(numpy|pandas|pathlib|os|collections)\..*"),
    ("py:class", "|".join(autodoc_type_aliases)),
]

html_theme = "furo"
html_title = f"twrench {release}"
html_copy_source = False
html_show_sphinx = False


def require_docstring(
    app: Sphinx, what: str, name: str, documented: Any, options: Any, lines: list[str]
) -> None:
    if not any(lines):
        getLogger(__name__).warning("%s %s is not documented", what, name)


def setup(app: Sphinx) -> None:
    app.connect("autodoc-process-docstring", require_docstring)
