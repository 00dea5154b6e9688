#!/usr/bin/env bash
# Runs every test, also on a bare Debian or Ubuntu: installs missing dependencies, builds the page and all
# targets that are out of date, then runs all tests of the release build. scripts/check.sh runs the checks
# of a change.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/maintain/setup.sh test --if-possible page
scripts/maintain/page.sh --if-possible
scripts/maintain/build.sh --tests release
# Runs two more tests at a time than there are processors, because some tests mostly wait for a lock
# or a signal.
exec ctest --test-dir build/release --output-on-failure --no-tests=error \
  --parallel "$(($(nproc) + 2))"
