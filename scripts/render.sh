#!/usr/bin/env bash
# The main job, on a bare Debian or Ubuntu too: installs what is missing, builds what is
# out of date, then runs `twrench render` with the arguments given (none: the default film).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/scripts/setup.sh" render
"$root/scripts/build.sh" release twrench
exec "$root/build/release/bin/twrench" render "$@"
