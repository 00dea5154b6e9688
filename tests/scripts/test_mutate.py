from __future__ import annotations

import re
import subprocess
import sys
from itertools import islice
from pathlib import Path

import pytest

MAINTAIN = Path(__file__).resolve().parents[2] / "scripts/maintain"
sys.path.insert(0, str(MAINTAIN))

from mutation.changes import Change, draw, possible_changes, room_of
from mutation.coverage import Definition, Definitions, Module, Recorder, definitions_of
from mutation.tree import RECORDING, rooms_above


def changed(text: str, kind: str) -> list[str]:
    """The text after each possible change of a kind."""
    changes = possible_changes("src/room/file.cpp", text)
    return [text[: c.start] + c.new + text[c.end :] for c in changes if c.kind == kind]


@pytest.mark.parametrize(
    "kind, text, expected",
    [
        ("comparison", "if (a < b) f();", ["if (a <= b) f();"]),
        ("comparison", "return a >= b;", ["return a > b;"]),
        ("comparison", "return a == b;", ["return a != b;"]),
        ("sign", "x = a + b;", ["x = a - b;"]),
        ("sign", "x -= b;", ["x += b;"]),
        ("sign", "return -x;", ["return x;"]),
        ("sign", "f(a, -x);", ["f(a, x);"]),
        ("sign", 'x = "a" + b;', []),
        ("sign", "p->x = --y;", []),
        ("constant", "x = 2.5f;", ["x = 2.525f;"]),
        ("constant", "x = 100.0;", ["x = 101.0;"]),
        ("constant", "x = 1e-9;", ["x = 1.01e-09;"]),
        ("constant", "x = 0.0;", []),
        ("constant", "x = 10'000U;", ["x = 10001U;"]),
        ("constant", "x = 0xff;", ["x = 256;"]),
        ("min/max", "x = std::min(a, b);", ["x = std::max(a, b);"]),
        ("min/max", "x = v.cwiseAbs().maxCoeff();", ["x = v.cwiseAbs().minCoeff();"]),
        ("min/max", "const int max = limit;", []),
        ("dropped term", "x = a + b.c(d, e)[1] - 2;", ["x = a - 2;", "x = a + b.c(d, e)[1];"]),
        ("dropped term", "x = a * so3::exp<double>(w);", ["x = a;"]),
        ("dropped term", "x = a + b * 2;", ["x = a + b;"]),
        ("dropped term", "x = a + (b + c);", ["x = a + (b);"]),
        ("dropped term", "x = *p;", []),
        ("dropped statement", "{\n  f(x);\n}", ["{\n  ;\n}"]),
        ("dropped statement", "{ a.b[1] = c; }", ["{ ; }"]),
        ("dropped statement", "{ ++i; }", ["{ ; }"]),
        ("dropped statement", "{ int a = 1; Vector3d v(1, 2, 3); double d{1}; }", []),
        ("dropped statement", "{ return f(x); }", []),
        ("dropped statement", "{ auto& x = y; using A = B; }", []),
        ("dropped statement", "struct A { A(A&&) = default; };", []),
        ("dropped statement", "{\n  f(x,\n    y);\n}", []),
        ("logical", "if (a && b) c();", ["if (a || b) c();"]),
        ("logical", "if (!a || b) c();", ["if (a || b) c();", "if (!a && b) c();"]),
        ("logical", "auto&& x = f();", []),
    ],
)
def test_each_kind_makes_its_change(kind: str, text: str, expected: list[str]) -> None:
    assert changed(text, kind) == expected


@pytest.mark.parametrize(
    "text",
    [
        "// a < b + 1\n",
        "/* a < b\n + 1; */",
        "// one comment \\\n a + 1;\n",
        "#define LESS(a, b) a < b + 1\n",
        "#if A \\\n  && B > 3\n#endif\n",
        '"a < b + 1; // \\" && 2"',
        'R"glsl(x = a + "1"; if (!b) {})glsl"',
        "'\\'' '+' '!'",
        "static_assert(sizeof(int) == 4 && a < b);",
        "using A = std::array<int, 3 + 1>;",
        "template <int N = 3, typename = std::enable_if_t<(N > 2)>> struct A;",
        "std::map<int, std::array<double, 3>> x;",
        "bool operator<(const A& a, const A& b);",
        "bool operator==(const A& other) const = default;",
    ],
)
def test_text_without_code_is_left_alone(text: str) -> None:
    assert possible_changes("src/room/file.cpp", text) == []


def test_code_after_a_raw_string_and_templates_is_found() -> None:
    text = 'f(R"(a + b)", std::vector<int>(n), 1 < 2);'
    assert changed(text, "comparison") == ['f(R"(a + b)", std::vector<int>(n), 1 <= 2);']


def test_a_change_names_its_line() -> None:
    [change] = possible_changes("src/a/b.cpp", "/* 1\n2 */\nif (a < b)\n")
    assert (change.file, change.line, change.kind) == ("src/a/b.cpp", 3, "comparison")


SOURCES = {
    "src/base/a.cpp": "int f() { return a + 1; }\n" * 4,
    "src/picture/body/b.cpp": "int f() { return a < 1 && b > 2; }\n" * 100,
    "include/twrench/motion/c.h": "inline int f() { g(x); return 3; }\n" * 25,
}
LINES = {"base": 4, "picture/body": 100, "motion": 25}


def drawn(count: int, seed: int) -> list[Change]:
    changes = [c for file, text in SOURCES.items() for c in possible_changes(file, text)]
    return list(islice(draw(changes, LINES, seed), count))


def test_the_seed_determines_the_changes() -> None:
    assert drawn(40, 1) == drawn(40, 1)
    assert drawn(20, 1) == drawn(40, 1)[:20]
    assert drawn(40, 1) != drawn(40, 2)


def test_each_change_is_drawn_once() -> None:
    everything = drawn(10**6, 3)
    assert len(set(everything)) == len(everything) == 3 * 4 + 5 * 100 + 2 * 25


def test_rooms_share_by_the_root_of_their_lines() -> None:
    rooms = [room_of(change.file) for change in drawn(17, 4)]
    assert {room: rooms.count(room) for room in LINES} == {"base": 2, "picture/body": 10, "motion": 5}


def test_rooms_above_follow_the_includes() -> None:
    sources = {
        "include/twrench/base/a.h": "",
        "src/motion/b.cpp": "#include <twrench/base/a.h>\n#include <vector>\n",
        "src/picture/body/c.cpp": '#include "motion/b.h"\n',
    }
    assert rooms_above(sources)["base"] == {"base": 0, "motion": 1, "picture/body": 2}
    assert rooms_above(sources)["picture/body"] == {"picture/body": 0}


SOURCE = """#include "a.h"

namespace twrench {
namespace {

constexpr double tolerance = 0.5;

/// A comment (with brackets) {
struct Place {
  double length() const { return x; }
  double x = 3;
};

constexpr int twice(int x) {
  return 2 * x;
}

}  // namespace

double sum(double a,
           double b) {
  const auto f = [&] {
    return a;
  };

  return f() + b;
}

Place::Place(int x)
    : x(x) {
  if (x > 3) abort();
}

}  // namespace twrench
"""


def line_of(text: str) -> int:
    return next(i for i, line in enumerate(SOURCE.splitlines(), 1) if text in line)


@pytest.mark.parametrize(
    "text, begin",
    [("double a,", "double sum"), ("return a;", "double sum"), ("f() + b", "double sum"), ("abort", "Place::Place")],
)
def test_a_line_is_in_its_function(text: str, begin: str) -> None:
    definitions = Definitions("a.cpp", SOURCE)
    assert definitions.is_function_at(line_of(text))
    assert definitions.at(line_of(text)) == Definition("a.cpp", line_of(begin))


@pytest.mark.parametrize("text", ["= 0.5", "double length", "double x = 3", "2 * x", '"a.h"'])
def test_what_may_be_used_at_compile_time_is_in_no_function(text: str) -> None:
    assert not Definitions("a.cpp", SOURCE).is_function_at(line_of(text))


PROGRAM = """#include <cstdlib>
[[gnu::always_inline]] static inline int inlined(int x) {
  return x * x + 5;
}

[[gnu::noinline]] int other(int x) {
  return x + 2;
}

int main(int argc, char**) {
  volatile int count = 3;
  if (argc > 1) std::abort();
  return count == 3 ? inlined(count) : other(count);
}
"""


@pytest.mark.parametrize("arguments", [[], ["killed"]])
def test_the_functions_that_run_are_recorded(tmp_path: Path, arguments: list[str]) -> None:
    (tmp_path / "a.cpp").write_text(PROGRAM)
    (tmp_path / "unity.cxx").write_text('#include "a.cpp"\n')
    trace = MAINTAIN / "mutation/trace.c"
    subprocess.run(["cc", "-c", trace, "-o", "trace.o"], cwd=tmp_path, check=True)
    subprocess.run(["c++", *RECORDING.split(), "-O1", tmp_path / "unity.cxx", "trace.o", "-o", "a"], cwd=tmp_path,
                   check=True)
    module = Module(tmp_path / "a", tmp_path, {"a.cpp": Definitions("a.cpp", PROGRAM)})
    recorder = Recorder(tmp_path / "records", [module])
    recorder.begin()
    subprocess.run([tmp_path / "a", *arguments], env=recorder.environment)
    [found] = definitions_of([recorder.end()])
    called = {re.findall(r"(\w+)\(", PROGRAM.splitlines()[d.line - 1])[0] for d in found}
    assert called == ({"main"} if arguments else {"main", "inlined"})
