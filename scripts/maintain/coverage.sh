#!/usr/bin/env bash
# coverage.sh: builds with gcov's counters, runs all tests, and prints the line coverage of each
# library source; those below 90 % come first.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
scripts/maintain/setup.sh coverage
scripts/maintain/build.sh --tests --in coverage release -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_FLAGS_DEBUG='-O0 -g1 --coverage -fprofile-update=atomic -fprofile-exclude-files=^/usr/'
find build/coverage -name '*.gcda' -delete
# Excludes tests that limit file sizes or kill processes: they would damage the counters' files as
# well, and every later program would complain.
cutting='^(Faults\.AFilmThatOutgrowsItsDisk|Faults\.AManifestThatCannotBeWritten|Resume\.AfterBeingKilledAtAnyInstant)$'
ctest --test-dir build/coverage --parallel "$(nproc)" --output-on-failure --no-tests=error \
  --exclude-regex "$cutting"
gcovr --root . --object-directory build/coverage --filter 'src/' --exclude-throw-branches \
  --sort-percentage --print-summary
