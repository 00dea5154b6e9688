#!/usr/bin/env bash
# Tests files with the programs of others that read them: what twrench exports with Khronos' glTF
# validator, three.js and, if it is installed, Blender, also its scripts for Blender; GitHub's workflows with actionlint; CITATION.cff
# with Citation.js.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/maintain/common.sh

# Any installed Node.js will do.
if ! command -v node >/dev/null || ! command -v npm >/dev/null; then scripts/maintain/setup.sh interchange; fi
scripts/maintain/build.sh release twrench
export TWRENCH=$PWD/build/release/bin/twrench
require_writable build

# npm installs programs beside the scripts that use them.
at=$PWD/build/interchange out=$PWD/build/interchange/out
rm -rf "$out" && mkdir -p "$out"
cp tests/interchange/{*.mjs,*.py,package.json,package-lock.json,.npmrc} "$at"
npm ci --prefix "$at" --ignore-scripts --loglevel=error

node "$at/project_files.mjs" "$PWD" "$(project_version)" "$(release_date)"

# export_and_check NAME BOUND SPEED DURATION [motion option or scene ...]: writes NAME.glb and checks it.
export_and_check() {
  local file=$out/$1.glb bound=$2 speed=$3 duration=$4
  shift 4
  "$TWRENCH" export "$@" --max-angle "$bound" --speed "$speed" --duration "$duration" -o "$file"
  node "$at/validate.mjs" "$file"
  node "$at/three_test.mjs" "$file" "$bound" "$speed" "$duration" "$@"
}

export_and_check dzhanibekov 1e-4 1 96
export_and_check fine 1e-5 6 96
export_and_check coarse 0.1 1 96 dzhanibekov
export_and_check long 1e-4 1 10000
for scene in stable-y stable-z sphere calm tao-disk tennis-racket explain; do export_and_check "$scene" 1e-4 1 30 "$scene"; done
export_and_check moments 1e-4 1 20 --inertia 1,2,3 --omega 0.1,3,0.2
export_and_check rest 1e-4 1 20 --omega 0,0,0
"$TWRENCH" export --orbit 0.3 --frame rotating -o "$out/camera.glb"
node "$at/validate.mjs" "$out/camera.glb"

if command -v blender >/dev/null; then
  # play_in_blender FILE BOUND DURATION option of simulate ...
  play_in_blender() {
    blender --background --python-exit-code 1 --python "$at/blender_test.py" -- "$@" |
      grep --line-regexp --fixed-strings --invert-match 'Blender quit'
  }
  play_in_blender "$out/dzhanibekov.glb" 1e-4 96 --method exact
  "$TWRENCH" export -o "$out/dzhanibekov.py"
  play_in_blender "$out/dzhanibekov.py" 1e-4 96 --method exact
  "$TWRENCH" export stable-y --fps 30000/1001 --max-angle 1e-5 --duration 30 -o "$out/fine.py"
  play_in_blender "$out/fine.py" 1e-5 30 stable-y --method exact
  "$TWRENCH" export examples/toss/toss.toml -o "$out/toss.py"
  play_in_blender "$out/toss.py" 1e-4 1.2 examples/toss/toss.toml
else
  say "blender is not installed: its importer and the scripts for it are not tested"
fi
