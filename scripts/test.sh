#!/usr/bin/env bash
# Every check there is, on a bare Debian 12 or Ubuntu 24.04 too: installs what is missing, then the
# formatting, all tests, those that draw again over EGL, those of the threads under TSan, and all
# again under ASan + UBSan.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
step() { printf '\n== %s\n' "$*"; }

launcher=()
run_tests() {
  "${launcher[@]}" ctest --test-dir "build/$1" --output-on-failure --no-tests=error \
    --parallel "$(nproc)" "${@:2}"
}

scripts/setup.sh test

step "Formatting"
scripts/lint.sh format

step "All tests, optimised build"
scripts/build.sh --tests release
run_tests release

step "The tests that draw, over EGL alone"
TWRENCH_TEST_BACKEND=egl run_tests release --label-regex "^gl$"

# GCC's sanitizers abort at random where the kernel randomises addresses by more bits than their
# shadow memory allows for (vm.mmap_rnd_bits=32), so that is switched off where it may be.
if setarch --addr-no-randomize true 2>/dev/null; then
  launcher=(setarch --addr-no-randomize)
fi

step "The tests of the threads, under ThreadSanitizer"
"${launcher[@]}" scripts/build.sh --tests tsan thread_tests
run_tests tsan --label-regex '^threads$'

step "All tests, under AddressSanitizer and UndefinedBehaviorSanitizer"
"${launcher[@]}" scripts/build.sh --tests asan
run_tests asan
