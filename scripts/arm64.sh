#!/usr/bin/env bash
# Builds the program for arm64, where `char` is unsigned and `long double` has 128 bits, and runs the
# tests of the core in an emulator. For an installation made for it, as scripts/distros.sh makes one:
# some libraries of the other architecture would take the place of this one's.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
# Not what draws or starts programs, which is not the processor's, nor the studies, which take long there.
programs=(
  math_test body_test motion_test scene_test timeline_test image_test canvas_test
)
scripts/setup.sh arm64
scripts/build.sh --tests arm64 "${programs[@]}" twrench
# The two left out hold thousands of motions against series in `long double`, whose 113 bits are
# software there: hours in the emulator. The references of 25 digits are held all the same.
exec ctest --test-dir build/arm64 --output-on-failure --no-tests=error --parallel "$(nproc)" \
  --exclude-regex 'NOT_BUILT|AgreesWithTaylorSeries(ForRandomBodies|AfterAThousandTurns)'
