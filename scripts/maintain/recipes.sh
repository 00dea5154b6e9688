#!/usr/bin/env bash
# Follows the recipes of CONTRIBUTING.md. tests/recipes has a patch for each, an example as a newcomer
# would write it. The patches are applied together to a copy of the sources, build/recipes/source, which
# is built and tested; then tests/recipes uses the examples in a scene file, a film, Python and a page.
#   recipes.sh                    does all this
#   recipes.sh --forget [RECIPE...]  leaves out each file of each patch in turn, and lists the compile
#                                 error or the failing test that reports it. Takes an hour or more
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh

patches=$PWD/tests/recipes home=$PWD/build/recipes
copy=$home/source new=$home/new logs=$home/logs
mapfile -t recipes < <(basename --suffix=.patch "$patches"/*.patch)

usage() { sed -n '/^# /s///p; /^set/q' "$0"; }

# files_of RECIPE: prints the files that its patch changes.
files_of() { sed -n 's|^+++ b/||p' "$patches/$1.patch"; }

# patch_without RECIPE FILE: prints its patch without the changes of that file.
patch_without() {
  awk -v header="diff --git a/$2 b/$2" '/^diff --git / { keeps = $0 != header } keeps' "$patches/$1.patch"
}

# Prints the names of the sources, each followed by a zero byte: the files that git would commit or,
# in an archive of the sources, all files.
list_sources() {
  if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
    git ls-files --cached --others --exclude-standard -z
  else
    find . -path ./build -prune -o ! -type d -print0
  fi
}

# follow [RECIPE FILE]: makes `copy` equal to the sources with all patches applied, except the
# change of FILE in the patch of RECIPE. Writes only files that differ, so that little is rebuilt.
follow() {
  local recipe file
  rm -rf "$new"
  mkdir -p "$new" "$copy" "$logs"
  list_sources | tar --create --null --ignore-failed-read --files-from=- 2>/dev/null |
    tar --extract --directory "$new"
  for recipe in "${recipes[@]}"; do
    if [[ $recipe == "${1-}" ]]; then patch_without "$@"; else cat "$patches/$recipe.patch"; fi |
      patch --directory "$new" --strip 1 --force --no-backup-if-mismatch >"$logs/$recipe.patch.log" 2>&1 ||
      die "tests/recipes/$recipe.patch does not apply: $(grep -m 1 FAILED "$logs/$recipe.patch.log")" \
        "the sources have changed; write it again as the recipe says"
  done
  (cd "$copy" && find . -path ./build -prune -o ! -type d -print | sort) >"$home/files.old"
  (cd "$new" && find . ! -type d -print | sort) >"$home/files.new"
  comm -23 "$home/files.old" "$home/files.new" | (cd "$copy" && xargs -r -d '\n' rm)
  while read -r file; do
    cmp -s "$new/$file" "$copy/$file" || { mkdir -p "$(dirname "$copy/$file")" && cp "$new/$file" "$copy/$file"; }
  done <"$home/files.new"
}

targets=(twrench twrench_python random_views architecture_test golden_test motion_test page_test picture_test
  recipes_test recording_test report_test scene_test video_test)

# The tests that the recipes name.
tests='^((architecture|golden|motion|page|picture|recording|report|scene|video)_test|.*Recipe\..*|python.(mesh|film|docs|typing))$'

build() {
  local page=$copy/build/page
  # Light optimisation compiles faster.
  [[ -f $copy/build/release/build.ninja ]] ||
    cmake -S "$copy" --preset release -DBUILD_TESTING=ON -DTWRENCH_PYTHON=ON \
      -DCMAKE_CXX_FLAGS_RELEASE='-O1 -DNDEBUG' >"$logs/configure.log" || return
  # The page is part of the program.
  "$copy/scripts/maintain/page.sh" --template && "$copy/scripts/maintain/build.sh" --tests release "${targets[@]}" || return
  [[ -s $page/page.html ]]
}

# A newcomer draws the golden images of the examples and those of the view quad, which shows all insets.
make_goldens() {
  local bin=$copy/build/release/bin
  TWRENCH_UPDATE_GOLDENS=1 "$bin/golden_test" --gtest_filter='*Golden*/night:*Golden*/filmspin:*Golden*/filmrates:*Golden*/filmquad' &&
  TWRENCH_UPDATE_GOLDENS=1 "$bin/picture_test" --gtest_filter='ContentsOfViews.*:*Golden*/overlayquad'
}

run_tests() {
  make_goldens >"$logs/goldens.log" 2>&1 || { cat "$logs/goldens.log" && return 1; }
  ctest --test-dir "$copy/build/release" --output-on-failure --no-tests=error --stop-on-failure \
    --parallel "$(($(nproc) + 2))" --tests-regex "$tests"
}

# use_examples: uses the examples in a scene file, a film, Python and a page.
use_examples() {
  local build=$copy/build/release python
  python=$(sed -n 's/^_Python_EXECUTABLE:INTERNAL=//p' "$build/CMakeCache.txt")
  CORE=$copy/build/page/core.wasm WEB=$copy/web RANDOM_VIEWS=$build/bin/random_views \
    node "$copy/tests/page/views_test.mjs" || return
  TWRENCH=$build/bin/twrench PYTHONPATH=$build/python PYTHONDONTWRITEBYTECODE=1 \
    "$python" -m pytest -q -p no:cacheprovider -p no:randomly "$copy/tests/recipes"
}

# check_all [RECIPE FILE]: runs all steps, one after another; exits with the status of the first
# that fails.
check_all() {
  follow "$@"
  build || return
  run_tests && use_examples
}

# first_complaint LOG: prints the first line of a log that describes an error.
first_complaint() {
  grep -m 1 -E 'error: |CMake Error|ninja: error|undefined reference|\*\*\*Failed|^E  |AssertionError' "$1" |
    sed "s|$copy/||g" | cut -c 1-150
}

# forget RECIPE FILE: prints a line of the table; fails if no step reports the missing change.
forget() {
  local log=$logs/$1-${2//\//-}.log
  rm -rf "$copy"
  cp -a "$home/whole" "$copy"
  if (check_all "$@") >"$log" 2>&1; then
    printf '%-14s %-46s NOT NOTICED\n' "$1" "$2"
    return 1
  fi
  printf '%-14s %-46s %s\n' "$1" "$2" "$(first_complaint "$log")"
}

forget_all() {
  local recipe file unnoticed=0
  rm -rf "$home/whole"
  cp -a "$copy" "$home/whole"
  for recipe in "$@"; do
    while read -r file; do
      forget "$recipe" "$file" || unnoticed=$((unnoticed + 1))
    done < <(files_of "$recipe")
  done
  rm -rf "$copy"
  mv "$home/whole" "$copy"
  ((unnoticed == 0)) || die "$unnoticed forgotten places were not noticed" "add a test for each, or a static_assert"
}

mode=${1-}
if [[ -n $mode && $mode != --forget ]]; then
  usage
  [[ $mode == --help ]] && exit 0 || exit 2
fi
(($# == 0)) || shift
for recipe in "$@"; do
  [[ -f $patches/$recipe.patch ]] || {
    say "error: there is no recipe '$recipe'; the recipes are: ${recipes[*]}"
    exit 2
  }
done

scripts/maintain/setup.sh recipes node
require_writable build/recipes
say "following the recipes: ${recipes[*]}"
check_all
[[ $mode != --forget ]] || forget_all "${@:-${recipes[@]}}"
