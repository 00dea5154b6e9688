#!/usr/bin/env bash
# kill_test.sh [N]: kills a small render with SIGKILL at N (100) points in time, as reproducibly as
# a clock allows, and continues it with --resume each time. After each kill every existing frame must
# match an undisturbed run's, and after each run that finishes the video must decode to the same
# frames; then it starts over.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
kills=${1:-100}
scripts/maintain/build.sh release twrench
twrench=$PWD/build/release/bin/twrench
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() {
  echo "twrench: error: kill_test: $*" >&2
  exit 1
}
# 240 frames, which take about a second.
render() {
  "$twrench" render --size 160x90 --fps 15 --speed 6 --duration 96 --progress none \
    --frames-dir "$1" -o "$1.mp4" "${@:2}"
}
sums() { (cd "$1" && find . -name 'frame_*.png' -exec sha256sum {} + | sort); }
decoded() { ffmpeg -v error -i "$1" -f framemd5 -; }

begin=$(date +%s%N)
render whole
length=$((($(date +%s%N) - begin) / 1000000)) # ms
sums whole >whole.sums
decoded whole.mp4 >whole.md5

RANDOM=2020
killed=0 ended=0 kept=0
while ((killed < kills)); do
  moment=$((RANDOM % (length * 11 / 10)))
  set +e
  { timeout -s KILL "$(printf '%d.%03d' $((moment / 1000)) $((moment % 1000)))" "$twrench" render \
    --size 160x90 --fps 15 --speed 6 --duration 96 --progress none --frames-dir f -o f.mp4 --resume; } 2>said
  code=$?
  set -e
  [[ ! -d f ]] || sums f >f.sums
  [[ ! -d f ]] || foreign=$(comm -13 whole.sums f.sums)
  [[ -z ${foreign-} ]] || fail "after a kill at $moment ms: $foreign"
  case $code in
    137) killed=$((killed + 1)) kept=$((kept + $(wc -l <f.sums 2>/dev/null || echo 0))) ;;
    0)
      ended=$((ended + 1))
      cmp whole.sums f.sums || fail "frames are missing after a completed run"
      decoded f.mp4 | cmp - whole.md5 || fail "the video differs"
      rm -r f f.mp4
      ;;
    *) fail "exit code $code after $killed kills: $(cat said)" ;;
  esac
done
render f --resume
sums f | cmp - whole.sums || fail "frames are missing at the end"
decoded f.mp4 | cmp - whole.md5 || fail "the video differs at the end"
leftovers=$(find . -name '.*.tmp' | wc -l)
echo "$killed kills survived ($kept intact frames found after them, 0 others), $((ended + 1)) completed" \
  "runs, each with the same 240 frames and video; $leftovers hidden temporary files"
