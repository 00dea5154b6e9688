from __future__ import annotations

import ast
from graphlib import TopologicalSorter
from pathlib import Path

import twrench

PACKAGE = Path(twrench.__file__).parent


def imported_modules(source: str) -> set[str]:
    """The modules of the package that a module imports: at its top, in functions, and for types."""
    return {
        name
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.ImportFrom) and node.level == 1
        for name in ([node.module] if node.module else [alias.name for alias in node.names])
    }


def test_modules_do_not_import_one_another_in_a_circle():
    imports = {file.stem: imported_modules(file.read_text()) for file in PACKAGE.glob("*.py")}
    assert "body" in imports["scene"]
    TopologicalSorter(imports).prepare()
