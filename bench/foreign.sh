#!/usr/bin/env bash
# foreign.sh: runs the programs of examples/check on three free bodies with three step sizes each, checks
# the results with `twrench check`, and writes the table in docs/check.md. Installs missing
# dependencies. The files remain in build/foreign/runs.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/maintain/common.sh
scripts/maintain/setup.sh foreign node
scripts/maintain/build.sh release twrench
require_writable build

twrench=$PWD/build/release/bin/twrench folder=$PWD/build/foreign runs=$PWD/build/foreign/runs
steps=(0.02 0.01 0.005)
rm -rf "$runs" && mkdir -p "$runs"
cp examples/check/{*.mjs,free_body.xml,package.json,package-lock.json,.npmrc} "$folder"
npm ci --prefix "$folder" --ignore-scripts --loglevel=error

# compile SOURCE PROGRAM FLAG...
compile() { g++ -w -O2 "examples/check/$1.cpp" -o "$folder/$2" "${@:3}"; }
# compile_with PACKAGE SOURCE PROGRAM FLAG...: compiles with the flags of the package from
# pkg-config.
compile_with() {
  local flags
  read -ra flags <<<"$(pkg-config --cflags --libs "$1")"
  compile "${@:2:2}" "${flags[@]}" "${@:4}"
}
compile student_rk4 student_rk4 -std=c++20
compile game_engine game_engine -std=c++20
compile mujoco mujoco -std=c++20 -lmujoco
compile_with bullet bullet bullet_single -std=c++20
compile_with bullet-float64 bullet bullet -std=c++20 -DBT_USE_DOUBLE_PRECISION
compile_with ode ode ode -std=c++20
compile_with dart dart dart -std=c++17 # the headers of DART and of Simbody are no C++20
compile_with simbody simbody simbody -std=c++17

# The problems: the option of `twrench check`; moments, omega and duration for the programs.
python3 - "$twrench" >"$runs/problems" <<'END'
import json, subprocess, sys


def twrench(*arguments):
    command = [sys.argv[1], *arguments, "--format", "json"]
    return json.loads(subprocess.run(command, check=True, capture_output=True).stdout)


def write(option, moments, omega, duration):
    print(option, *(",".join(map(repr, vector)) for vector in (moments, omega)), duration)


inertia = twrench("inertia", "dzhanibekov")["inertia"]  # g cm^2
moments = [inertia[i][i] / 1000 for i in range(3)]  # engines expect numbers near 1
write("--scene=dzhanibekov", moments, [1.0, 0.05, 0.0], 96)
kg_m2 = {"slug ft^2": 1.3558179483314004, "kg m^2": 1}
for name in ("nasa-tumbling-brick", "gazebo-box"):
    case = twrench("cases", name)
    moments = [moment * kg_m2[case["inertia_unit"]] for moment in case["inertia"]]
    write(f"--case={name}", moments, case["omega"], case["duration"])
END

# judge NAME PROGRAM [VARIANT...]: writes the verdicts to files that sort in the order of these
# calls.
count=0
judge() {
  local name=$1 command=("$folder/$2") step option problem stem files
  [[ $2 != *.mjs ]] || command=(node "$folder/$2")
  printf -v count '%02d' $((10#$count + 1))
  echo "$name" >"$runs/$count.name"
  while read -r option problem; do
    stem=$runs/$count-${option#*=} files=()
    for step in "${steps[@]}"; do
      files+=("$stem-$step.csv")
      # shellcheck disable=SC2086 # words
      "${command[@]}" "$step" $problem "${@:3}" >"${files[-1]}"
    done
    "$twrench" check "${files[@]}" "$option" --steps "$(IFS=,; echo "${steps[*]}")" \
      --format json --no-fail -o "$stem.json"
  done <"$runs/problems"
}

debian() { dpkg-query --show --showformat='${source:Upstream-Version}' "$1" | sed 's/+.*//'; }
npm_version() { node -p "require('$folder/package-lock.json').packages['node_modules/$1'].version"; }
judge 'a student: RK4, for the rates alone' student_rk4
judge 'a game engine: semi-implicit Euler' game_engine
for integrator in Euler implicit RK4; do
  judge "MuJoCo $(debian libmujoco-dev), $integrator" mujoco "$integrator" "$folder/free_body.xml"
done
for integrator in Euler implicit implicitfast RK4; do
  judge "MuJoCo $(npm_version @mujoco/mujoco), $integrator" mujoco.mjs "$integrator"
done
judge "DART $(debian libdart-dev)" dart
for integrator in semi-explicit-euler verlet runge-kutta-merson; do
  judge "Simbody $(debian libsimbody-dev), $integrator" simbody "$integrator"
done
for torque in none explicit implicit-world implicit-body; do
  judge "Bullet $(debian libbullet-dev), $torque" bullet "$torque"
done
judge "Bullet $(debian libbullet-dev) in float, implicit-body" bullet_single implicit-body
for torque in none gyroscopic gyroscopic-finite; do
  judge "ODE $(debian libode-dev), $torque" ode "$torque"
done
for torque in none gyroscopic; do
  judge "Jolt $(npm_version jolt-physics), $torque" jolt.mjs "$torque"
done
judge "Rapier $(npm_version @dimforge/rapier3d-compat)" rapier.mjs
judge "cannon-es $(npm_version cannon-es)" cannon.mjs
judge "Havok $(npm_version @babylonjs/havok)" havok.mjs

python3 - "$runs" docs/check.md <<'END'
import json, pathlib, sys

runs, document = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
cases = ["dzhanibekov", "nasa-tumbling-brick", "gazebo-box"]


def number(value):
    """Two digits are enough to see what a program is like, and do not depend on the compiler."""
    return f"{value:.2g}" if value < 99.5 else f"{value:.0f}"


def error(result):
    """How far the attitude is off, and the flips that are missing or too many."""
    flips = result["flips"]
    missed = sum(flip["t"] is None for flip in flips)
    extra = sum(flip["exact"] is None for flip in flips)
    counts = [f"{n} flips {what}" for n, what in ((missed, "missed"), (extra, "too many")) if n]
    return ", ".join([number(result["attitude"]["max_error"]), *counts])


def exponent(order):
    return "-" if order is None else f"{order:.1f}".replace("-0.0", "0.0")


def brief(verdict):
    """The verdict without the sizes, which are in other columns."""
    if verdict.startswith("off by"):
        return verdict.partition("; ")[2]
    text = verdict.partition(", as if")[0]
    return text if text.endswith("never change") else text.partition(":")[0]


rows = {}  # engines with the same errors share a row
for path in sorted(runs.glob("*.name")):
    results = [json.loads((runs / f"{path.stem}-{case}.json").read_text()) for case in cases]
    middle = [result["files"][1] for result in results]
    order = results[1]["order"]
    cells = (
        *map(error, middle),
        f'{exponent(order["rates"])}, {exponent(order["attitude"])}',
        brief(middle[0]["verdict"]),
    )
    rows.setdefault(cells, []).append(path.read_text().strip())
head = ["engine and option", "T-wrench", "NASA's brick", "Gazebo's box", "orders", "verdict on the T-wrench"]
lines = [head, *(("; ".join(engines), *cells) for cells, engines in rows.items())]
table = "\n".join("| " + " | ".join(cells) + " |" for cells in lines)
table = table.replace("\n", "\n" + "|---" * len(head) + "|\n", 1)
begin, end = "<!-- written by bench/foreign.sh -->\n", "\n<!-- end of what it writes -->"
before, found, rest = document.read_text().partition(begin)
old, found_end, after = rest.partition(end)
if not (found and found_end):
    sys.exit(f"{document} lacks the marks between which the table stands")
document.write_text(before + begin + table + end + after)
print(table)
END
