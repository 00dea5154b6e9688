#!/usr/bin/env bash
# Redraws the pictures of docs/gallery.md and of the README, each with the command shown there.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
program=${TWRENCH:-build/release/bin/twrench}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# picture NAME FRAME [OPTION ...]: draws one frame as docs/images/NAME.jpg, at most 1280 pixels wide
picture() {
  local name=$1 frame=$2
  shift 2
  "$program" render "$@" --frames "$frame" --no-video --frames-dir "$scratch/$name" --progress none
  convert "$scratch/$name/frame_$(printf %06d "$frame").png" -resize '1280x1280>' -quality 88 \
    "docs/images/$name.jpg"
}

# Each line of the gallery that begins with this comment describes a picture.
sed -n 's/^<!-- picture \(.*\) -->$/\1/p' docs/gallery.md | while read -r -a words; do
  picture "${words[@]}" </dev/null
done

# The moving picture of the README.
"$program" render --size 640x360 --theme space --duration 23.6 --speed 4 --fps 15 --hide hud \
  -o docs/images/flip.gif --no-frames --overwrite --progress none
