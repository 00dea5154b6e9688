#!/usr/bin/env bash
# coverage.sh: builds with gcov's counters, runs all tests, and prints the line coverage of each
# source of the libraries; those below 90 % come first.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/setup.sh coverage
scripts/build.sh --tests coverage
find build/coverage -name '*.gcda' -delete
# Not the tests that limit the size of files, or kill: they would cut the counters' files too, and
# every program after them would complain of it.
cutting='^(Faults\.AFilmThatOutgrowsItsDisk|Faults\.AManifestThatCannotBeWritten|Resume\.AfterBeingKilledAtAnyInstant)$'
ctest --test-dir build/coverage --parallel "$(nproc)" --output-on-failure --no-tests=error \
  --exclude-regex "$cutting"
gcovr --root . --object-directory build/coverage --filter 'src/' --exclude-throw-branches \
  --sort-percentage --print-summary
