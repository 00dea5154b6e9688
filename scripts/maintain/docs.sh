#!/usr/bin/env bash
# docs.sh: builds the reference pages of the C++ library (Doxygen) and of the Python module (Sphinx),
# with the documents of docs/, into build/docs; its index.html links to all of them. A warning is an
# error, and so is anything that a page would fetch from elsewhere.
#   docs.sh [FOLDER]   documents the Python module in FOLDER; by default, that of the release build
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh
scripts/maintain/setup.sh docs
module=${1-$PWD/build/release/python}
(($#)) || scripts/maintain/build.sh --tests release twrench_python
require_writable build/docs
pages=$PWD/build/docs sources=$PWD/build/docs-sources

rm -rf "$pages" "$sources"
mkdir -p "$pages" "$sources"
doxygen docs/reference/Doxyfile
cp -r docs/*.md docs/images docs/reference/*.rst "$sources"
# Debian's Sphinx is installed for Debian's Python.
PYTHONPATH=$module PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -m sphinx -b html -W --keep-going -n -q \
  -c docs/reference -d "$sources/.doctrees" "$sources" "$pages"

# Scripts, styles, pictures and fonts, but not ordinary links.
if grep -rnoE --include='*.html' --include='*.css' --include='*.js' \
  "(src=|<link [^>]*href=|url\(|@import |import\()[\"' ]*(https?:)?//[^\"') >]+" "$pages"; then
  die "the pages above fetch something from elsewhere"
fi
say "build/docs/index.html"
