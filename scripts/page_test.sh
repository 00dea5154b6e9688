#!/usr/bin/env bash
# page_test.sh [TEST]: builds the page and the program with it, checks the types of the page's scripts,
# and tests pages in Chromium; with a word, the tests whose names have it.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
scripts/setup.sh browser
scripts/page.sh --check
scripts/build.sh release twrench
export TWRENCH=$PWD/build/release/bin/twrench REFERENCE=$PWD/tests/reference/trajectories.json
cp tests/page/*.mjs build/page/npm
for part in page controls; do node "build/page/npm/${part}_test.mjs" "$@"; done
