#!/usr/bin/env bash
# build.sh [--tests] PRESET [TARGET...]: configures build/PRESET where that is still to do and
# brings the targets (all, if none is named) up to date. Everything it prints is on standard error.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
tests=OFF
if [[ ${1-} == --tests ]]; then
  tests=ON
  shift
fi
preset=${1:?usage: build.sh [--tests] PRESET [TARGET...]}
shift
dir=build/$preset
cache=$dir/CMakeCache.txt

# Once the tests are configured they stay so, whatever is asked later: building the program alone
# and building the tests share one folder and must not send each other back to the start.
# A folder configured elsewhere (the sources were moved or copied) is configured anew.
in_cache() { grep -qsxF "$1" "$cache"; }
options=(--preset "$preset" -DBUILD_TESTING="$tests")
if [[ ! -f $dir/build.ninja ]] || ! in_cache "CMAKE_HOME_DIRECTORY:INTERNAL=$(pwd -P)"; then
  configure=(cmake --fresh "${options[@]}")
elif [[ $tests == ON ]] && ! in_cache BUILD_TESTING:BOOL=ON; then
  configure=(cmake "${options[@]}")
else
  configure=()
fi
if ((${#configure[@]})); then
  echo "twrench: configuring $dir" >&2
  mkdir -p "$dir"
  if ! "${configure[@]}" >"$dir/configure.log" 2>&1; then
    cat "$dir/configure.log" >&2
    echo "twrench: error: cmake could not configure $dir: its reasons are above" >&2
    exit 1
  fi
fi

targets=("${@:-all}")
# A dry run that would first have to configure again says something else.
if [[ $(ninja -C "$dir" -n "${targets[@]}" | tail -n 1) == "ninja: no work to do." ]]; then
  exit 0
fi
echo "twrench: building $dir" >&2
# A terminal gets ninja's one moving line, a log only what goes wrong.
quiet=()
[[ -t 2 ]] || quiet=(--quiet)
ninja -C "$dir" "${quiet[@]}" "${targets[@]}" >&2
