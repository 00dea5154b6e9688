#!/usr/bin/env bash
# golden.sh [--program PATH] [SUITE...]: prints the table of docs/golden-images.md. It shows how much
# frames of a scene differ between releases of Mesa, between OSMesa and EGL, and for a pose that is
# wrong by half a degree, with each measure of `twrench compare`. Each figure is the largest of seven
# frames of 1280x720; for the wrong pose it is the smallest: a bound must still detect that one.
#
# The suites (default: bookworm trixie testing) are installations that scripts/maintain/distros.sh left in
# build/distros, with the program that it built from the same sources in each; PATH is another
# program there. All frames are compared with those of OSMesa in the first suite. Needs root.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/maintain/common.sh
source scripts/maintain/chroot.sh
program=build/release/bin/twrench
if [[ ${1-} == --program ]]; then
  program=$2
  shift 2
fi
suites=("$@")
((${#suites[@]})) || suites=(bookworm trixie testing)
twrench=$PWD/build/release/bin/twrench
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
declare -A pictures=(
  [the body]="--bare"
  [floor and arrows]="--hide hud,labels,curve,components,sphere,poinsot"
  [everything, with text]=""
)
declare -A names=([osmesa]=OSMesa [egl]=EGL)
kinds=("the body" "floor and arrows" "everything, with text")

# in_suite SUITE COMMAND: runs it in the suite's installation as a user.
in_suite() { inside "$place/$1" someone "$2"; }

# draw SUITE BACKEND START: draws the frames of all kinds of picture, from START s of the motion on,
# into $folder/SUITE-BACKEND-START.
draw() {
  local scratch=$place/$1/home/someone/golden-frames kind
  rm -rf "$scratch"
  mkdir "$scratch"
  { cat assets/scenes/dzhanibekov.toml && printf '\n[[shot]]\nlength = 16.0\nstart = %s\n' "$3"; } >"$scratch/scene.toml"
  chroot "$place/$1" chown -R someone /home/someone/golden-frames
  for kind in "${kinds[@]}"; do
    in_suite "$1" "$program render ../golden-frames/scene.toml --size 1280x720 --no-video --frames 0-900:150 \
      --backend $2 --progress none ${pictures[$kind]} --frames-dir '../golden-frames/$kind'"
  done
  mv "$scratch" "$folder/$1-$2-$3"
}

# row KIND NAME ACTUAL LEAST: prints a row for the frames in ACTUAL; with the least difference of
# all frames if LEAST is "least", otherwise with the largest.
row() {
  local expected=$folder/${suites[0]}-osmesa-0.0/$1 options
  for options in "--threshold 8" "--threshold 8 --edges 1" "--metric ssim"; do
    # shellcheck disable=SC2086 # words
    "$twrench" compare "$expected" "$folder/$3/$1" $options --format json || (($? == 1))
  done | python3 -c '
import json, sys
text, at, runs = sys.stdin.read(), 0, []
while text[at:].strip():
    run, at = json.JSONDecoder().raw_decode(text, at)
    runs.append(run["frames"])
    at += 1
worst = min if sys.argv[1] == "least" else max
plain, edges, similar = runs
cells = [worst(f[key] for f in frames) for frames, key in
         ((plain, "max"), (plain, "mean"), (plain, "share"), (edges, "max"), (edges, "share"))]
lost = worst(1 - f["ssim"] for f in similar)
print(*sys.argv[2:], *(f"{cell:.3g}" for cell in cells), f"{lost:.2g}", "", sep=" | ")
' "${4-largest}" "$1" "$2" | sed 's/^/| /; s/ *$//'
}

renderer() { # SUITE: "22.3.6"
  in_suite "$1" "$program doctor" |
    awk '/ found .* Mesa / && !seen++ { sub(/.* Mesa /, ""); sub(/[^0-9.].*/, ""); print }'
}

half_a_degree=0.0087266 # s: the body rotates at 1 rad/s
draws=()
for suite in "${suites[@]}"; do
  version=$(renderer "$suite")
  for backend in osmesa egl; do
    in_suite "$suite" "$program doctor" | grep -qE "^OpenGL by $backend.* found " || continue
    say "$suite: $backend of Mesa $version"
    draw "$suite" "$backend" 0.0
    draws+=("$suite-$backend-0.0|Mesa $version, ${names[$backend]}")
  done
done
say "${suites[0]}: half a degree"
draw "${suites[0]}" osmesa "$half_a_degree"

echo '| picture | drawn by | max | mean | share over 8 | `--edges 1`: max | share over 8 | 1 - SSIM |'
echo '|---|---|---|---|---|---|---|---|'
for kind in "${kinds[@]}"; do
  for drawn in "${draws[@]:1}"; do row "$kind" "${drawn#*|}" "${drawn%%|*}"; done
  row "$kind" "half a degree wrong" "${suites[0]}-osmesa-$half_a_degree" least
done
