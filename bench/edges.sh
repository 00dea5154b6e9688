#!/usr/bin/env bash
# edges.sh [SIZE]: measures antialiasing quality over twenty poses of the bare body at SIZE (default
# 1920x1080): analytic antialiasing and multisampling, compared with frames of four times the width
# and height with 4 samples, averaged. Needs build/release/bin/edge_error (-D TWRENCH_BENCH=ON).
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
bin=build/release/bin
size=${1:-1920x1080}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

draw() { # NAME SIZE OPTIONS...
  "$bin/twrench" render --bare --background black --frames 0-950:50 --no-video --progress none \
    --frames-dir "$folder/$1" --size "$2" "${@:3}"
}

draw reference "$((4 * ${size%x*}))x$((4 * ${size#*x}))" --samples 4
draw default "$size"
for samples in 2 4 8 16; do
  draw "samples-$samples" "$size" --samples "$samples" 2>/dev/null || rm -rf "$folder/samples-$samples"
done
"$bin/edge_error" "$folder/reference" "$folder/default" "$folder"/samples-*
