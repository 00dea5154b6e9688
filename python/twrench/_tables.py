"""Tables in HTML for notebooks."""

from __future__ import annotations

from html import escape
from typing import Iterable, Mapping, Sequence

_LEFT = ' style="text-align: left"'


def of_properties(values: Mapping[str, str]) -> str:
    """A table with a row for each name and its value."""
    rows = (
        f"<tr><th{_LEFT}>{escape(name)}</th><td{_LEFT}>{escape(value)}</td></tr>"
        for name, value in values.items()
    )
    return f"<table>{''.join(rows)}</table>"


def of_rows(names: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table with a column for each name. The first column is the heading of its row."""
    head = "".join(f"<th>{escape(name)}</th>" for name in names)
    body = "".join(
        f"<tr><th{_LEFT}>{escape(first)}</th>"
        + "".join(f"<td>{escape(value)}</td>" for value in others)
        + "</tr>"
        for first, *others in rows
    )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
