#!/usr/bin/env bash
# Builds the program for arm64, where `char` is unsigned and `long double` has 128 bits, and runs
# the core tests in an emulator. Run it in an installation made for it, such as one by
# scripts/maintain/distros.sh: some libraries of the other architecture would replace native ones.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# Excludes rendering and starting programs, which do not depend on the processor, and the studies,
# which take too long there.
programs=(
  math_test body_test motion_test scene_test table_test recording_test timeline_test image_test canvas_test
  fuzz_manifest fuzz_png fuzz_range fuzz_scene fuzz_table
)
scripts/maintain/setup.sh arm64
scripts/maintain/build.sh --tests --in arm64 release -DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/arm64.cmake" \
  "${programs[@]}" twrench
# The two excluded tests compare thousands of motions with series in `long double`, whose 113 bits
# are emulated in software: hours in the emulator. The 25-digit references are still tested.
exec ctest --test-dir build/arm64 --output-on-failure --no-tests=error --parallel "$(nproc)" \
  --exclude-regex 'NOT_BUILT|AgreesWithTaylorSeries(ForRandomBodies|AfterAThousandTurns)'
