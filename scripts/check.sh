#!/usr/bin/env bash
# The checks beyond scripts/test.sh: the formatting of the sources, the rendering tests with EGL
# only, the tests of threads under ThreadSanitizer, all tests under AddressSanitizer and
# UndefinedBehaviorSanitizer, the library built alone and used from outside, the reference pages, what
# is exported as others' programs read it, pages in a browser, the tests that look for uninitialised
# values under valgrind, and three minutes of scripts/torture.sh.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
step() { printf '\n== %s\n' "$*"; }

launcher=()
run_tests() {
  "${launcher[@]}" ctest --test-dir "build/$1" --output-on-failure --no-tests=error \
    --parallel "$(($(nproc) + 2))" "${@:2}"  # some tests mostly wait
}

scripts/setup.sh check

step "The layout of the sources"
scripts/lint.sh format

step "The tests that draw, over EGL alone"
scripts/build.sh --tests release
TWRENCH_TEST_BACKEND=egl run_tests release --label-regex "^gl$"

# GCC's sanitizers crash randomly where the kernel randomises more address bits than their shadow
# memory allows for (vm.mmap_rnd_bits=32), so randomisation is switched off where permitted.
if setarch --addr-no-randomize true 2>/dev/null; then
  launcher=(setarch --addr-no-randomize)
fi

step "The tests of the threads, under ThreadSanitizer"
"${launcher[@]}" scripts/build.sh --tests tsan thread_tests
run_tests tsan --label-regex '^threads$'

step "All tests, under AddressSanitizer and UndefinedBehaviorSanitizer"
"${launcher[@]}" scripts/build.sh --tests asan
run_tests asan

step "The library of the dynamics: alone, installed, and used from outside, static and shared"
scripts/library.sh

step "The reference pages, in which a warning is an error"
scripts/docs.sh

step "What is exported, read by the programs of others"
scripts/interchange.sh

step "Pages, in a browser"
scripts/page_test.sh

step "The core's tests that look for values nothing has set, under valgrind"
scripts/valgrind.sh --quick

step "Random scenes, motions and command lines, and injected faults: three minutes"
scripts/torture.sh 3 2020
