#!/usr/bin/env bash
# page_test.sh [TEST]: builds the page and the program with it, checks the types of the page's scripts,
# compares the views of the page with those of the program, and tests pages in Chromium, and in Firefox
# if it is installed. TEST is a word: only tests of pages with this word in their names run.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh
scripts/maintain/setup.sh browser node
scripts/maintain/page.sh --check
scripts/maintain/build.sh --tests release twrench random_views
export TWRENCH=$PWD/build/release/bin/twrench REFERENCE=$PWD/tests/reference/trajectories.json
CORE=$PWD/build/page/core.wasm WEB=$PWD/web RANDOM_VIEWS=$PWD/build/release/bin/random_views \
  node tests/page/views_test.mjs
cp tests/page/*.mjs build/page/npm
for part in page controls interior article recording; do node "build/page/npm/${part}_test.mjs" "$@"; done
if command -v firefox-esr >/dev/null && command -v xvfb-run >/dev/null; then
  say "the same in Firefox"
  export BROWSER=firefox
  for part in page controls interior article recording; do
    xvfb-run --auto-servernum --server-args='-screen 0 1280x900x24' node "build/page/npm/${part}_test.mjs" "$@"
  done
else
  say "firefox-esr, xvfb or xauth is missing: pages are not tested in Firefox"
fi
