#!/usr/bin/env bash
# fuzz.sh TARGET SECONDS: libFuzzer over one of the targets in fuzz/ (manifest, png, range, scene),
# under ASan and UBSan, from the kept corpus. What it grows stays in build/fuzz/corpus/TARGET; an
# input that breaks something is left in build/fuzz and belongs, once mended, into fuzz/corpus.
# Needs clang-14 (scripts/setup.sh tidy installs it).
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
target=${1:?usage: fuzz.sh TARGET SECONDS}
seconds=${2:?usage: fuzz.sh TARGET SECONDS}
scripts/setup.sh tidy
scripts/build.sh fuzz "fuzz_$target"
grown=build/fuzz/corpus/$target
mkdir -p "$grown"
# The scenes' own computations allocate by what a scene asks for: no more than this for any input.
exec "build/fuzz/bin/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 \
  -max_len=8192 -print_final_stats=1 -artifact_prefix="build/fuzz/$target-" "$grown" "fuzz/corpus/$target"
