#!/usr/bin/env bash
# cores.sh [--frames N] [--rounds N] [--size WxH] Times the default film on 1, 2, 4, 8 and 16 processors, up to the
# number that the machine has: with one process, and with several. Each of several draws and encodes a part
# of the film on one processor or on two, and ffmpeg joins the parts without encoding them again. Both ways
# alternate in one run. Prints the medians in milliseconds per frame, and the stages of one process.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
twrench=${TWRENCH:-build/release/bin/twrench}
frames=480 rounds=3 size=1920x1080
source bench/timing.sh
read_options "[--frames N] [--rounds N] [--size WxH]" "$@"

# film FIRST LAST PROCESSORS NAME [OPTION...]: draws and encodes these frames of the default film.
film() {
  taskset --cpu-list "$3" "$twrench" render --size "$size" --frames "$1-$2" --no-frames --overwrite --progress none \
    -o "$folder/$4.mp4" "${@:5}"
}
whole() { film 0 $((frames - 1)) "0-$(($1 - 1))" whole; }

# parts PROCESSORS EACH: films by PROCESSORS / EACH processes, joined.
parts() {
  local each=$2 count=$(($1 / $2)) i running=()
  for ((i = 0; i < count; ++i)); do
    film $((frames * i / count)) $((frames * (i + 1) / count - 1)) "$((i * each))-$((i * each + each - 1))" "part$i" &
    running+=($!)
    echo "file 'part$i.mp4'"
  done >"$folder/parts.txt"
  for i in "${running[@]}"; do wait "$i"; done
  ffmpeg -loglevel error -y -f concat -i "$folder/parts.txt" -c copy "$folder/joined.mp4"
}

counts=()
for count in 1 2 4 8 16; do ((count > $(nproc))) || counts+=("$count"); done
for ((round = 0; round < rounds; ++round)); do
  for count in "${counts[@]}"; do
    timed "$count processors, one process" "$frames" whole "$count"
    for each in 1 2; do
      ((count / each < 2)) || timed "$count processors, $((count / each)) processes" "$frames" parts "$count" "$each"
    done
  done
done
medians | awk -F'\t' 'BEGIN { printf "%-32s %9s %9s %9s\n", "milliseconds a frame", "wall", "processor", "frames/s" }
  { printf "%-32s %9.2f %9.2f %9.0f\n", $1, $2, $3, 1000 / $2 }'
for count in "${counts[@]}"; do
  printf '\nStages of one process on %d processors:\n' "$count"
  film 0 $((frames - 1)) "0-$((count - 1))" whole --timing
done
