"""Published test problems of free rigid bodies, with both published and exact values."""

from __future__ import annotations

import json
from typing import Any, cast

from . import _arguments, _native

__all__ = ["case", "cases"]


def cases() -> list[str]:
    """The names of the published cases, as listed by ``twrench cases``."""
    return list(_native.case_names())


def case(name: str) -> dict[str, Any]:
    """A published case, in the form of ``twrench cases NAME --format json``.

    ``inertia`` has the principal moments in the published ``inertia_unit``, ``omega`` the angular
    velocity at t = 0 in body axes, rad/s, and ``attitude`` the published quaternion at t = 0 (scalar
    first, space from body) or ``None``. ``published`` lists the published values next to the exact
    ones, and ``exact`` the exact states: ``t`` in s, ``omega`` in rad/s, ``quaternion`` (scalar
    first, space from body), ``energy`` and ``momentum`` (space axes) in the unit of the moments, per
    s^2 and per s. Raises :class:`twrench.UsageError` if there is no case of that name."""
    return cast("dict[str, Any]", json.loads(_native.case_json(_arguments.text("name", name))))
