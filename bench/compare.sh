#!/usr/bin/env bash
# compare.sh [FRAMES]: times `twrench compare` on two folders of FRAMES frames of 1920x1080 (default
# 1000): identical files, and frames that differ in every row, with each of its metrics. The folders
# contain 40 frames under many names. Prints seconds, milliseconds of processor time per frame, and
# the largest resident set in MB.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
twrench=$PWD/build/release/bin/twrench
frames=${1:-1000}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# The noise of a lossy encoder changes most rows of a frame.
"$twrench" render --size 1920x1080 --frames 0-936:24 --no-video --progress none --frames-dir drawn
rm drawn/manifest.json
mkdir lossy golden same other
ffmpeg -v error -pattern_type glob -i 'drawn/*.png' -c:v libx264 -crf 18 lossy.mp4
ffmpeg -v error -i lossy.mp4 -start_number 0 lossy/%d.png
drawn=(drawn/*.png)
for ((i = 0; i < frames; ++i)); do
  name=$(printf '%06d.png' "$i")
  ln "${drawn[i % ${#drawn[@]}]}" "golden/$name"
  ln "lossy/$((i % ${#drawn[@]})).png" "other/$name"
done
cp golden/* same

# timed NAME ARGUMENTS...
timed() {
  local status=0
  /usr/bin/env time -f '%e %U %S %M' -o times "$twrench" compare "${@:2}" >/dev/null || status=$?
  ((status < 2)) || exit "$status"
  tail -n 1 times | awk -v name="$1" -v n="$frames" \
    '{ printf "%-34s %8.1f %8.1f %8.0f\n", name, $1, 1e3 * ($2 + $3) / n, $4 / 1024 }'
}

printf '%-34s %8s %8s %8s\n' "$frames frames of 1920x1080" s "ms/frame" MB
timed "identical files" golden same
timed "all different" golden other
timed "all different, --edges 1" golden other --edges 1
timed "all different, --metric ssim" golden other --metric ssim
timed "all different, --report" golden other --report report.html
