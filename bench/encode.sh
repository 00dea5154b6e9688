#!/usr/bin/env bash
# encode.sh [--frames N] [--rounds N] [--before TWRENCH] Times "twrench encode" of 1080p PNG frames
# and compares it with ffmpeg alone, which reads the same files with the same settings, and with
# another build of twrench if given. The programs alternate in one run. Prints the medians in
# milliseconds per frame and their ratios to ffmpeg's.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
twrench=build/release/bin/twrench
frames=240 rounds=5 before=''
while (($#)); do
  case "$1" in
    --frames) frames=$2 ;;
    --rounds) rounds=$2 ;;
    --before) before=$2 ;;
    *) echo "usage: $0 [--frames N] [--rounds N] [--before TWRENCH]" >&2; exit 2 ;;
  esac
  shift 2
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
times=$folder/times.txt
source bench/timing.sh

render=("$twrench" render --size 1920x1080 --overwrite --progress none)
"${render[@]}" --frames "0-$((frames - 1))" --no-video --frames-dir "$folder/frames"
# The encoder's settings, from the manifest of a film. The settings of the output begin with its
# pixel format.
"${render[@]}" --frames 0-1 --frames-dir "$folder/film" -o "$folder/film.mp4"
read -ra settings < <(grep '"encoder"' "$folder/film/manifest.json" |
  sed 's/.*"pipe:0"//' | tr -d '[]"' | tr ',' ' ')
# Exact rounding, as twrench rounds; ffmpeg's default is off by a tenth of a level on average.
colors=scale=in_range=pc:out_range=tv:out_color_matrix=bt709:flags=bicubic+accurate_rnd

encode() { "$1" encode "$folder/frames" -o "$folder/encoded.mp4" --overwrite --progress none; }
encode_alone() {
  ffmpeg -loglevel error -y -framerate 60 -i "$folder/frames/frame_%06d.png" \
    -vf "$colors" "${settings[@]}" "$folder/alone.mp4"
}

for ((round = 0; round < rounds; ++round)); do
  timed "ffmpeg alone, from PNG files" "$frames" encode_alone
  timed "twrench encode" "$frames" encode "$twrench"
  [[ ! $before ]] || timed "before: twrench encode" "$frames" encode "$before"
done

medians | awk -F'\t' '
  NR == 1 { printf "%-32s %9s %9s %9s %9s\n", "milliseconds a frame", "wall", "processor", "/ffmpeg", "cpu/cpu"; w = $2; c = $3 }
  { printf "%-32s %9.1f %9.1f %9.2f %9.2f\n", $1, $2, $3, $2 / w, $3 / c }'
