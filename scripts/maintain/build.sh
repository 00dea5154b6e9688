#!/usr/bin/env bash
# build.sh [--tests] PRESET [TARGET...]: configures build/PRESET if necessary and builds the targets
# (default: all). All output goes to standard error.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh
tests=OFF
if [[ ${1-} == --tests ]]; then
  tests=ON
  shift
fi
preset=${1:?usage: build.sh [--tests] PRESET [TARGET...]}
shift
targets=("${@:-all}")
dir=build/$preset
cache=$dir/CMakeCache.txt

# Tests stay configured once they are. Building the program alone and building the tests share a
# folder and must not undo each other's configuration. A folder that was configured for another
# location (because the sources were moved or copied) is configured again.
in_cache() { grep -qsxF "$1" "$cache"; }
# The tests of the release also test the Python module.
options=(--preset "$preset" -DBUILD_TESTING="$tests")
[[ $tests == OFF || $preset != release ]] || options+=(-DTWRENCH_PYTHON=ON)
if [[ ! -f $dir/build.ninja ]] || ! in_cache "CMAKE_HOME_DIRECTORY:INTERNAL=$(pwd -P)"; then
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
