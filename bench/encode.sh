#!/usr/bin/env bash
# encode.sh [--frames N] [--rounds N] [--before TWRENCH] Times "twrench encode" of 1080p PNG frames
# and compares it with ffmpeg alone, which reads the same files with the same settings, and with
# another build of twrench if given. The programs alternate in one run. Prints the medians in
# milliseconds per frame and their ratios to ffmpeg's, and for each effort the size of the film and
# how well it shows the frames, so that no speed is bought with quality unnoticed.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
twrench=build/release/bin/twrench
frames=240 rounds=5 before=''
source bench/timing.sh
read_options "[--frames N] [--rounds N] [--before TWRENCH]" "$@"

render=("$twrench" render --size 1920x1080 --overwrite --progress none)
"${render[@]}" --frames "0-$((frames - 1))" --no-video --frames-dir "$folder/frames"
# The encoder's settings, from the manifest of a film. The settings of the output begin with its
# pixel format.
"${render[@]}" --frames 0-1 --frames-dir "$folder/film" -o "$folder/film.mp4"
read -ra settings < <(grep '"encoder"' "$folder/film/manifest.json" |
  sed 's/.*"pipe:0"//' | tr -d '[]"' | tr ',' ' ')
# Exact rounding, as twrench rounds; ffmpeg's default is off by a tenth of a level on average.
colors=scale=in_range=pc:out_range=tv:out_color_matrix=bt709:flags=bicubic+accurate_rnd

encode() {
  "$1" encode "$folder/frames" -o "$folder/encoded.mp4" --overwrite --progress none "${@:2}"
}
encode_alone() {
  ffmpeg -loglevel error -y -framerate 60 -i "$folder/frames/frame_%06d.png" \
    -vf "$colors" "${settings[@]}" "$folder/alone.mp4"
}

for ((round = 0; round < rounds; ++round)); do
  timed "ffmpeg alone, from PNG files" "$frames" encode_alone
  timed "twrench encode" "$frames" encode "$twrench"
  for effort in fast small; do
    timed "twrench encode --encode $effort" "$frames" encode "$twrench" --encode "$effort"
  done
  [[ ! $before ]] || timed "before: twrench encode" "$frames" encode "$before"
done

medians | awk -F'\t' '
  NR == 1 { printf "%-32s %9s %9s %9s %9s\n", "milliseconds a frame", "wall", "processor", "/ffmpeg", "cpu/cpu"; w = $2; c = $3 }
  { printf "%-32s %9.1f %9.1f %9.2f %9.2f\n", $1, $2, $3, $2 / w, $3 / c }'

# The frames as the encoder receives them, recorded by a substitute; the trial writes no file.
cat >"$folder/ffmpeg" <<'END'
#!/usr/bin/env bash
[[ $* != *" null -" ]] || exec "$REAL_FFMPEG" "$@"
exec "$REAL_FFMPEG" "$@" < <(tee "$RAW_FRAMES")
END
chmod +x "$folder/ffmpeg"
REAL_FFMPEG=$(command -v ffmpeg) RAW_FRAMES=$folder/raw.yuv PATH=$folder:$PATH encode "$twrench"

# Prints the PSNR in dB and the SSIM of the film.
quality() {
  ffmpeg -hide_banner -nostats -i "$folder/encoded.mp4" \
    -f rawvideo -pix_fmt yuv420p -video_size 1920x1080 -framerate 60 -i "$folder/raw.yuv" \
    -lavfi '[0]settb=AVTB,setpts=N,split[a][b];[1]settb=AVTB,setpts=N,split[c][d];[a][c]psnr;[b][d]ssim' \
    -f null - 2>&1 | sed -n 's/.* average:\([^ ]*\) .*/\1/p; s/.* All:\([^ ]*\) .*/\1/p' | sort -rn
}

printf '\n%-32s %9s %9s %9s\n' 'the film at each effort' MB 'PSNR, dB' SSIM
for effort in fast balanced small; do
  encode "$twrench" --encode "$effort"
  mapfile -t measured < <(quality)
  awk -v effort="$effort" -v bytes="$(stat -c %s "$folder/encoded.mp4")" \
    -v psnr="${measured[0]}" -v ssim="${measured[1]}" \
    'BEGIN { printf "%-32s %9.2f %9.2f %9.4f\n", effort, bytes / 1e6, psnr, ssim }'
done
