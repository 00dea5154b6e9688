#!/usr/bin/env bash
# check.sh [--all]: runs the checks of a change, which fail if it breaks something: the formatting of the sources, the
# tests of the threads under ThreadSanitizer, all tests under AddressSanitizer and UndefinedBehaviorSanitizer, and, in a
# bare Debian 13, both commands of README.md and the rendering tests with EGL only. The tests of Debian 13's release
# build, among them those of the Python module and of the commands in the documents, are not repeated here.
#
# With --all it also runs: the library built alone and used from outside, pages in two browsers, the reference pages,
# exported files read by other programs, the recipes of CONTRIBUTING.md followed in a copy, the tests for uninitialised
# values under valgrind, and one minute of scripts/maintain/torture.sh.
#
# Debian 13 is installed and tested beside the other steps, and pages and recipes beside the last ones: together they use
# the processors when one of them downloads, waits or has one thread. Their outputs are printed when they end. Where no
# Debian 13 can be installed, scripts/test.sh and the tests with EGL run here instead.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/maintain/common.sh
all=''
case ${1-} in
  '') ;;
  --all) all=yes ;;
  *)
    sed -n '/^# /s///p; /^set/q' "$0"
    [[ $1 == --help ]] && exit 0 || exit 2
    ;;
esac

# step TITLE COMMAND...: runs the command and prints its wall time and processor time.
step() {
  local TIMEFORMAT='-- took %0R s, %0U + %0S s of processor time'
  printf '\n== %s\n' "$1"
  time "${@:2}"
}

launcher=()
run_tests() {
  "${launcher[@]}" ctest --test-dir "build/$1" --output-on-failure --no-tests=error \
    --parallel "$(($(nproc) + 2))" "${@:2}"  # some tests mostly wait
}

test_release() {
  scripts/test.sh
  TWRENCH_TEST_BACKEND=egl run_tests release --label-regex "^gl$"
}

test_threads() {
  "${launcher[@]}" scripts/maintain/build.sh --tests tsan thread_tests
  run_tests tsan --label-regex '^threads$'
}

# In one round, because only one process may install packages at a time.
install_packages() {
  local purposes=(check)
  [[ -z $all ]] || purposes+=(library browser docs recipes coverage node)
  [[ -z $no_debian_13 || -n $all ]] || purposes+=(--if-possible page)
  scripts/maintain/setup.sh "${purposes[@]}"
}

# Long tests that repeat other tests skip themselves (tests/sanitizers.h).
test_under_asan() {
  "${launcher[@]}" scripts/maintain/build.sh --tests asan
  run_tests asan
}

declare -A beside  # process of each step that runs beside the others
# shellcheck disable=SC2154 # process is assigned here
trap 'for process in "${beside[@]}"; do kill -TERM -- "-$process" 2>/dev/null && wait "$process" || :; done' EXIT

# start_beside NAME TITLE COMMAND...: runs the step in a separate process group, which ends with this script.
start_beside() {
  require_writable build/check
  set -m
  step "${@:2}" </dev/null >"build/check/$1.log" 2>&1 &
  set +m
  beside[$1]=$!
}

# finish_beside NAME: waits for the step, prints its output, and returns its status.
finish_beside() {
  local status=0
  wait "${beside[$1]}" || status=$?
  unset "beside[$1]"
  cat "build/check/$1.log"
  return "$status"
}

# GCC's sanitizers crash randomly where the kernel randomises more address bits than their shadow
# memory allows for (vm.mmap_rnd_bits=32), so randomisation is switched off where permitted.
if setarch --addr-no-randomize true 2>/dev/null; then
  launcher=(setarch --addr-no-randomize)
fi

# In a subshell, because scripts/maintain/chroot.sh also handles signals.
no_debian_13=$(source scripts/maintain/chroot.sh && reason_against_roots)

step "The packages for the other checks" install_packages
if [[ $no_debian_13 ]]; then
  say "no Debian 13: $no_debian_13"
  step "All tests of the release build" test_release
else
  start_beside debian-13 "Both commands of README.md, and the tests with EGL only, in a bare Debian 13" \
    scripts/maintain/distros.sh --tests trixie
fi
step "The layout of the sources" scripts/maintain/lint.sh format
step "The tests of the threads, under ThreadSanitizer" test_threads
step "The tests, under AddressSanitizer and UndefinedBehaviorSanitizer" test_under_asan
if [[ $all ]]; then
  start_beside pages "Pages, in browsers" scripts/maintain/page_test.sh  # which mostly waits
  start_beside recipes "The recipes of CONTRIBUTING.md, followed in a copy" scripts/maintain/recipes.sh
  step "The library of the dynamics: alone, installed, and used from outside, static and shared" \
    scripts/maintain/library.sh --quick
  finish_beside pages  # which also builds the release
  step "The reference pages; warnings are errors" scripts/maintain/docs.sh
  step "Exported files, read by other programs" scripts/maintain/interchange.sh
  step "The core's tests for uninitialised values, under valgrind" scripts/maintain/valgrind.sh --quick
  step "Random scenes, motions and command lines, and injected faults: one minute" \
    scripts/maintain/torture.sh 1 2020
  finish_beside recipes
fi
[[ $no_debian_13 ]] || finish_beside debian-13
