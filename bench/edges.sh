#!/usr/bin/env bash
# edges.sh [SIZE [SCENE...]]: measures antialiasing quality over twenty poses of bare bodies at SIZE
# (default 1920x1080; the T-wrench and two bodies of meshes): analytic antialiasing and multisampling,
# compared with frames of four times the width and height with 4 samples, averaged. Needs
# build/release/bin/edge_error (-D TWRENCH_BENCH=ON).
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/maintain/common.sh
bin=build/release/bin
[[ -x $bin/edge_error ]] || die "edges.sh: $bin/edge_error is missing" \
  "build it: cmake --preset release -D TWRENCH_BENCH=ON && ninja -C build/release edge_error twrench"
size=${1:-1920x1080}
scenes=("${@:2}")
[[ ${#scenes[@]} -gt 0 ]] || scenes=(dzhanibekov wing-nut hammer)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

draw() { # SCENE NAME SIZE OPTIONS...
  "$bin/twrench" render "$1" --bare --background black --frames 0-570:30 --no-video --progress none \
    --frames-dir "$folder/$1/$2" --size "$3" "${@:4}"
}

for scene in "${scenes[@]}"; do
  echo "$scene"
  draw "$scene" reference "$((4 * ${size%x*}))x$((4 * ${size#*x}))" --samples 4
  draw "$scene" default "$size"
  for samples in 2 4 8 16; do
    draw "$scene" "samples-$samples" "$size" --samples "$samples" 2>/dev/null ||
      rm -rf "$folder/$scene/samples-$samples"
  done
  "$bin/edge_error" "$folder/$scene/reference" "$folder/$scene/default" "$folder/$scene"/samples-*
  rm -rf "${folder:?}/$scene"
done
