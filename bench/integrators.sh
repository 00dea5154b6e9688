#!/usr/bin/env bash
# integrators.sh [ROUNDS]: compares the CPU time of our integrators with that of other libraries in one
# program, then times the hot functions individually. Installs missing dependencies. More rounds give
# steadier results.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/maintain/setup.sh bench
mkdir -p build/release
if ! { cmake --preset release -DTWRENCH_BENCH=ON && ninja -C build/release integrators motion_functions; } \
  >build/release/bench.log 2>&1; then
  tail -n 20 build/release/bench.log >&2
  exit 1
fi
build/release/bin/integrators "${1:-15}"
echo
build/release/bin/motion_functions
