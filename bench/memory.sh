#!/usr/bin/env bash
# memory.sh [FRAMES]: measures the memory use of a render, in MB of resident set. It checks whether the
# use stays constant from frame 500 to the last of FRAMES (default 10000) small frames, with and without
# PNG files, and when these are encoded; and prints the peaks of twrench and of the encoder at 1080p and
# 4K.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
twrench=build/release/bin/twrench
frames=${1:-10000}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Prints the field VmRSS or VmHWM (its peak) of a process in MB; nothing if it has ended.
memory() { awk -v field="$2:" '$1 == field { printf "%.1f", $2 / 1024 }' "/proc/$1/status" 2>/dev/null || true; }

# measure COMMAND ARGUMENTS...: runs twrench; sets early and late to the resident set at frame 500 and at the
# last progress line, peak and encoder to the peaks.
measure() {
  local line number rss child pid
  early='' late='' peak='' encoder=0
  rm -f "$folder/progress"
  mkfifo "$folder/progress"
  "$twrench" "$@" --overwrite --progress json 2>"$folder/progress" &
  pid=$!
  while read -r line; do
    number=$(sed -n 's/.*"frames_done": \([0-9]*\).*/\1/p' <<<"$line")
    [[ $number ]] || { echo "$line" >&2; continue; }
    rss=$(memory "$pid" VmRSS)
    [[ $rss ]] || continue
    ((number < 500)) || early=${early:-$rss}
    late=$rss
    peak=$(memory "$pid" VmHWM)
    child=$(pgrep -P "$pid" -x ffmpeg || true)
    [[ ! $child ]] || encoder=$(memory "$child" VmHWM)
  done <"$folder/progress"
  wait "$pid"
}

# flat NAME COMMAND ARGUMENTS...
flat() {
  measure "${@:2}"
  printf '%-34s %8s %8s  %s\n' "$1" "$early" "$late" \
    "$(awk -v a="$early" -v b="$late" 'BEGIN { printf "%+.1f %%", 100 * (b - a) / a }')"
}

film=(-o "$folder/film.mp4")
small=(render --size 256x144 --fps 60 --speed 1 --duration "$((frames / 60 + 1))"
  --frames "0-$((frames - 1))" --frames-dir "$folder/frames")
printf '%-34s %8s %8s\n' "$frames frames of 256x144" "at 500" "at last"
flat "PNG files alone" "${small[@]}" --no-video
flat "film from these" encode "$folder/frames" "${film[@]}"
flat "film alone" "${small[@]}" --no-frames "${film[@]}"
flat "both" "${small[@]}" "${film[@]}"
printf '\n%-34s %8s %8s\n' "peak" twrench ffmpeg
for size in 1920x1080 3840x2160; do
  measure render --size "$size" --frames 0-59 --frames-dir "$folder/frames" "${film[@]}"
  printf '%-34s %8s %8s\n' "$size, both" "$peak" "$encoder"
  measure encode "$folder/frames" "${film[@]}"
  printf '%-34s %8s %8s\n' "$size, film from PNG files" "$peak" "$encoder"
done
