#!/usr/bin/env bash
# coverage.sh: builds with gcov's counters, runs all tests, and prints the line coverage of each
# source of the libraries; those below 90 % come first.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/setup.sh coverage
scripts/build.sh --tests coverage
find build/coverage -name '*.gcda' -delete
ctest --test-dir build/coverage --parallel "$(nproc)" --output-on-failure --no-tests=error
gcovr --root . --object-directory build/coverage --filter 'src/' --exclude-throw-branches \
  --sort-percentage --print-summary
