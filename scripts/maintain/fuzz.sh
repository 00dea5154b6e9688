#!/usr/bin/env bash
# fuzz.sh TARGET SECONDS: runs libFuzzer on one of the targets in tests/fuzz (manifest, mesh, png, range,
# robot, scene, table) with ASan and UBSan, starting from the saved corpus. New inputs go to
# build/fuzz/corpus/TARGET; an input that causes a failure is saved in build/fuzz and belongs in
# tests/fuzz/corpus once fixed. Needs clang-14 (scripts/maintain/setup.sh tidy installs it).
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
target=${1:?usage: fuzz.sh TARGET SECONDS}
seconds=${2:?usage: fuzz.sh TARGET SECONDS}
scripts/maintain/setup.sh tidy
scripts/maintain/build.sh --in fuzz release -DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_CXX_FLAGS=-g1 \
  -DTWRENCH_SANITIZE=fuzzer-no-link,address,undefined -DTWRENCH_FUZZ=ON "fuzz_$target"
grown=build/fuzz/corpus/$target
mkdir -p "$grown"
# The memory of a scene is proportional to the sizes in it. No input may use more than this.
exec "build/fuzz/bin/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 \
  -max_len=8192 -print_final_stats=1 -artifact_prefix="build/fuzz/$target-" "$grown" "tests/fuzz/corpus/$target"
