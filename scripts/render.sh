#!/usr/bin/env bash
# The main command, which also works on a bare Debian or Ubuntu: installs missing dependencies, builds
# the program if it is out of date, then runs `twrench render` with the given arguments (default: the
# default scene). The program can write pages, unless it was first built where their packages are missing.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/scripts/maintain/setup.sh" render
if [[ ! -x $root/build/release/bin/twrench || -e $root/build/page/page.html ]]; then
  "$root/scripts/maintain/page.sh" || echo "twrench: note: the program is built without its pages, for the reason above" >&2
fi
"$root/scripts/maintain/build.sh" release twrench
exec "$root/build/release/bin/twrench" render "$@"
