#!/usr/bin/env bash
# torture.sh [MINUTES] [SEED]: randomised tests for the given number of minutes (3), in six parts:
#   scenes    random scenes, drawn under AddressSanitizer and UndefinedBehaviorSanitizer
#   motions   random motions, also under sanitizers, comparing exact with the Taylor series
#   commands  random command lines in a folder full of traps
#   scales    bodies of any size and speed with every command
#   verdicts  recordings in random units, frames and axes, which check must recognise
#   faults    small runs in which one system call or allocation fails, or all after the first
# The same SEED (2020) draws the same cases; a faster machine runs more of them. It prints the last
# line of each part, and each fault with its case: build/PRESET/bin/torture_PART 0 SEED CASE repeats
# it. Exit code 1 if there was a fault.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh
minutes=${1:-3} seed=${2:-2020}
if [[ ! $minutes =~ ^[0-9]+$ || ! $seed =~ ^[0-9]+$ ]]; then
  echo "usage: $0 [MINUTES] [SEED]" >&2
  exit 2
fi
seconds=$((minutes * 60 / 6))
scripts/maintain/setup.sh test

# build PRESET TARGET...: configures again only if it was last configured without these programs.
build() {
  local cache=build/$1/CMakeCache.txt
  [[ -f $cache ]] || scripts/maintain/build.sh --tests "$1" twrench
  grep -qxF TWRENCH_TORTURE:BOOL=ON "$cache" ||
    cmake --preset "$1" -DTWRENCH_TORTURE=ON >"build/$1/configure.log" 2>&1 ||
    die "cmake could not configure build/$1" "all it said is in build/$1/configure.log"
  scripts/maintain/build.sh --tests "$@"
}

failed=0
# run_part PRESET PART [LAUNCHER...]
run_part() {
  local program=build/$1/bin/torture_$2 log=build/torture/$2.log
  if "${@:3}" "$program" "$seconds" "$seed" >"$log" 2>&1; then
    tail -n 1 "$log"
    return
  fi
  failed=1
  cat "$log"
  say "error: torture_$2 found a fault; to try a case again: $program 0 $seed CASE"
}

# GCC's sanitizers fail with too many random address bits; see scripts/check.sh.
launcher=()
if setarch --addr-no-randomize true 2>/dev/null; then
  launcher=(setarch --addr-no-randomize)
fi
# As in tests/CMakeLists.txt.
export LSAN_OPTIONS="suppressions='$PWD/tests/lsan.supp':print_suppressions=0:intercept_tls_get_addr=0"

build asan torture_scenes torture_motions
build release torture_commands torture_scales torture_verdicts torture_faults
mkdir -p build/torture
run_part asan scenes "${launcher[@]}"
run_part asan motions "${launcher[@]}"
run_part release commands
run_part release scales
run_part release verdicts
run_part release faults
exit "$failed"
