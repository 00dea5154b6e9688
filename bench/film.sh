#!/usr/bin/env bash
# film.sh [--frames N] [--rounds N] [--before TWRENCH] [--vtk SCRIPT] Times a 1080p video and
# compares it with programs that do the same or bound it, alternating in one run and reporting
# medians: ffmpeg alone on the same raw frames with the same settings, VTK (python3-vtk9, under
# Xvfb; omitted if not installed), and another build of twrench if given. Prints wall and CPU
# milliseconds per frame and the ratios. SCRIPT is run as "SCRIPT FRAMES SAMPLES DIR" instead of
# vtk_film.py.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
twrench=build/release/bin/twrench
frames=240 rounds=3 before='' vtk=''
source bench/timing.sh
read_options "[--frames N] [--rounds N] [--before TWRENCH] [--vtk SCRIPT]" "$@"

# frames_of BINARY OPTIONS... and film BINARY OPTIONS...: draw the frames, and render the video.
frames_of() {
  "$1" render --size 1920x1080 --frames "0-$((frames - 1))" --overwrite --progress none \
    --frames-dir "$folder/frames" "${@:2}"
}
film() { frames_of "$@" -o "$folder/film.mp4"; }

# The encoder's settings from the manifest, from yuv420p or, converted by ffmpeg, rgb24; and the
# frames as the encoder receives them, recorded by a substitute. (Decoded frames of the video are
# smoother and faster to encode.)
cat >"$folder/ffmpeg" <<'END'
#!/usr/bin/env bash
[[ $* == *" 1920x1080 "* ]] || exec "$REAL_FFMPEG" "$@"  # the trial
exec "$REAL_FFMPEG" "$@" < <(tee "$RAW_FRAMES")
END
chmod +x "$folder/ffmpeg"
REAL_FFMPEG=$(command -v ffmpeg) RAW_FRAMES=$folder/raw.yuv PATH=$folder:$PATH \
  film "$twrench" --bare
read -ra yuv_settings < <(grep '"encoder"' "$folder/frames/manifest.json" | cut -d: -f2- |
  sed 's/pipe:0/pipe:/' | tr -d '[]"' | tr ',' ' ')
rgb_settings=()
for word in "${yuv_settings[@]}"; do
  [[ $word != -c:v ]] ||
    rgb_settings+=(-vf "scale=in_range=pc:out_range=tv:out_color_matrix=bt709:flags=bicubic+accurate_rnd,format=yuv420p")
  rgb_settings+=("${word/#yuv420p/rgb24}")
done
ffmpeg -v error -i "$folder/frames/frame_%06d.png" -f rawvideo -pix_fmt rgb24 "$folder/raw.rgb"

encode_yuv() { ffmpeg "${yuv_settings[@]}" "$folder/alone.mp4" <"$folder/raw.yuv"; }
encode_rgb() { ffmpeg "${rgb_settings[@]}" "$folder/alone.mp4" <"$folder/raw.rgb"; }

# VTK is slow: an eighth of the frames is enough.
vtk_frames=$(((frames + 7) / 8))
vtk_film() {
  local script=(bench/vtk_film.py "$vtk_frames" "$folder/vtk")
  [[ ! $vtk ]] || script=("$vtk" "$vtk_frames" 4 "$folder/vtk")
  mkdir -p "$folder/vtk"
  xvfb-run -a -s "-screen 0 1920x1080x24" /usr/bin/python3 "${script[@]}" >/dev/null
}

for ((round = 0; round < rounds; ++round)); do
  timed "ffmpeg alone, rgb24" "$frames" encode_rgb
  timed "ffmpeg alone, yuv420p" "$frames" encode_yuv
  timed "film, bare" "$frames" film "$twrench" --bare --no-frames
  timed "film, all overlays" "$frames" film "$twrench" --no-frames
  timed "film and PNG, bare" "$frames" film "$twrench" --bare
  timed "film and PNG, all overlays" "$frames" film "$twrench"
  timed "PNG alone, bare" "$frames" frames_of "$twrench" --bare --no-video
  if [[ $before ]]; then
    timed "before: film, bare" "$frames" film "$before" --bare --no-frames
    timed "before: film, all overlays" "$frames" film "$before" --no-frames
    timed "before: film and PNG, bare" "$frames" film "$before" --bare
    timed "before: film and PNG, all overlays" "$frames" film "$before"
  fi
  if command -v xvfb-run >/dev/null && /usr/bin/python3 -c 'import vtk' 2>/dev/null; then
    timed "VTK, 4 samples, PNG" "$vtk_frames" vtk_film
  fi
done

medians | awk -F'\t' '
  {
    name[NR] = $1; w[NR] = $2; c[NR] = $3
    if ($1 ~ /^ffmpeg alone, yuv/) { fw = $2; fc = $3 }
    if ($1 ~ /^VTK/) vw = $2
  }
  END {
    printf "%-38s %9s %9s %9s %9s %9s\n", "milliseconds a frame", "wall", "processor", "/ffmpeg", "cpu/cpu", "VTK/"
    for (i = 1; i <= NR; ++i)
      printf "%-38s %9.1f %9.1f %9.2f %9.2f %9s\n", name[i], w[i], c[i], w[i] / fw, c[i] / fc, (vw ? sprintf("%.1f", vw / w[i]) : "-")
  }'

printf '\nStages of the film, bare:\n'
film "$twrench" --bare --no-frames --timing
printf 'Stages of the film and PNG, all overlays:\n'
film "$twrench" --timing
