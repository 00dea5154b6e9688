#!/usr/bin/env bash
# build.sh [--tests] [--in NAME] PRESET [-DVARIABLE=VALUE...] [TARGET...]: configures build/PRESET, or build/NAME, if
# necessary and builds the targets (default: all). All output goes to standard error.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh
tests=OFF name='' variables=()
if [[ ${1-} == --tests ]]; then
  tests=ON
  shift
fi
if [[ ${1-} == --in ]]; then
  name=${2-}
  shift 2
fi
preset=${1:?usage: build.sh [--tests] [--in NAME] PRESET [-DVARIABLE=VALUE...] [TARGET...]}
shift
while [[ ${1-} == -D* ]]; do
  variables+=("$1")
  shift
done
targets=("${@:-all}")
dir=build/${name:-$preset}
cache=$dir/CMakeCache.txt

# Tests stay configured once they are. Building the program alone and building the tests share a
# folder and must not undo each other's configuration. A folder that was configured for another
# location (because the sources were moved or copied) is configured again.
in_cache() { grep -qsxF "$1" "$cache"; }
# The tests of the release also test the Python module.
options=(--preset "$preset" -B "$dir" -DBUILD_TESTING="$tests" "${variables[@]}")
[[ $tests == OFF || $dir != build/release ]] || options+=(-DTWRENCH_PYTHON=ON)
# Ninja's own file ends with this target, unless a full disk or a power cut has damaged it.
is_configured() { ninja -C "$dir" -t query build.ninja >/dev/null 2>&1; }
if ! is_configured || ! in_cache "CMAKE_HOME_DIRECTORY:INTERNAL=$(pwd -P)"; then
  configure=(cmake --fresh "${options[@]}")
elif [[ $tests == ON ]] && ! in_cache BUILD_TESTING:BOOL=ON; then
  configure=(cmake "${options[@]}")
else
  configure=()
  # A dry run prints something else if it would first configure.
  if [[ $(ninja -C "$dir" -n "${targets[@]}" | tail -n 1) == "ninja: no work to do." ]]; then
    exit 0
  fi
fi
require_writable "$dir"

if ((${#configure[@]})); then
  # Older versions silently ignore CMakePresets.json.
  oldest=3.25
  version=$(cmake --version | awk 'NR == 1 { print $3 }')
  [[ $(printf '%s\n' "$oldest" "$version" | sort --version-sort | head -n 1) == "$oldest" ]] ||
    die "CMake $version is too old: $oldest or newer is needed" "install a newer one, from cmake.org"
  say "configuring $dir"
  if ! "${configure[@]}" >"$dir/configure.log" 2>&1; then
    sed -n '/^CMake Error/,/^Call Stack/ { /^CMake Error/d; /^Call Stack/d; p }' "$dir/configure.log" |
      cat -s >&2
    die "cmake could not configure $dir for the reason above" "the full log is $dir/configure.log"
  fi
fi

say "building $dir"
# A terminal shows ninja's progress line; a log only errors.
quiet=()
[[ -t 2 ]] || quiet=(--quiet)
ninja -C "$dir" "${quiet[@]}" "${targets[@]}" >&2
