#!/bin/sh
# check.sh [OPTION...]: draws the held frames of the film again and compares them with those in
# golden/. Options are those of `twrench compare`: --update accepts the new ones. What was drawn, and
# a page that shows what differs, are left in out/.
set -eu
cd "$(dirname "$0")"
twrench=${TWRENCH-twrench}

# Frames of an earlier selection would count as extra ones.
rm -rf out
mkdir out
"$twrench" render racket.toml --frames 13,52,104 --no-video --progress none --frames-dir out/frames

# The bounds are those of docs/golden-images.md for pictures without text: no pixel may differ by
# more than 8 of 255 from the range of its neighbours.
exec "$twrench" compare golden out/frames --threshold 8 --edges 1 --report out/report.html "$@"
