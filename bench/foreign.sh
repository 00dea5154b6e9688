#!/usr/bin/env bash
# foreign.sh: runs the programs of examples/check with several step sizes each, has `twrench check`
# judge what they compute, and writes the table in docs/check.md. Installs what is missing.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/setup.sh foreign
scripts/build.sh release twrench
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
steps=(0.02 0.01 0.005)

compile() { g++ -std=c++20 -O2 "examples/check/$1.cpp" -o "$folder/$1" "${@:2}"; }
compile student_rk4
compile game_engine
compile mujoco -lmujoco
# packages NAME...: what the compiler is to be told of it.
packages() { pkg-config --cflags --libs "$@"; }
# shellcheck disable=SC2046 # words
compile bullet $(packages bullet)
mv "$folder/bullet" "$folder/bullet_single"
# shellcheck disable=SC2046
compile bullet -DBT_USE_DOUBLE_PRECISION $(packages bullet-float64)
# shellcheck disable=SC2046
compile ode $(packages ode)

# judge NAME PROGRAM [VARIANT...]: leaves the verdict in a file that sorts as these calls do.
count=0
judge() {
  local name=$1 program=$2 step files=()
  for step in "${steps[@]}"; do
    files+=("$folder/$step.csv")
    "$folder/$program" "$step" "${@:3}" >"${files[-1]}" || return 0  # a variant it does not have
  done
  printf -v count '%02d' $((10#$count + 1))
  echo "$name" >"$folder/$count.name"
  build/release/bin/twrench check "${files[@]}" --scene dzhanibekov --format json --no-fail \
    --steps "$(IFS=,; echo "${steps[*]}")" -o "$folder/$count.json"
}

version() { dpkg-query --show --showformat='${source:Upstream-Version}' "$1" | sed 's/+.*//'; }
judge 'a student: RK4, for the rates alone' student_rk4
judge 'a game engine: semi-implicit Euler' game_engine
for integrator in Euler implicit implicitfast RK4; do
  judge "MuJoCo $(version libmujoco-dev), $integrator" mujoco "$integrator" \
    examples/check/free_body.xml
done
for torque in none explicit implicit-world implicit-body; do
  judge "Bullet $(version libbullet-dev), $torque" bullet "$torque"
done
judge "the same in single precision, implicit-body" bullet_single implicit-body
for torque in none gyroscopic gyroscopic-finite; do
  judge "ODE $(version libode-dev), $torque" ode "$torque"
done

python3 - "$folder" docs/check.md <<'END'
import json, pathlib, sys

folder, document = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])


def number(value):
    """Two digits are enough to see what a program is like, and do not depend on the compiler."""
    if value is None:
        return "-"
    return f"{value:.2g}" if abs(value) < 100 else f"{value:.0f}"


def flips(found):
    missed = sum(flip["t"] is None for flip in found)
    extra = sum(flip["exact"] is None for flip in found)
    if missed or extra:
        return f"{missed} missed" if missed else f"{extra} too many"
    return number(max(abs(flip["t"] - flip["exact"]) for flip in found))


def exponent(order):
    return "-" if order is None else f"{order:.1f}".replace("-0.0", "0.0")


def brief(verdict):
    """The verdict without the sizes that stand in other columns."""
    if verdict.startswith("off by"):
        return verdict.partition("; ")[2]
    return verdict.partition(":")[0].partition(",")[0]


rows = []
for path in sorted(folder.glob("*.json")):
    result = json.loads(path.read_text())
    middle, order = result["files"][1], result["order"]
    cells = [
        path.with_suffix(".name").read_text().strip(),
        number(middle["energy_drift"]),
        number(middle["attitude"]["max_error"]),
        flips(middle["flips"]),
        f'{exponent(order["rates"])}, {exponent(order["attitude"])}',
        brief(middle["verdict"]),
    ]
    rows.append("| " + " | ".join(cells) + " |")
head = ["program", "energy drift", "attitude off by, deg", "flips off by, s", "orders", "verdict"]
table = "\n".join(["| " + " | ".join(head) + " |", "|---" * len(head) + "|", *rows])
begin, end = "<!-- written by bench/foreign.sh -->\n", "\n<!-- end of what it writes -->"
before, found, rest = document.read_text().partition(begin)
old, found_end, after = rest.partition(end)
if not (found and found_end):
    sys.exit(f"{document} lacks the marks between which the table stands")
document.write_text(before + begin + table + end + after)
print(table)
END
